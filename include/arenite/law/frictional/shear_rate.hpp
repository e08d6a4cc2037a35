// Shear rate of a point, smoothed over a given time: what friction and stiffness that depend on the rate
// share.
#pragma once
// SPDX-License-Identifier: BSD-3-Clause

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <string_view>
#include <tuple>

#include <arenite/law/elasticity.hpp>
#include <arenite/law/law.hpp>
#include <arenite/simd/elementary.hpp>

namespace arenite::inline ARENITE_INSTRUCTION_SET {

/// sqrt(2 e:e) of the deviatoric strain rate e, 1/s: in simple shear the rate of the angle gamma. 0 where no
/// time passes.
template <class T, int D>
T shear_rate(const StrainStep<T, D>& step) {
  using std::sqrt;
  const Sym<T, D> e = deviator(step.strain);
  return sqrt(T(T(2) * contract(e, e))) * T(step.per_time());
}

/// History of a policy that depends on the shear rate.
template <class T>
struct ShearRateHistory {
  T shear_rate{0};  ///< smoothed, 1/s
  static constexpr std::array names{"shear_rate"};
  constexpr auto members() { return std::tie(shear_rate); }
  constexpr auto members() const { return std::tie(shear_rate); }
};

/// Exponential filter of the shear rate: in a step of dt the smoothed rate r moves towards that of the step
/// by 1 - exp(-dt/time) of their difference, however long the step.
class RateFilter {
 public:
  /// `time` [s]: 0 takes the rate of each step as it is. `policy` is the name that an error message shows.
  RateFilter(std::string_view policy, double time) : time_(time) {
    detail::check(time >= 0 && std::isfinite(time), policy, "smoothing", time, "must not be negative (s)");
  }

  double time() const { return time_; }  ///< s

  /// Takes a step into the smoothed rate of a history. A step without time leaves it.
  template <class T, int D>
  void update(const StrainStep<T, D>& step, ShearRateHistory<T>& history) const {
    if (!(step.dt > 0)) return;
    const T now = shear_rate(step);
    history.shear_rate =
        time_ > 0 ? T(history.shear_rate + (now - history.shear_rate) * T(1 - std::exp(-step.dt / time_)))
                  : now;
  }

 private:
  double time_;
};

/// Throws `error` unless a reference rate, 1/s, is one whose reciprocal is a number in float, too.
inline void check_reference_rate(std::string_view policy, double rate) {
  detail::check(rate >= 1e-30 && rate <= 1e30, policy, "reference_rate", rate, "must be positive (1/s)");
}

/// Decades by which a rate exceeds the reference, log10(rate / reference); 0 below it.
template <class T>
T decades_above(const T& rate, double reference) {
  using std::max;
  return lane_log(T(max(T(rate * T(1 / reference)), T(1)))) * T(1 / std::numbers::ln10);
}

}  // namespace arenite::inline ARENITE_INSTRUCTION_SET
