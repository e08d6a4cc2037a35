// Friction that grows in proportion to the shear rate: a length scale for bands of shear.
#pragma once
// SPDX-License-Identifier: BSD-3-Clause

#include <cmath>

#include <arenite/law/frictional/shear_rate.hpp>

namespace arenite::inline ARENITE_INSTRUCTION_SET {

/// tan(phi) = tan(phi_0) + time * rate, with phi_0 of the law's parameters and rate = sqrt(2 e:e) of the
/// deviatoric strain rate e, smoothed.
///
/// The time is a regulariser, not a property of sand. Perfectly plastic friction has no length, so that its
/// bands of shear are as thin as cells are; with this term momentum diffuses across them by time * p/rho,
/// m2/s, and answers converge with the mesh. 1e-3 s is some 13 times what the mu(I) rheology gives sand of
/// 0.5 mm. Unlike a constant relaxation time (Perzyna, Duvaut-Lions) it adds no strength without pressure.
class LinearRateFriction {
 public:
  template <class T>
  using History = ShearRateHistory<T>;

  struct Parameters {
    double time = 1e-3;    ///< s, >= 0; 0: the friction of the law's parameters
    double smoothing = 0;  ///< time over which the rate is smoothed, s, >= 0; 0: none
  };

  LinearRateFriction() : LinearRateFriction(Parameters{}) {}
  explicit LinearRateFriction(const Parameters& p)
      : time_(p.time), filter_("LinearRateFriction", p.smoothing) {
    detail::check(p.time >= 0 && std::isfinite(p.time), "LinearRateFriction", "time", p.time,
                  "must not be negative (s)");
  }

  bool constant() const { return time_ == 0; }

  template <class T, int D>
  void follow(const StrainStep<T, D>& step, History<T>& history) const {
    filter_.update(step, history);
  }
  template <class T, int D>
  T slope(double given, const StrainStep<T, D>&, const History<T>& history) const {
    return T(given) + T(time_) * history.shear_rate;
  }

 private:
  double time_;  // s
  RateFilter filter_;
};

}  // namespace arenite::inline ARENITE_INSTRUCTION_SET
