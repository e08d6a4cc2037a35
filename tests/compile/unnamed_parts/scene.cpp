// A scene that names no optional part: the symbols of its program are searched for those of all of them.
#include <arenite/arenite.hpp>

int main() {
  using namespace arenite;
  Scene scene{PlaneStrain{}, CartesianGrid<2>{{.lower = {0, 0}, .upper = {1, 1}, .cell = 0.25}},
              Numerics<QuadraticBSpline>{},
              bodies(fill(Box{{0, 0}, {1, 0.5}},
                          LinearElastic{{.density = 1000, .young = 1e6, .poisson = 0.3}}, {.per_cell = 4}))};
  for (int k = 0; k < 3; ++k) step(scene, 0.5 * stable_step(scene));
}
