// The section of a parabolic tip, and the curves parallel to it.
#pragma once

#include <algorithm>
#include <cmath>

namespace arenite::ffp {

/// The curve at a distance `offset` outside of the parabola r^2 = `k` y (m; inside if negative), from the
/// axis outward. A place on it is named by the radius p of the parabola's own point there, m. Further inside
/// than the vertex's radius of curvature, k / 2, the curve starts with a corner on the axis.
class ParallelParabola {
 public:
  explicit ParallelParabola(double k, double offset = 0) : k_{k}, offset_{offset} {
    const double ratio = -2 * offset / k;
    start_ = ratio > 1 ? k / 2 * std::sqrt(ratio * ratio - 1) : 0;
  }

  /// Where the curve starts on the axis.
  double start() const { return start_; }
  double radius(double p) const { return p + offset_ * slope(p) / length(p); }
  double height(double p) const { return p * p / k_ - offset_ / length(p); }
  /// Share of a piece of the curve that rises: dy / ds.
  double rise(double p) const { return slope(p) / length(p); }

  /// The place at a radius, m, at least 0.
  double at_radius(double r) const {
    if (offset_ == 0) return r;
    return found(std::max(std::min(r, r - offset_), start_), std::max({r, r - offset_, start_}),
                 [&](double p) { return radius(p) < r; });
  }
  /// The place at a height, m, at least that of the start.
  double at_height(double y) const {
    if (offset_ == 0) return std::sqrt(k_ * y);
    return found(start_, std::sqrt(k_ * std::max(0.0, y + std::abs(offset_))) + start_,
                 [&](double p) { return height(p) < y; });
  }

 private:
  double slope(double p) const { return 2 * p / k_; }
  double length(double p) const { return std::hypot(1, slope(p)); }

  /// Bisects [low, high], which grow along the curve, until they coincide.
  template <class Before>
  static double found(double low, double high, Before&& before) {
    for (int i = 0; i < 80; ++i) {
      const double middle = (low + high) / 2;
      (before(middle) ? low : high) = middle;
    }
    return high;
  }

  double k_, offset_, start_ = 0;
};

}  // namespace arenite::ffp
