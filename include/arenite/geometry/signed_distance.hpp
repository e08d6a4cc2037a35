// Signed distance of any type, as one value: the part of a `DistanceSurface` that a scene stores, so that its
// own type does not depend on the body's shape.
#pragma once
// SPDX-License-Identifier: BSD-3-Clause

#include <algorithm>
#include <array>
#include <functional>
#include <limits>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include <arenite/core/error.hpp>
#include <arenite/core/tensor.hpp>
#include <arenite/core/vector_argument.hpp>
#include <arenite/geometry/contact_segment.hpp>
#include <arenite/geometry/shape.hpp>

namespace arenite::inline ARENITE_INSTRUCTION_SET {

/// A signed distance whose type is not known; made by `AnyDistance::of<D>`. Positions are (x, y, z), z = 0 in
/// two dimensions.
class AnyDistance {
 public:
  using Position = std::array<double, 3>;

  template <int D, class F>
  static AnyDistance of(F distance) {
    AnyDistance any;
    any.set_bounds(bounds_of<D>(distance));
    if constexpr (has_contact_segments<F, D>)
      any.segments_ = [distance] { return contact_segments_of<D>(distance); };
    any.at_ = [f = std::move(distance)](std::span<const Position> x, double* out) {
      for (const Position& p : x) *out++ = f(in_scene<D>(p));
    };
    return any;
  }

  /// Distances at some positions: one call for a block of them.
  void at(std::span<const Position> x, double* out) const { at_(x, out); }
  /// Differences of the distance over the step h, m, to both sides of x along each axis, in one call: the
  /// gradient times 2 h. Along z of two dimensions 0, with D = 3, too.
  template <int D>
  Position differences(const Position& x, double h) const {
    std::array<Position, 2 * D> place;
    std::array<double, 2 * D> distance;
    place.fill(x);
    for (std::size_t k = 0; k < D; ++k) {
      place[2 * k][k] += h;
      place[2 * k + 1][k] -= h;
    }
    at(place, distance.data());
    Position g{};
    for (std::size_t k = 0; k < D; ++k) g[k] = distance[2 * k] - distance[2 * k + 1];
    return g;
  }
  /// Box around the body, m; infinite where nothing is known.
  template <int D>
  Box<std::size_t{D}> bounds() const {
    Box<std::size_t{D}> box;
    std::copy_n(lower_.begin(), D, box.lower.begin());
    std::copy_n(upper_.begin(), D, box.upper.begin());
    return box;
  }
  /// Its corners.
  const Position& lower() const { return lower_; }
  const Position& upper() const { return upper_; }
  /// Whether a position is farther from that box than `reach`, m.
  bool is_beyond(const Position& x, double reach = 0) const {
    for (std::size_t k = 0; k < x.size(); ++k)
      if (x[k] < lower_[k] - reach || x[k] > upper_[k] + reach) return true;
    return false;
  }
  /// Corners and edges of the shape; none where it offers none.
  std::vector<ContactSegment> contact_segments() const {
    return segments_ ? segments_() : std::vector<ContactSegment>{};
  }

 private:
  template <std::size_t D>
  void set_bounds(const Box<D>& box) {
    for (std::size_t k = 0; k < D; ++k) {
      lower_[k] = box.lower[k];
      upper_[k] = box.upper[k];
    }
  }

  static constexpr double infinite = std::numeric_limits<double>::infinity();
  std::function<void(std::span<const Position>, double*)> at_{};
  std::function<std::vector<ContactSegment>()> segments_{};
  Position lower_{-infinite, -infinite, -infinite}, upper_{infinite, infinite, infinite};
};

/// Message on a distance that is not a number, or not finite near the body.
inline std::string refused_distance(const AnyDistance::Position& x, double distance) {
  return joined_text({"DistanceSurface.distance at (", x[0], ", ", x[1], ", ", x[2],
                      ") m of the body's frame = ", distance,
                      ": must be a number, and finite near the body"});
}

}  // namespace arenite::inline ARENITE_INSTRUCTION_SET
