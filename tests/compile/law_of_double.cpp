// must print: law: update must take packs of points, not double alone
// A law that was written for one point in double.
#include <arenite/arenite.hpp>

using namespace arenite;

struct Spring {
  template <class T>
  using History = NoHistory<T>;
  double density() const { return 1; }
  double wave_modulus() const { return 1; }
  double update(Sym<double, 2>& stress, const StrainStep<double, 2>& step, NoHistory<double>&) const {
    stress = stress + step.strain;
    return 0;
  }
  double elastic_energy(const Sym<double, 2>&) const { return 0; }
};

int main() {
  Scene scene{PlaneStrain{}, CartesianGrid<2>({.lower = {0, 0}, .upper = {1, 1}, .cell = 0.5}),
              Numerics<QuadraticBSpline>{}, bodies(fill(Box{{0., 0.}, {1., 1.}}, Spring{}))};
  run(scene, {.end = 1});
}
