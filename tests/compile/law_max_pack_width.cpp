// must print: law: max_pack_width must be static constexpr int, and positive
// A law whose width is no constant.
#include <arenite/arenite.hpp>

using namespace arenite;

struct Wrong : LinearElastic {
  int max_pack_width = 1;
};

int main() {
  const Wrong law{LinearElastic{{.density = 1, .young = 1, .poisson = 0}}};
  Scene scene{PlaneStrain{}, CartesianGrid<2>({.lower = {0, 0}, .upper = {1, 1}, .cell = 0.5}),
              Numerics<QuadraticBSpline>{}, bodies(fill(Box{{0., 0.}, {1., 1.}}, law))};
}
