// must print: law: linear must be static constexpr bool
// A law that says by a function that it is linear.
#include <arenite/arenite.hpp>

using namespace arenite;

struct Wrong : LinearElastic {
  bool linear() const { return true; }
};

int main() {
  const Wrong law{LinearElastic{{.density = 1, .young = 1, .poisson = 0}}};
  Scene scene{PlaneStrain{}, CartesianGrid<2>({.lower = {0, 0}, .upper = {1, 1}, .cell = 0.5}),
              Numerics<QuadraticBSpline>{}, bodies(fill(Box{{0., 0.}, {1., 1.}}, law))};
}
