// Split cells: which tile has which cell of a mesh.
#pragma once
// SPDX-License-Identifier: BSD-3-Clause

#include <algorithm>
#include <array>
#include <cstddef>
#include <span>
#include <utility>
#include <vector>

#include <arenite/core/error.hpp>
#include <arenite/mesh/cartesian_grid.hpp>
#include <arenite/tiles/split_grid.hpp>

namespace arenite::inline ARENITE_INSTRUCTION_SET {

namespace detail {

/// Centres of cells with what they weigh, and their numbers in the mesh.
template <int D>
struct WeighedCell {
  std::array<double, static_cast<std::size_t>(D)> centre;
  double weight;
  std::size_t number;
};

/// Gives cells the tiles first, .., first + count - 1: cuts across the longest side of the box around their centres, so that both
/// sides weigh as much as the tiles that they get.
template <int D>
void bisect(std::span<WeighedCell<D>> cells, int first, int count, std::vector<int>& tile) {
  if (count == 1) {
    for (const auto& c : cells) tile[c.number] = first;
    return;
  }
  std::size_t axis = 0;
  double longest = -1;
  for (std::size_t k = 0; k < static_cast<std::size_t>(D); ++k) {
    const auto [least, most] = std::ranges::minmax(cells, {}, [&](const auto& c) { return c.centre[k]; });
    if (most.centre[k] - least.centre[k] > longest * (1 + 1e-9)) {
      longest = most.centre[k] - least.centre[k];
      axis = k;
    }
  }
  std::ranges::sort(cells, {}, [&](const auto& c) { return std::pair{c.centre[axis], c.number}; });
  double all = 0, before = 0;
  for (const auto& c : cells) all += c.weight;
  const int left = count / 2;
  // At least one cell for each tile.
  std::size_t cut = 0;
  const auto least = static_cast<std::size_t>(left),
             most = cells.size() - static_cast<std::size_t>(count - left);
  while (cut < most && (cut < least || before + cells[cut].weight / 2 < all * left / count))
    before += cells[cut++].weight;
  bisect(cells.first(cut), first, left, tile);
  bisect(cells.subspan(cut), first + left, count - left, tile);
}

}  // namespace detail

/// [cells] the tile of each cell: boxes around the cells' centres are halved again and again across their longest side (recursive
/// coordinate bisection, Berger and Bokhari 1987), so that tiles weigh the same. `weights`: [cells] what a cell costs, such as
/// its points; empty: all the same. Depends on nothing else. Throws `error` for fewer cells than tiles.
template <int D>
std::vector<int> split_cells(const MeshData<D>& mesh, int tiles, const std::vector<double>& weights = {}) {
  require(tiles >= 1 && static_cast<std::size_t>(tiles) <= mesh.cells.size(), "split_cells.tiles", tiles,
          {"must be between 1 and the number of cells, ", mesh.cells.size()});
  require(weights.empty() || weights.size() == mesh.cells.size(), "split_cells.weights", weights.size(),
          "must have one entry a cell");
  std::vector<detail::WeighedCell<D>> cells;
  cells.reserve(mesh.cells.size());
  for (std::size_t c = 0; c < mesh.cells.size(); ++c) {
    auto& cell = cells.emplace_back();
    cell.number = c;
    cell.weight = weights.empty() ? 1 : weights[c];
    require(cell.weight >= 0, "split_cells.weights", cell.weight, "must not be negative");
    for (std::size_t k = 0; k < cell.centre.size(); ++k) {
      cell.centre[k] = 0;
      for (const Index i : mesh.cells[c]) cell.centre[k] += mesh.nodes[i][static_cast<int>(k)] / (D + 1);
    }
  }
  std::vector<int> tile(mesh.cells.size());
  detail::bisect<D>(cells, 0, tiles, tile);
  return tile;
}

namespace detail {

/// Cuts a box of cells across its longest side, again and again. `weight(range)`: of the cells in a range.
template <int D, class Weight>
void bisect(const CellRange<D>& box, int count, const Weight& weight, std::vector<CellRange<D>>& boxes) {
  if (count == 1) {
    boxes.push_back(box);
    return;
  }
  std::size_t axis = 0;
  for (std::size_t k = 1; k < static_cast<std::size_t>(D); ++k)
    if (box.end[k] - box.first[k] > box.end[axis] - box.first[axis]) axis = k;
  auto left = box, right = box;
  const double wanted = weight(box) * (count / 2) / count;
  // The cut at which the left side is next to what it should weigh; one layer at least on either side.
  double before = 0;
  left.end[axis] = box.first[axis];
  for (Index at = box.first[axis]; at + 1 < box.end[axis]; ++at) {
    auto layer = box;
    layer.first[axis] = at;
    layer.end[axis] = at + 1;
    const double more = weight(layer);
    if (at > box.first[axis] && before + more / 2 >= wanted) break;
    before += more;
    left.end[axis] = at + 1;
  }
  right.first[axis] = left.end[axis];
  // Half of the tiles, or as many as both sides have cells for.
  const auto cells = [](const CellRange<D>& range) {
    double all = 1;
    for (std::size_t k = 0; k < range.end.size(); ++k) all *= range.end[k] - range.first[k];
    return static_cast<int>(std::min(all, 1e9));
  };
  const int on_left =
      std::clamp(count / 2, std::max(1, count - cells(right)), std::min(count - 1, cells(left)));
  bisect(left, on_left, weight, boxes);
  bisect(right, count - on_left, weight, boxes);
}

}  // namespace detail

/// [tiles] the box of cells of each tile of a grid, halved again and again as those of a mesh. `weights`: [cells], or empty. Throws `error`
/// for fewer cells than tiles.
template <class Grid, int D = Grid::dimension>
requires requires(const Grid& grid) { grid.cells(0); }
std::vector<CellRange<D>> split_cells(const Grid& grid, int tiles, const std::vector<double>& weights = {}) {
  require(tiles >= 1 && static_cast<Index>(tiles) <= grid.cell_count(), "split_cells.tiles", tiles,
          {"must be between 1 and the number of cells, ", grid.cell_count()});
  require(weights.empty() || weights.size() == grid.cell_count(), "split_cells.weights", weights.size(),
          "must have one entry a cell");
  for (const double w : weights) require(w >= 0, "split_cells.weights", w, "must not be negative");
  CellRange<D> all;
  for (std::size_t k = 0; k < all.end.size(); ++k) all.end[k] = grid.cells(static_cast<int>(k));
  std::vector<CellRange<D>> boxes;
  detail::bisect(
      all, tiles,
      [&](const CellRange<D>& range) {
        double sum = 1;
        for (std::size_t k = 0; k < range.end.size(); ++k) sum *= range.end[k] - range.first[k];
        if (weights.empty()) return sum;
        sum = 0;
        auto at = range.first;
        for (std::size_t k = 0; k < at.size();) {
          Index cell = 0;
          for (std::size_t a = at.size(); a-- > 0;) cell = cell * grid.cells(static_cast<int>(a)) + at[a];
          sum += weights[cell];
          for (k = 0; k < at.size() && ++at[k] == range.end[k]; ++k) at[k] = range.first[k];
        }
        return sum;
      },
      boxes);
  return boxes;
}

}  // namespace arenite::inline ARENITE_INSTRUCTION_SET
