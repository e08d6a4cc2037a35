// must print: law: wave_modulus in a given state must be wave_modulus(stress, history) const
// A law whose stiffness in a given state takes its arguments in another order.
#include <arenite/arenite.hpp>

using namespace arenite;

struct Wrong : LinearElastic {
  using LinearElastic::wave_modulus;
  template <class T, int D>
  T wave_modulus(const NoHistory<T>&, const Sym<T, D>&) const {
    return T(1);
  }
};

int main() {
  const Wrong law{LinearElastic{{.density = 1, .young = 1, .poisson = 0}}};
  Scene scene{PlaneStrain{}, CartesianGrid<2>({.lower = {0, 0}, .upper = {1, 1}, .cell = 0.5}),
              Numerics<QuadraticBSpline>{}, bodies(fill(Box{{0., 0.}, {1., 1.}}, law))};
}
