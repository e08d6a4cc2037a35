// Friction by the inertial number, mu(I): dense flows of grains.
#pragma once
// SPDX-License-Identifier: BSD-3-Clause

#include <algorithm>
#include <cmath>

#include <arenite/law/frictional/friction.hpp>
#include <arenite/law/frictional/shear_rate.hpp>

namespace arenite::inline ARENITE_INSTRUCTION_SET {

/// tan(phi) = mu_s + rise / (I_0 / I + 1), I = rate d / sqrt(p / rho_s), with mu_s = tan(phi) of the law's
/// parameters and rise = mu_2 - mu_s. Jop, Forterre & Pouliquen (2006), A constitutive law for dense granular
/// flows, Nature 441, 727-730.
///
/// p is the mean stress of the end of the step, pressure positive: that of the start would lag, and
/// would be 0 at the first contact of matter. Without dilatancy plastic flow leaves the mean stress
/// of the elastic trial state. With it, and with a cut-off, the return raises the pressure and mu falls; the
/// two are found together by secants between bounds (fixed_point.hpp), each point on its own, until mu of the
/// surface and mu(I) of the pressure differ by at most 128 units in the last place of 1 + mu. With cohesion
/// and a pressure so small that its round-off moves mu(I) more than that, mu is at least mu(I), which is the
/// weaker side there. Where p <= 0 I is infinite, and the friction mu_2; without rate it is mu_s.
///
/// The law is local: it gives no length, and as a flow law it is ill-posed at low and at high I (Barker,
/// Schaeffer, Bohorquez & Gray 2015, J. Fluid Mech. 779, 794-818). mu is tan(phi) here; Jop's own law
/// sqrt(J2) = mu p is the cone of Drucker-Prager whose eta is mu.
class InertialFriction {
 public:
  template <class T>
  using History = ShearRateHistory<T>;

  /// Defaults: glass beads of the paper (mu_2 - mu_s = 0.643 - 0.382, d = 0.53 mm).
  struct Parameters {
    double rise = 0.261;               ///< mu_2 - mu_s, -, >= 0; 0: the friction of the law's parameters
    double reference_inertia = 0.279;  ///< I_0, -, positive
    double grain_size = 0.53e-3;       ///< d, m, positive
    double grain_density = 2450;       ///< rho_s, kg/m3, positive
    double smoothing = 0;              ///< time over which the rate is smoothed, s, >= 0; 0: none
  };

  InertialFriction() : InertialFriction(Parameters{}) {}
  explicit InertialFriction(const Parameters& p)
      : rise_(p.rise),
        reference_(p.reference_inertia),
        grain_(p.grain_size * std::sqrt(p.grain_density)),
        filter_("InertialFriction", p.smoothing) {
    const auto check = [](bool holds, const char* name, double value, const char* rule) {
      detail::check(holds && std::isfinite(value), "InertialFriction", name, value, rule);
    };
    check(p.rise >= 0, "rise", p.rise, "must not be negative");
    check(p.reference_inertia > 0, "reference_inertia", p.reference_inertia, "must be positive");
    check(p.grain_size > 0, "grain_size", p.grain_size, "must be positive (m)");
    check(p.grain_density > 0, "grain_density", p.grain_density, "must be positive (kg/m3)");
  }

  bool constant() const { return rise_ == 0; }
  bool implicit() const { return true; }

  template <class T, int D>
  void follow(const StrainStep<T, D>& step, History<T>& history) const {
    filter_.update(step, history);
  }
  double least_slope(const GivenAngles& given) const { return given.slope; }

  template <class T, int D>
  T slope(const GivenAngles& given, const StrainStep<T, D>&, const Sym<T, D>& stress,
          const History<T>& history) const {
    using std::max, std::sqrt;
    const T flowing = history.shear_rate * T(grain_);  // I sqrt(p), as p may be 0
    const T pressure = max(T(trace(stress) * T(-1.0 / 3)), T(0));
    const T sum = T(reference_) * sqrt(pressure) + flowing;
    return T(given.slope) + T(rise_) * flowing / max(sum, T(1e-30));
  }

 private:
  double rise_, reference_;  // -
  double grain_;             // d sqrt(rho_s), (kg/m)^(1/2)
  RateFilter filter_;
};

}  // namespace arenite::inline ARENITE_INSTRUCTION_SET
