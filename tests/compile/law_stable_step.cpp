// must print: law: stable_step must be double stable_step(double h) const
// A law whose limit on the step takes no length.
#include <arenite/arenite.hpp>

using namespace arenite;

struct Wrong : LinearElastic {
  double stable_step() const { return 1; }
};

int main() {
  const Wrong law{LinearElastic{{.density = 1, .young = 1, .poisson = 0}}};
  Scene scene{PlaneStrain{}, CartesianGrid<2>({.lower = {0, 0}, .upper = {1, 1}, .cell = 0.5}),
              Numerics<QuadraticBSpline>{}, bodies(fill(Box{{0., 0.}, {1., 1.}}, law))};
}
