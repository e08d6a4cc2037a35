// A law of your own: a struct with six members is all that a scene asks for. Here a Kelvin-Voigt solid, whose
// viscous stress must not be mistaken for an elastic one, so that it keeps the elastic part as history.
#include <arenite/arenite.hpp>
#include <cstdio>
using namespace arenite;

class KelvinVoigt {
 public:
  // History: scalars with a tie of them; each becomes a column.
  template <class T>
  struct History {
    T pressure{};  // elastic part of the mean stress, Pa
    auto members() { return std::tie(pressure); }
    auto members() const { return std::tie(pressure); }
  };

  KelvinVoigt(double density, double bulk, double relaxation)
      : density_{density}, bulk_{bulk}, relaxation_{relaxation} {}

  double density() const { return density_; }
  double wave_modulus() const { return bulk_; }

  template <class T, int D>
  T update(Sym<T, D>& stress, const Increment<T, D>& step, History<T>& history) const {
    const T change = T(bulk_) * trace(step.strain);
    history.pressure = history.pressure + change;
    stress = add_isotropic(Sym<T, D>{}, T(history.pressure + T(relaxation_) * change));
    return T(0);  // nothing separates
  }

  template <class T, int D>
  T elastic_energy(const Sym<T, D>& stress) const {
    const T mean = trace(stress) * T(1.0 / 3);
    return mean * mean * T(0.5 / bulk_);
  }

 private:
  double density_, bulk_, relaxation_;
};

int main() {
  Scene scene{PlaneStrain{},
              CartesianGrid<2>{{.lower = {0, 0}, .upper = {0.2, 0.2}, .cell = 0.02}},
              Numerics<QuadraticBSpline>{},
              bodies(fill(Box{{0, 0}, {0.1, 0.1}}, KelvinVoigt(1000, 2e5, 0.5), {.per_cell = 4})),
              walls(left(roller), right(roller), bottom(roller)),
              gravity({0, -9.81})};
  run(scene, {.end = 0.2, .courant = 0.3});
  double top = 0;
  for (const auto& x : std::get<0>(scene.bodies).points.position) top = std::max(top, x[1]);
  std::printf("the surface stands at %.4f m\n", top);
}
