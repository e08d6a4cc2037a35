// A law of your own: a class with five members is all that a scene asks for. Here a metal with linear
// hardening (von Mises), whose plastic strain is its history. Laws that know the time, and one whose
// stiffness depends on the state: extend/laws.
#pragma once

#include <arenite/arenite.hpp>

/// Rate-independent: stress depends on the path of the strain, not on the time or the number of steps that it
/// takes.
class HardeningMetal {
 public:
  // History: scalars with a tie of them; each becomes a column. Points begin with these values.
  template <class T>
  struct History {
    T plastic{0};  // equivalent plastic strain, -
    auto members() { return std::tie(plastic); }
    auto members() const { return std::tie(plastic); }
    static constexpr std::array names{"plastic"};
  };

  // Given by name in Python, and in C++ too.
  struct Parameters {
    double density = 0, young = 0, poisson = 0;  // kg/m3, Pa, -
    double strength = 0;                         // yield stress in uniaxial tension, Pa
    double hardening = 0;                        // what it gains with the plastic strain, Pa
  };
  explicit HardeningMetal(const Parameters& p)
      : elasticity_{"HardeningMetal", p.density, p.young, p.poisson},
        strength_{p.strength},
        hardening_{p.hardening} {}

  double density() const { return elasticity_.density(); }
  double wave_modulus() const { return elasticity_.wave_modulus(); }

  // T: a scalar or a pack of points, so that branches are written as `max` and `select`.
  template <class T, int D>
  T update(arenite::Sym<T, D>& stress, const arenite::StrainStep<T, D>& step, History<T>& history) const {
    using std::max, std::sqrt;
    const arenite::Sym<T, D> trial = turned(stress, step.spin) + elasticity_.stress(step.strain);
    const arenite::Sym<T, D> deviatoric = deviator(trial);
    const T equivalent = sqrt(T(1.5) * contract(deviatoric, deviatoric));
    const T excess = max(T(equivalent - T(strength_) - T(hardening_) * history.plastic), T(0));
    const T flow = excess * T(1 / (3 * elasticity_.shear() + hardening_));  // radial return
    stress = trial - deviatoric * T(T(3 * elasticity_.shear()) * flow / max(equivalent, T(1e-30)));
    history.plastic = history.plastic + flow;
    return T(0);  // nothing separates
  }

  template <class T, int D>
  T elastic_energy(const arenite::Sym<T, D>& stress) const {
    return elasticity_.energy(stress);
  }

 private:
  arenite::Elasticity elasticity_;
  double strength_, hardening_;
};
