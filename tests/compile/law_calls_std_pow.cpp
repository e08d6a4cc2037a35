// must print: a pack: the functions of std take one number: say using std::pow
// errors: 1
// A law that calls functions of <cmath> by their full names.
#include <arenite/arenite.hpp>

using namespace arenite;

struct Hardening : LinearElastic {
  template <class T, int D>
  T update(Sym<T, D>& stress, const StrainStep<T, D>& step, NoHistory<T>& history) const {
    const T opening = LinearElastic::update(stress, step, history);
    stress = stress * std::pow(T(1) - trace(step.strain), T(0.5));
    return opening;
  }
};

const Hardening law{LinearElastic{{.density = 1, .young = 1, .poisson = 0}}};

int main() {
  Scene scene{PlaneStrain{}, CartesianGrid<2>({.lower = {0, 0}, .upper = {1, 1}, .cell = 0.5}),
              Numerics<QuadraticBSpline>{}, bodies(fill(Box{{0., 0.}, {1., 1.}}, law))};
  run(scene, {.end = 1});
}
