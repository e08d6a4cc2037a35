// must print: law: yield must be yield(stress) const or yield(stress, history) const
// A law whose yield takes no stress.
#include <arenite/arenite.hpp>

using namespace arenite;

struct Wrong : LinearElastic {
  double yield() const { return 0; }
};

int main() {
  const Wrong law{LinearElastic{{.density = 1, .young = 1, .poisson = 0}}};
  Scene scene{PlaneStrain{}, CartesianGrid<2>({.lower = {0, 0}, .upper = {1, 1}, .cell = 0.5}),
              Numerics<QuadraticBSpline>{}, bodies(fill(Box{{0., 0.}, {1., 1.}}, law))};
}
