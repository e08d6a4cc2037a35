// must print: Scene: two bodies have one name
// The second of them could not be reached by its name.
#include <arenite/arenite.hpp>

using namespace arenite;

const LinearElastic rubber{{.density = 1, .young = 1, .poisson = 0}};

int main() {
  Scene scene{PlaneStrain{}, CartesianGrid<2>({.lower = {0, 0}, .upper = {1, 1}, .cell = 0.5}),
              Numerics<QuadraticBSpline>{},
              bodies(fill<"block">(Box{{0., 0.}, {1., 0.5}}, rubber),
                     fill<"block">(Box{{0., 0.5}, {1., 1.}}, rubber))};
  run(scene, {.end = 1});
}
