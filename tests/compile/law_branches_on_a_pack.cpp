// must print: a pack: its lanes may differ in a comparison: use select(
// errors: 1
// A law with an `if` on its scalars.
#include <arenite/arenite.hpp>

using namespace arenite;

struct Bilinear : LinearElastic {
  template <class T, int D>
  T update(Sym<T, D>& stress, const StrainStep<T, D>& step, NoHistory<T>& history) const {
    if (trace(stress) > T(0)) return T(0);
    return LinearElastic::update(stress, step, history);
  }
};

const Bilinear law{LinearElastic{{.density = 1, .young = 1, .poisson = 0}}};

int main() {
  Scene scene{PlaneStrain{}, CartesianGrid<2>({.lower = {0, 0}, .upper = {1, 1}, .cell = 0.5}),
              Numerics<QuadraticBSpline>{}, bodies(fill(Box{{0., 0.}, {1., 1.}}, law))};
  run(scene, {.end = 1});
}
