// Box: a region, a signed distance, and the bounds of other shapes.
#pragma once
// SPDX-License-Identifier: BSD-3-Clause

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>

#include <arenite/core/error.hpp>
#include <arenite/core/tensor.hpp>

namespace arenite::inline ARENITE_INSTRUCTION_SET {

/// Axis-aligned box: lower <= x < upper, m.
template <std::size_t D>
struct Box {
  std::array<double, D> lower;
  std::array<double, D> upper;

  Box() = default;
  /// Throws `error` where upper lies below lower. (Bounds that code sets may be empty so.)
  Box(const std::array<double, D>& lower_corner, const std::array<double, D>& upper_corner)
      : lower{lower_corner}, upper{upper_corner} {
    for (std::size_t k = 0; k < D; ++k)
      require(upper[k] >= lower[k], {"Box.upper[", k, "]"}, upper[k],
              {"must not lie below lower[", k, "] = ", lower[k]});
  }
  bool contains(const Vec<double, static_cast<int>(D)>& x) const {
    for (std::size_t k = 0; k < D; ++k)
      if (!(x[static_cast<int>(k)] >= lower[k] && x[static_cast<int>(k)] < upper[k])) return false;
    return true;
  }
  template <int Other>
  bool contains(const Vec<double, Other>& x) const = delete;  // a box of another dimension

  /// Signed distance, m, exact outside and inside.
  double operator()(const Vec<double, static_cast<int>(D)>& x) const {
    double square_outside = 0, deepest = -std::numeric_limits<double>::infinity();
    for (std::size_t k = 0; k < D; ++k) {
      const double beyond = std::max(lower[k] - x[static_cast<int>(k)], x[static_cast<int>(k)] - upper[k]);
      deepest = std::max(deepest, beyond);
      if (beyond > 0) square_outside += beyond * beyond;
    }
    return deepest > 0 ? std::sqrt(square_outside) : deepest;
  }
  template <int Other>
  double operator()(const Vec<double, Other>& x) const = delete;

  Box bounds() const { return *this; }
};
template <std::size_t D>
Box(const double (&)[D], const double (&)[D]) -> Box<D>;

/// Box around rotation * x + shift of all x in a box, whose sides may lie at infinity.
template <int D>
Box<std::size_t{D}> moved_box(const Box<std::size_t{D}>& box, const Mat<double, D>& rotation,
                              const Vec<double, D>& shift) {
  Box<std::size_t{D}> moved;
  for (int i = 0; i < D; ++i) {
    double low = shift[i], high = shift[i];
    for (int k = 0; k < D; ++k) {
      if (rotation(i, k) == 0) continue;
      const double a = rotation(i, k) * box.lower[static_cast<std::size_t>(k)];
      const double b = rotation(i, k) * box.upper[static_cast<std::size_t>(k)];
      low += std::min(a, b);
      high += std::max(a, b);
    }
    moved.lower[static_cast<std::size_t>(i)] = low;
    moved.upper[static_cast<std::size_t>(i)] = high;
  }
  return moved;
}

}  // namespace arenite::inline ARENITE_INSTRUCTION_SET
