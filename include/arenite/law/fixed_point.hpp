// The fixed point of a function of one number, in each lane of a pack on its own: for what a return to the
// yield surface depends on and changes itself.
#pragma once
// SPDX-License-Identifier: BSD-3-Clause

#include <cmath>
#include <limits>

#include <arenite/core/scalar.hpp>

namespace arenite::inline ARENITE_INSTRUCTION_SET::detail {

/// x = f(x) between two bounds, of a continuous f that rises above x at the lower one and below it at the
/// upper one:
///
///   FixedPoint<T> x(first, low, high);
///   do value = f(x.at()); while (x.goes_on(value));
///
/// First x = f(x), then secants; the middle of the bounds where a secant leaves them or |f(x) - x| did not
/// halve. A lane ends at |f(x) - x| <= 128 units in the last place of 1 + x, or, where f jumps, at the least
/// number found for which f(x) < x. It stays there while others continue, so that its result does not
/// depend on them. The last f was that of `at()` in all lanes.
template <class T>
class FixedPoint {
 public:
  FixedPoint(const T& first, const T& low, const T& high) : at_(first), low_(low), high_(high) {}

  const T& at() const { return at_; }

  /// Receives f(at()); returns whether another value is needed.
  bool goes_on(const T& value) {
    using std::abs;
    const T f = value - at_;
    done_ = done_ || !(abs(f) > T(tolerance) * (T(1) + at_));
    if (!any_of(!done_) || ++count_ == most) return false;
    const auto above = f > T(0);
    low_ = select(above, at_, low_);
    high_ = select(above, high_, at_);
    const T middle = (low_ + high_) * T(0.5);
    const T next = count_ > 1 ? T(at_ - f * (at_ - before_) / (f - f_before_)) : value;
    auto good = next > low_ && next < high_;
    if (count_ > 2) good = good && abs(f) <= T(0.5) * abs(f_before_);
    const auto neighbours = !(middle > low_ && middle < high_);
    before_ = at_;
    f_before_ = f;
    at_ = select(done_, at_, select(neighbours, high_, select(good, next, middle)));
    done_ = done_ || neighbours;
    return true;
  }

 private:
  static constexpr double tolerance = 128 * static_cast<double>(std::numeric_limits<scalar_of<T>>::epsilon());
  static constexpr int most = 200;  // more than the halvings of bounds and values that a double allows

  T at_, low_, high_, before_{}, f_before_{};
  decltype(T(0) < T(0)) done_ = false;
  int count_ = 0;
};

}  // namespace arenite::inline ARENITE_INSTRUCTION_SET::detail
