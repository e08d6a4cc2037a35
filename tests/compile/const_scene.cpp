// must print: run: the scene is stepped in place: it must be a variable that is not const
// errors: 2
// A scene that cannot change, and one that nothing names.
#include <arenite/arenite.hpp>

using namespace arenite;

const LinearElastic rubber{{.density = 1, .young = 1, .poisson = 0}};

int main() {
  const Scene scene{PlaneStrain{}, CartesianGrid<2>({.lower = {0, 0}, .upper = {1, 1}, .cell = 0.5}),
                    Numerics<QuadraticBSpline>{}, bodies(fill(Box{{0., 0.}, {1., 1.}}, rubber))};
  run(scene, {.end = 1});
  step(Scene(scene), 1e-3);
}
