// Cell list: which points lie in which cell, as one array with offsets, in an order that depends on nothing
// but the points.
#pragma once

#include <span>
#include <vector>

#include <arenite/core/scalar.hpp>

namespace arenite {

/// Points of each cell, each cell's in ascending order. Made anew (one counting sort of numbers) when points
/// change cells.
class CellList {
 public:
  void build(const std::vector<Index>& cell, Index cell_count) {
    start_.assign(cell_count + 1, 0);
    for (const Index c : cell) ++start_[c + 1];
    for (std::size_t c = 1; c < start_.size(); ++c) start_[c] += start_[c - 1];
    order_.resize(cell.size());
    next_.assign(start_.begin(), start_.end() - 1);
    for (std::size_t p = 0; p < cell.size(); ++p) order_[next_[cell[p]]++] = static_cast<Index>(p);
  }

  std::span<const Index> operator[](Index cell) const {
    return {order_.data() + start_[cell], order_.data() + start_[cell + 1]};
  }
  bool empty(Index cell) const { return start_[cell] == start_[cell + 1]; }
  /// Points in the order of their cells.
  const std::vector<Index>& order() const { return order_; }
  std::size_t bytes() const { return (start_.size() + order_.size() + next_.size()) * sizeof(Index); }

 private:
  std::vector<Index> start_;  // [cells + 1]
  std::vector<Index> order_;  // [points]
  std::vector<Index> next_;   // [cells], scratch
};

}  // namespace arenite
