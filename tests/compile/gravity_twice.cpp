// must print: Scene: gravity, contact of bodies, motion of the mesh and TrackEnergy may be given once each
// Twice the weight, or one too many.
#include <arenite/arenite.hpp>

using namespace arenite;

const LinearElastic rubber{{.density = 1, .young = 1, .poisson = 0}};

int main() {
  Scene scene{PlaneStrain{},
              CartesianGrid<2>({.lower = {0, 0}, .upper = {1, 1}, .cell = 0.5}),
              Numerics<QuadraticBSpline>{},
              bodies(fill(Box{{0., 0.}, {1., 1.}}, rubber)),
              gravity({0, -9.81}),
              gravity({0, -9.81}, Ramp{.over = 1})};
}
