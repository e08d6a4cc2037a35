// must print: law: one that returns Inelastic needs double greatest_volume_ratio() const
// A law whose matter dilates without a bound.
#include <arenite/arenite.hpp>

using namespace arenite;

struct Wrong : LinearElastic {
  template <class T, int D>
  Inelastic<T> update(Sym<T, D>&, const StrainStep<T, D>&, NoHistory<T>&) const {
    return {T(0), T(0)};
  }
};

int main() {
  const Wrong law{LinearElastic{{.density = 1, .young = 1, .poisson = 0}}};
  Scene scene{PlaneStrain{}, CartesianGrid<2>({.lower = {0, 0}, .upper = {1, 1}, .cell = 0.5}),
              Numerics<QuadraticBSpline>{}, bodies(fill(Box{{0., 0.}, {1., 1.}}, law))};
}
