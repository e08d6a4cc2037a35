// Friction that grows with the logarithm of the shear rate.
#pragma once
// SPDX-License-Identifier: BSD-3-Clause

#include <algorithm>
#include <cmath>

#include <arenite/law/frictional/friction.hpp>
#include <arenite/law/frictional/shear_rate.hpp>

namespace arenite::inline ARENITE_INSTRUCTION_SET {

/// phi = phi_p (1 + a log10(rate / reference)) with phi_p of the law's parameters. Zambrano-Cruzatty & Yerro
/// (2020), Numerical simulation of a free fall penetrometer deployment using the material point method, Soils
/// and Foundations 60, 668-682. Below the reference rate it is phi_p: the formula would go to minus infinity
/// at rest. It ends at 1.55 rad.
class LogarithmicFriction {
 public:
  template <class T>
  using History = ShearRateHistory<T>;

  /// Defaults: sample input of the paper's code, not calibrated to a sand.
  struct Parameters {
    double per_decade = 0.027;       ///< a, -, >= 0; 0: the friction of the law's parameters
    double reference_rate = 2.1e-5;  ///< 1/s, positive
    double smoothing = 0;            ///< time over which the rate is smoothed, s, >= 0; 0: none
  };

  LogarithmicFriction() : LogarithmicFriction(Parameters{}) {}
  explicit LogarithmicFriction(const Parameters& p)
      : per_decade_(p.per_decade), reference_(p.reference_rate), filter_("LogarithmicFriction", p.smoothing) {
    detail::check(p.per_decade >= 0 && std::isfinite(p.per_decade), "LogarithmicFriction", "per_decade",
                  p.per_decade, "must not be negative");
    check_reference_rate("LogarithmicFriction", p.reference_rate);
  }

  bool constant() const { return per_decade_ == 0; }

  template <class T, int D>
  void follow(const StrainStep<T, D>& step, History<T>& history) const {
    filter_.update(step, history);
  }
  double least_slope(const GivenAngles& given) const { return given.slope; }

  template <class T, int D>
  T slope(const GivenAngles& given, const StrainStep<T, D>&, const Sym<T, D>&,
          const History<T>& history) const {
    using std::min;
    const T decades = decades_above(history.shear_rate, reference_);
    const T angle = T(given.friction) + T(given.friction * per_decade_) * decades;
    return lane_tan(T(min(angle, T(detail::greatest_friction))));
  }

 private:
  double per_decade_, reference_;  // -; 1/s
  RateFilter filter_;
};

}  // namespace arenite::inline ARENITE_INSTRUCTION_SET
