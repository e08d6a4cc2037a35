// Cubic B-splines on a Cartesian grid, with open knots: smoother than quadratic ones, over four nodes along
// each axis. At the faces as those: unity and linear fields are reproduced, and only the nodes on a face have
// a value there.
#pragma once
// SPDX-License-Identifier: BSD-3-Clause

#include <algorithm>
#include <array>
#include <cstdint>

#include <arenite/shape/product_shape.hpp>

namespace arenite::inline ARENITE_INSTRUCTION_SET {

/// Functions along an axis of n cells on the knots 0, 0, 0, 0, 1, 2, .., n, n, n, n. A node is placed at its
/// Greville abscissa, the mean of its function's three inner knots: 0, 1/3, 1, 2, .., n - 1, n - 1/3, n.
template <class T>
class CubicBSplineLine {
 public:
  static constexpr std::size_t nodes = 4;
  static constexpr Index cells_at_face = 2;
  /// 3.14 away from the faces. A thin layer on a fixed face needs more: 9 of the node beside it, whose slope
  /// is 3, and 6 of the next one, 15 across the face and 3.14 along it; a free one 13.7 and 3.14.
  static constexpr double steepness = 10;
  static constexpr double least_beside_face = 1;

  static constexpr T place(Index i, Index cells) {
    return (knot(i, -2, cells) + knot(i, -1, cells) + knot(i, 0, cells)) / 3;
  }
  template <grid_knots Knots>
  static T place(Index i, const Knots& at) {
    return (at(i, -2) + at(i, -1) + at(i, 0)) / 3;
  }

  constexpr CubicBSplineLine(Index cell, Index cells) {
    for (int j = 0; j < 2; ++j) {
      before_[static_cast<std::size_t>(j)] = static_cast<T>(cell) - knot(cell, -1 - j, cells);
      after_[static_cast<std::size_t>(j)] = knot(cell, 2 + j, cells) - static_cast<T>(cell);
    }
    take_spans();
  }
  template <grid_knots Knots>
  CubicBSplineLine(Index cell, const Knots& at) {
    const T edge = at(cell, 1) - at(cell, 0);
    for (int j = 0; j < 2; ++j) {
      before_[static_cast<std::size_t>(j)] = (at(cell, 0) - at(cell, -1 - j)) / edge;
      after_[static_cast<std::size_t>(j)] = (at(cell, 2 + j) - at(cell, 0)) / edge;
    }
    take_spans();
  }

  // By the recurrence of Cox and de Boor from the quadratic functions of the cell [0, 1], whose knots outside
  // lie at -before_ and at after_. All terms are sums of what is not negative.
  template <class P>
  std::array<P, 4> values(const P& s) const {
    const auto q = quadratics(s);
    return {(P(1) - s) * q[0], (s + P(before_[1])) * q[0] + (P(after_[0]) - s) * q[1],
            (s + P(before_[0])) * q[1] + (P(after_[1]) - s) * q[2], s * q[2]};
  }
  template <class P>
  std::array<P, 4> slopes(const P& s, T scale) const {
    auto q = quadratics(s);
    for (P& value : q) value = value * P(3 * scale);
    return {-q[0], q[0] - q[1], q[1] - q[2], q[2]};
  }
  T inverse_inertia() const {
    return before_[0] == 1 && before_[1] == 2 && after_[0] == 2 && after_[1] == 3 ? T(3) : T(0);
  }

 private:
  constexpr void take_spans() {
    quadratic_ = {1 / (1 + before_[0]), 1 / after_[0]};
    cubic_ = {1 / (1 + before_[1]), 1 / (after_[0] + before_[0]), 1 / after_[1]};
  }

  static constexpr T knot(Index i, int shift, Index cells) {
    const auto at = static_cast<std::int64_t>(i) + shift;
    return static_cast<T>(std::clamp<std::int64_t>(at, 0, cells));
  }

  /// Quadratic functions over the lengths of their supports.
  template <class P>
  std::array<P, 3> quadratics(const P& s) const {
    const P t = P(1) - s, low = t * P(quadratic_[0]), high = s * P(quadratic_[1]);
    return {t * low * P(cubic_[0]), ((s + P(before_[0])) * low + (P(after_[0]) - s) * high) * P(cubic_[1]),
            s * high * P(cubic_[2])};
  }

  std::array<T, 2> before_{}, after_{};  // distances of the knots outside from the cell's lower end
  std::array<T, 2> quadratic_{};         // 1 / the support of the linear functions
  std::array<T, 3> cubic_{};             // 1 / the support of the quadratic functions
};

/// Cubic B-splines on a grid.
///
/// Members: see `ProductShape`.
struct CubicBSpline : ProductShape<CubicBSplineLine> {
  static constexpr const char* name = "CubicBSpline";
  static constexpr double bearing_spacing = 0.4;
};

}  // namespace arenite::inline ARENITE_INSTRUCTION_SET
