// must print: elastic_energy(stress) or elastic_energy(stress, history)
// A law whose energy takes only its history.
#include <arenite/arenite.hpp>

using namespace arenite;

struct Wrong : LinearElastic {
  template <class T>
  T elastic_energy(const NoHistory<T>&) const {
    return T(0);
  }
};

int main() {
  const Wrong law{LinearElastic{{.density = 1, .young = 1, .poisson = 0}}};
  Scene scene{PlaneStrain{}, CartesianGrid<2>({.lower = {0, 0}, .upper = {1, 1}, .cell = 0.5}),
              Numerics<QuadraticBSpline>{}, bodies(fill(Box{{0., 0.}, {1., 1.}}, law))};
}
