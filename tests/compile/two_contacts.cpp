// must print: Scene: gravity, contact of bodies, motion of the mesh and TrackEnergy may be given once each
// Only one contact algorithm acts between bodies.
#include <arenite/arenite.hpp>

using namespace arenite;

const LinearElastic steel{{.density = 7800, .young = 2e11, .poisson = 0.3}};

int main() {
  Scene scene{PlaneStrain{},
              CartesianGrid<2>({.lower = {0, 0}, .upper = {1, 1}, .cell = 0.5}),
              Numerics<QuadraticBSpline>{},
              bodies(fill(Box{{0., 0.}, {1., 1.}}, steel)),
              Coulomb(Friction(0.1)),
              OneField{}};
}
