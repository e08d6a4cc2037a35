// Window grid: a box of cells of a grid, with the functions, places and holders of the whole one.
#pragma once
// SPDX-License-Identifier: BSD-3-Clause

#include <array>
#include <cstddef>
#include <utility>

#include <arenite/core/error.hpp>
#include <arenite/mesh/cartesian_grid.hpp>

namespace arenite::inline ARENITE_INSTRUCTION_SET {

/// Cells and nodes of the window have their own numbers, axis 0 fastest; places along the axes, the lower corner and the upper one are
/// those of the whole grid, from which all lengths are computed. So an inner side of the window is no face, and points, weights and
/// nodes have the same bits as in the whole.
template <class Grid>
class WindowGrid : public Grid {
 public:
  static constexpr int D = Grid::dimension;
  static constexpr bool is_window = true;
  using Place = std::array<Index, static_cast<std::size_t>(D)>;
  using Point = typename Grid::Point;
  static_assert(
      !requires { Grid::periodic_axes; }, "window: a periodic grid cannot be cut");

  /// Throws `error` for a window that is empty, or not in the grid.
  WindowGrid(Grid grid, const Place& first, const Place& count)
      : Grid{std::move(grid)}, first_{first}, count_{count} {
    for (int k = 0; k < D; ++k)
      require(cells(k) > 0 && this->first(k) + cells(k) <= whole().cells(k), "window: cells", cells(k),
              {"must be at least one, and in the grid, along axis ", k});
  }

  const Grid& whole() const { return *this; }
  /// First cell along an axis, by its place in the whole; how many there are.
  Index first(int k) const { return first_[static_cast<std::size_t>(k)]; }
  Index cells(int k) const { return count_[static_cast<std::size_t>(k)]; }
  Index cell_count() const {
    Index n = 1;
    for (const Index c : count_) n *= c;
    return n;
  }
  /// Place of a cell along each axis of the whole.
  Place place(Index cell) const {
    Place at;
    for (std::size_t k = 0; k < at.size(); ++k) {
      at[k] = first_[k] + cell % count_[k];
      cell /= count_[k];
    }
    return at;
  }
  /// Number of a cell in the whole, and back: `none` outside of the window.
  Index whole_cell(Index cell) const {
    const auto at = place(cell);
    Index number = 0;
    for (std::size_t k = at.size(); k-- > 0;) number = number * whole().cells(static_cast<int>(k)) + at[k];
    return number;
  }
  Index cell_here(Index number) const {
    if (number == none) return none;
    const auto at = whole().place(number);
    Index cell = 0;
    for (std::size_t k = at.size(); k-- > 0;) {
      if (at[k] < first_[k] || at[k] >= first_[k] + count_[k]) return none;
      cell = cell * count_[k] + at[k] - first_[k];
    }
    return cell;
  }

  Point corner(Index cell) const { return whole().corner(whole_cell(cell)); }
  Point extent(Index cell) const { return whole().extent(whole_cell(cell)); }
  typename Grid::scalar size(Index cell) const { return whole().size(whole_cell(cell)); }
  typename Grid::scalar volume(Index cell) const { return whole().volume(whole_cell(cell)); }
  typename Grid::Holder holder(Index cell) const { return whole().holder(whole_cell(cell)); }
  Index walk(const Point& x, Index hint = none) const {
    return cell_here(whole().walk(x, hint == none ? none : whole_cell(hint)));
  }
  Index search(const Point& x) const { return walk(x); }

 private:
  Place first_, count_;
};

/// Whether M is a window of a larger grid.
template <class M>
inline constexpr bool is_window = requires {
  M::is_window;
};

/// Cells of the whole grid along an axis; the first one of a grid, or of a window of it.
template <class M>
Index whole_cells(const M& grid, int axis) {
  if constexpr (is_window<M>)
    return grid.whole().cells(axis);
  else
    return grid.cells(axis);
}
template <class M>
Index first_cell([[maybe_unused]] const M& grid, [[maybe_unused]] int axis) {
  if constexpr (is_window<M>)
    return grid.first(axis);
  else
    return 0;
}

}  // namespace arenite::inline ARENITE_INSTRUCTION_SET
