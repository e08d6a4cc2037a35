// must print: Body: the law must provide History, density(), wave_modulus(), update(stress, step, history)
// A law whose update takes a strain, not a step with its time.
#include <arenite/arenite.hpp>

using namespace arenite;

struct WithoutTime {
  template <class T>
  using History = NoHistory<T>;
  double density() const { return 1; }
  double wave_modulus() const { return 1; }
  template <class T, int D>
  T update(Sym<T, D>&, const Sym<T, D>&, History<T>&) const {
    return T(0);
  }
  template <class T, int D>
  T elastic_energy(const Sym<T, D>&) const {
    return T(0);
  }
};

int main() {
  Scene scene{PlaneStrain{}, CartesianGrid<2>({.lower = {0, 0}, .upper = {1, 1}, .cell = 0.5}),
              Numerics<QuadraticBSpline>{}, bodies(fill(Box{{0., 0.}, {1., 1.}}, WithoutTime{}))};
}
