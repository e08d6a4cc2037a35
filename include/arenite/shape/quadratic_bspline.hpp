// Quadratic B-splines on a Cartesian grid, with open knots: the functions of the cells at the boundary are
// changed so that unity and linear fields are reproduced up to the faces, and only the nodes on a face have a
// value there.
#pragma once
// SPDX-License-Identifier: BSD-3-Clause

#include <algorithm>

#include <arenite/shape/product_shape.hpp>

namespace arenite::inline ARENITE_INSTRUCTION_SET {

/// Functions along an axis of n cells on the knots 0, 0, 0, 1, 2, .., n, n, n. A node is placed at its
/// Greville abscissa, the mean of its function's two inner knots (0, 1/2, 3/2, .., n - 1/2, n), which is
/// where a coefficient must sit for linear fields to be reproduced (de Boor, A Practical Guide to Splines,
/// ch. IX; for MPM: Steffen, Kirby, Berzins 2008, doi:10.1002/nme.2360).
template <class T>
class QuadraticBSplineLine {
 public:
  static constexpr std::size_t nodes = 3;
  static constexpr Index cells_at_face = 1;
  /// 4 + (1 - 2 s)^2 / (1/2 + s - s^2) at the place s of a cell.
  static constexpr double steepness = 6;
  static constexpr double least_beside_face = 0.5;

  static constexpr T place(Index i, Index cells) {
    const auto knot = [cells](Index j) { return static_cast<T>(j <= 2 ? 0 : std::min(j - 2, cells)); };
    return (knot(i + 1) + knot(i + 2)) / 2;
  }
  template <grid_knots Knots>
  static T place(Index i, const Knots& knot) {
    return (knot(i, -1) + knot(i, 0)) / 2;
  }

  constexpr QuadraticBSplineLine(Index cell, Index cells)
      : before_{cell == 0 ? T(0) : T(1)},
        after_{cell + 1 == cells ? T(0) : T(1)},
        first_{1 / (1 + before_)},
        last_{1 / (1 + after_)} {}

  template <grid_knots Knots>
  QuadraticBSplineLine(Index cell, const Knots& knot) {
    const T edge = knot(cell, 1) - knot(cell, 0);
    before_ = (knot(cell, 0) - knot(cell, -1)) / edge;
    after_ = (knot(cell, 2) - knot(cell, 1)) / edge;
    first_ = 1 / (1 + before_);
    last_ = 1 / (1 + after_);
  }

  // By the recurrence of Cox and de Boor, written out for a cell [0, 1] whose neighbouring spans `before_`
  // and `after_` are 0 (at the boundary) or 1, or any on a rectilinear grid; `first_` and `last_` are 1 / (1
  // + span).
  template <class P>
  std::array<P, 3> values(const P& s) const {
    const P t = P(1) - s, low = t * P(first_), high = s * P(last_);
    // The middle one as a sum of what is not negative: 1 - the others would leave round-off at a face.
    return {t * low, (s + P(before_)) * low + (t + P(after_)) * high, s * high};
  }
  template <class P>
  std::array<P, 3> slopes(const P& s, T scale) const {
    const P low = (s - P(1)) * P(2 * first_ * scale), high = s * P(2 * last_ * scale);
    return {low, -(low + high), high};
  }
  T inverse_inertia() const { return before_ == 1 && after_ == 1 ? T(4) : T(0); }

 private:
  T before_, after_, first_, last_;
};

/// Quadratic B-splines on a grid.
///
/// Members: see `ProductShape`.
struct QuadraticBSpline : ProductShape<QuadraticBSplineLine> {
  static constexpr const char* name = "QuadraticBSpline";
};

}  // namespace arenite::inline ARENITE_INSTRUCTION_SET
