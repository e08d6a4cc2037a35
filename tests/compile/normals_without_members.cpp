// must print: Coulomb: the normals lack a member:
// errors: 1
// Normals of a user's own that are none.
#include <arenite/arenite.hpp>

using namespace arenite;

const LinearElastic steel{{.density = 7800, .young = 2e11, .poisson = 0.3}};

struct Upwards {};

int main() {
  Scene scene{PlaneStrain{}, CartesianGrid<2>({.lower = {0, 0}, .upper = {1, 1}, .cell = 0.5}),
              Numerics<QuadraticBSpline>{},
              bodies(fill(Box{{0., 0.}, {1., .5}}, steel), fill(Box{{0., .5}, {1., 1.}}, steel)),
              Coulomb(Friction(0.1), Upwards{})};
  run(scene, {.end = 1});
}
