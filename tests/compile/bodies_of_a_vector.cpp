// must print: bodies: the fills of a list have no names; they are numbered
// Named bodies that a program collects.
#include <arenite/arenite.hpp>

using namespace arenite;

const LinearElastic rubber{{.density = 1, .young = 1, .poisson = 0}};

int main() {
  std::vector fills{fill<"lower">(Box{{0., 0.}, {1., 0.5}}, rubber)};
  Scene scene{PlaneStrain{}, CartesianGrid<2>({.lower = {0, 0}, .upper = {1, 1}, .cell = 0.5}),
              Numerics<QuadraticBSpline>{}, bodies(fills)};
  run(scene, {.end = 1});
}
