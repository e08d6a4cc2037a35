// Periodic grid: a grid with some axes closed to a ring. Matter that leaves on one side enters on the other.
#pragma once
// SPDX-License-Identifier: BSD-3-Clause

#include <cmath>
#include <utility>

#include <arenite/mesh/cartesian_grid.hpp>

namespace arenite::inline ARENITE_INSTRUCTION_SET {

/// `Axes`: a bit for each periodic axis. Along it the functions of the last cells are those of the first
/// ones, the same as in the middle of the grid, so that a scene has no end; there is no face, and no
/// wall may be named there. Positions stay in the box: a point that leaves comes back by whole periods.
template <class Grid, int Axes>
class PeriodicGrid : public Grid {
 public:
  using Point = typename Grid::Point;
  using typename Grid::scalar;
  static constexpr int periodic_axes = Axes;
  static_assert(
      requires(const Grid g) { g.edge(); }, "periodic: the cells of a grid must be equal: CartesianGrid");
  static_assert(Axes > 0 && Axes < (1 << Grid::dimension), "periodic: must name axes of the grid");

  explicit PeriodicGrid(Grid grid) : Grid{std::move(grid)} {}

  /// Period along an axis, m.
  scalar period(int axis) const { return this->edge() * static_cast<scalar>(this->cells(axis)); }

  /// x, or the same place within the box.
  Point wrapped(Point x) const {
    for (int k = 0; k < Grid::dimension; ++k) {
      if (((Axes >> k) & 1) == 0) continue;
      const scalar turns = std::floor((x[k] - this->lower()[k]) / period(k));
      if (turns != 0) x[k] -= turns * period(k);
    }
    return x;
  }
};

/// `periodic<0>(CartesianGrid<2>{..})`, `periodic<0, 2>(..)`: the axes that are closed, 0 for x.
template <int... Axes, class Grid>
PeriodicGrid<Grid, (0 | ... | (1 << Axes))> periodic(Grid grid) {
  return PeriodicGrid<Grid, (0 | ... | (1 << Axes))>(std::move(grid));
}

}  // namespace arenite::inline ARENITE_INSTRUCTION_SET
