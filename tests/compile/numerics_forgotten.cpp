// must print: Scene: the third value must be the numerics
// errors: 1
// Bodies in the place of the numerics.
#include <arenite/arenite.hpp>

using namespace arenite;

const LinearElastic steel{{.density = 7800, .young = 2e11, .poisson = 0.3}};

int main() {
  Scene scene{PlaneStrain{}, CartesianGrid<2>({.lower = {0, 0}, .upper = {1, 1}, .cell = 0.5}),
              bodies(fill(Box{{0., 0.}, {1., 1.}}, steel))};
  run(scene, {.end = 1});
}
