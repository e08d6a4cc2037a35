// Split grid: boxes of a grid's cells as portions of it.
#pragma once
// SPDX-License-Identifier: BSD-3-Clause

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include <arenite/core/error.hpp>
#include <arenite/mesh/portion.hpp>
#include <arenite/mesh/window_grid.hpp>

namespace arenite::inline ARENITE_INSTRUCTION_SET {

/// Cells of a grid from `first` up to, and without, `end` along each axis.
template <int D>
struct CellRange {
  std::array<Index, static_cast<std::size_t>(D)> first{}, end{};

  bool holds(const std::array<Index, static_cast<std::size_t>(D)>& at) const {
    for (std::size_t k = 0; k < at.size(); ++k)
      if (at[k] < first[k] || at[k] >= end[k]) return false;
    return true;
  }
  bool meets(const CellRange& other) const {
    for (std::size_t k = 0; k < first.size(); ++k)
      if (first[k] >= other.end[k] || other.first[k] >= end[k]) return false;
    return true;
  }
  /// With `layers` more layers on all sides, within the grid.
  CellRange grown(Index layers, const std::array<Index, static_cast<std::size_t>(D)>& cells) const {
    CellRange all;
    for (std::size_t k = 0; k < first.size(); ++k) {
      all.first[k] = first[k] > layers ? first[k] - layers : 0;
      all.end[k] = std::min(end[k] + layers, cells[k]);
    }
    return all;
  }
};

/// Part number `number` of a grid whose cells belong to boxes of them, which do not overlap and fill it: a window of the cells of one box
/// and of all that share a node of `Shape` with one of these. A node belongs to the least of the boxes with a cell at it.
template <class Shape, class Grid, int D = Grid::dimension>
std::pair<WindowGrid<Grid>, MeshPortion<D>> split_grid(const Grid& whole,
                                                       const std::vector<CellRange<D>>& boxes, int number) {
  using Place = std::array<Index, static_cast<std::size_t>(D)>;
  constexpr Index halo = Shape::halo;
  Place cells, count;
  for (std::size_t k = 0; k < cells.size(); ++k) cells[k] = whole.cells(static_cast<int>(k));
  const auto window = boxes[static_cast<std::size_t>(number)].grown(halo, cells);
  for (std::size_t k = 0; k < cells.size(); ++k) count[k] = window.end[k] - window.first[k];
  WindowGrid<Grid> grid(whole, window.first, count);
  MeshPortion<D> portion;
  portion.number = number;
  for (int k = 0; k < D; ++k) {
    portion.lower[k] = static_cast<double>(whole.lower()[k]);
    portion.upper[k] = static_cast<double>(whole.upper(k));
  }
  std::vector<int> close;  // boxes with cells at nodes of the window
  for (std::size_t b = 0; b < boxes.size(); ++b)
    if (boxes[b].meets(window.grown(halo, cells))) close.push_back(static_cast<int>(b));
  const auto least_of = [&](const CellRange<D>& range) {
    for (const int b : close)
      if (boxes[static_cast<std::size_t>(b)].meets(range)) return b;
    throw error("split_grid: the boxes do not fill the grid");
  };
  for (Index c = 0; c < grid.cell_count(); ++c) {
    const auto at = grid.place(c);
    auto behind = at;
    for (Index& b : behind) ++b;
    portion.owner.push_back(least_of({at, behind}));
    portion.whole_cell.push_back(grid.whole_cell(c));
  }
  for (Index i = 0; i < Shape::node_count(grid); ++i) {
    CellRange<D> around;
    std::uint64_t node = 0, stride = 1;
    Index rest = i;
    for (int k = 0; k < D; ++k) {
      const auto a = static_cast<std::size_t>(k);
      const Index on_axis = Shape::node_count(grid, k), at = grid.first(k) + rest % on_axis;
      rest /= on_axis;
      around.first[a] = at > halo ? at - halo : 0;
      around.end[a] = std::min(at + 1, cells[a]);
      node += stride * at;
      stride *= cells[a] + halo;
    }
    portion.whole_node.push_back(node);
    portion.node_owner.push_back(least_of(around));
  }
  return {std::move(grid), std::move(portion)};
}

}  // namespace arenite::inline ARENITE_INSTRUCTION_SET
