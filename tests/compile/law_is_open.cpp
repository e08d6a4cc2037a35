// must print: law: is_open must be is_open(history) const
// A law that says by its stress whether it is open.
#include <arenite/arenite.hpp>

using namespace arenite;

struct Wrong : LinearElastic {
  template <class T, int D>
  bool is_open(const Sym<T, D>&) const {
    return false;
  }
};

int main() {
  const Wrong law{LinearElastic{{.density = 1, .young = 1, .poisson = 0}}};
  Scene scene{PlaneStrain{}, CartesianGrid<2>({.lower = {0, 0}, .upper = {1, 1}, .cell = 0.5}),
              Numerics<QuadraticBSpline>{}, bodies(fill(Box{{0., 0.}, {1., 1.}}, law))};
}
