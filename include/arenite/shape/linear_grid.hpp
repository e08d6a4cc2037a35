// Linear shape functions on a Cartesian grid: bilinear, trilinear. The least arithmetic; gradients jump from
// cell to cell.
#pragma once
// SPDX-License-Identifier: BSD-3-Clause

#include <limits>

#include <arenite/shape/product_shape.hpp>

namespace arenite::inline ARENITE_INSTRUCTION_SET {

/// Functions along an axis: hats, a node at each end of a cell. The gradient jumps where a point crosses into
/// another cell, an error that does not decrease with the cell size (Steffen, Kirby, Berzins 2008,
/// doi:10.1002/nme.2360).
template <class T>
struct LinearGridLine {
  static constexpr std::size_t nodes = 2;
  static constexpr double steepness = std::numeric_limits<double>::infinity();
  static constexpr double least_beside_face = 0;  // its light nodes are everywhere

  static T place(Index i, Index) { return static_cast<T>(i); }

  template <grid_knots Knots>
  static T place(Index i, const Knots& knot) {
    return knot(i, 0);
  }

  LinearGridLine(Index, Index) {}
  template <grid_knots Knots>
  LinearGridLine(Index, const Knots&) {}

  template <class P>
  std::array<P, 2> values(const P& s) const {
    return {P(1) - s, s};
  }
  template <class P>
  std::array<P, 2> slopes(const P&, T scale) const {
    return {P(-scale), P(scale)};
  }
  T inverse_inertia() const { return 0; }
};

/// Linear functions on a grid.
///
/// Members: see `ProductShape`.
struct LinearGrid : ProductShape<LinearGridLine> {
  /// Measured: docs/decisions.md.
  static constexpr double courant_limit(bool maps_back) { return maps_back ? 0.5 : 0.35; }
  static constexpr const char* name = "LinearGrid";
};

}  // namespace arenite::inline ARENITE_INSTRUCTION_SET
