// must print: Scene: the first value must be the kinematics
// errors: 1
// The mesh comes second.
#include <arenite/arenite.hpp>

using namespace arenite;

const LinearElastic steel{{.density = 7800, .young = 2e11, .poisson = 0.3}};

int main() {
  Scene scene{CartesianGrid<2>({.lower = {0, 0}, .upper = {1, 1}, .cell = 0.5}), PlaneStrain{},
              Numerics<QuadraticBSpline>{}, bodies(fill(Box{{0., 0.}, {1., 1.}}, steel))};
  run(scene, {.end = 1});
}
