// must print: vtu: include <arenite/observe/vtu.hpp>
// errors: 1
// Observers that write files have their own headers.
#include <arenite/arenite.hpp>

using namespace arenite;

const LinearElastic steel{{.density = 7800, .young = 2e11, .poisson = 0.3}};

int main() {
  Scene scene{PlaneStrain{}, CartesianGrid<2>({.lower = {0, 0}, .upper = {1, 1}, .cell = 0.5}),
              Numerics<QuadraticBSpline>{}, bodies(fill(Box{{0., 0.}, {1., 1.}}, steel))};
  run(scene, {.end = 1}, every(0.1, vtu("out")));
}
