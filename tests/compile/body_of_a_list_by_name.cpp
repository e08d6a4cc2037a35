// must print: Scene: the bodies of a list are numbered at run time: say body(number)
// errors: 1
// A body of a list, accessed as one that has its own type.
#include <arenite/arenite.hpp>

using namespace arenite;

const LinearElastic rubber{{.density = 1, .young = 1, .poisson = 0}};

int main() {
  std::vector fills{fill(Box{{0., 0.}, {1., 0.5}}, rubber), fill(Box{{0., 0.5}, {1., 1.}}, rubber)};
  Scene scene{PlaneStrain{}, CartesianGrid<2>({.lower = {0, 0}, .upper = {1, 1}, .cell = 0.5}),
              Numerics<QuadraticBSpline>{}, bodies(fills)};
  return scene.body<1>().points.size() > 0;
}
