// must print: walls: each is a place with its condition: bottom(fixed)
// Faces of the mesh, which loads take, in place of walls.
#include <arenite/arenite.hpp>

using namespace arenite;

const LinearElastic rubber{{.density = 1, .young = 1, .poisson = 0}};

int main() {
  Scene scene{PlaneStrain{}, CartesianGrid<2>({.lower = {0, 0}, .upper = {1, 1}, .cell = 0.5}),
              Numerics<QuadraticBSpline>{}, bodies(fill(Box{{0., 0.}, {1., 1.}}, rubber)),
              walls(bottom(), left(roller))};
}
