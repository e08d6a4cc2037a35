// must print: Body: the law must provide History, density(), wave_modulus(), update(stress, step, history)
// A law that forgot its update.
#include <arenite/arenite.hpp>

using namespace arenite;

struct Forgetful {
  template <class T>
  using History = NoHistory<T>;
  double density() const { return 1; }
  double wave_modulus() const { return 1; }
};

int main() {
  Scene scene{PlaneStrain{}, CartesianGrid<2>({.lower = {0, 0}, .upper = {1, 1}, .cell = 0.5}),
              Numerics<QuadraticBSpline>{}, bodies(fill(Box{{0., 0.}, {1., 1.}}, Forgetful{}))};
}
