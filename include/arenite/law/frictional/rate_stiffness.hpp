// Stiffness that grows with the shear rate and falls with plastic shear, beside its growth with pressure.
#pragma once
// SPDX-License-Identifier: BSD-3-Clause

#include <cmath>

#include <arenite/law/frictional/rate_softening_friction.hpp>
#include <arenite/law/frictional/stiffness.hpp>

namespace arenite::inline ARENITE_INSTRUCTION_SET {

/// G = G_r + (G_p (1 + a log10(rate / reference)) - G_r) exp(-eta eps_p), times (p / p_ref)^n as in
/// `PressureStiffness`; G_p of the law's parameters. Below the reference rate the factor is 1. Rate and
/// plastic strain are those of the step before, which the friction policy keeps: `RateSofteningFriction`,
/// perhaps with factors of 0. Poisson's ratio stays, so that the bulk modulus follows G; the code of
/// Zambrano-Cruzatty & Yerro (2020) gives it its own factor (0.155).
///
/// Hypoelastic: sheared by tau while the factor is f_1 and back while it is f_2, the matter takes
/// tau^2 / (2 G_p) (1/f_1 - 1/f_2): it gives energy where the way out was the faster one. The elastic energy
/// is that of the present factor, and changes with it at a constant stress.
class RateStiffness {
 public:
  static constexpr bool reads_friction_history = true;
  template <class T>
  using History = RateSofteningFriction::History<T>;

  /// Defaults: sample input of the paper's code, not calibrated to a sand; no softening, no pressure.
  struct Parameters {
    double per_decade = 0.102;       ///< a, -, >= 0
    double reference_rate = 2.1e-5;  ///< 1/s, positive
    double residual = 1;             ///< G_r / G_p, -, in (0, 1]
    double decay = 0;                ///< eta, per unit of plastic strain, -, >= 0
    PressureStiffness::Parameters pressure{.exponent = 0};
  };

  RateStiffness() : RateStiffness(Parameters{}) {}
  explicit RateStiffness(const Parameters& p) : p_(p), pressure_(p.pressure) {
    const char* const name = "RateStiffness";
    detail::check(p.per_decade >= 0 && std::isfinite(p.per_decade), name, "per_decade", p.per_decade,
                  "must not be negative");
    check_reference_rate(name, p.reference_rate);
    detail::check(p.residual > 0 && p.residual <= 1, name, "residual", p.residual, "must lie in (0, 1]");
    detail::check(p.decay >= 0 && std::isfinite(p.decay), name, "decay", p.decay, "must not be negative");
  }

  template <class T, int D>
  T factor(const Sym<T, D>& stress, const History<T>& history) const {
    return pressure_.factor(stress, NoHistory<T>{}) * of_history(history);
  }
  template <class T, int D>
  T energy(const Elasticity& elasticity, const Sym<T, D>& stress, const History<T>& history) const {
    return pressure_.energy(elasticity, stress, NoHistory<T>{}) / of_history(history);
  }

 private:
  template <class T>
  T of_history(const History<T>& history) const {
    const T peak = T(1) + T(p_.per_decade) * decades_above(history.shear_rate, p_.reference_rate);
    const T left = lane_exp_minus(T(history.plastic_strain * T(p_.decay)));
    return T(p_.residual) + (peak - T(p_.residual)) * left;
  }

  Parameters p_;
  PressureStiffness pressure_;
};

}  // namespace arenite::inline ARENITE_INSTRUCTION_SET
