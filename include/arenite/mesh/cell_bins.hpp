// Bins over a simplex mesh: a uniform grid of buckets that names the cells near a position, for a search with
// no hint.
#pragma once
// SPDX-License-Identifier: BSD-3-Clause

#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <vector>

#include <arenite/core/lists.hpp>
#include <arenite/core/tensor.hpp>

namespace arenite::inline ARENITE_INSTRUCTION_SET {

/// About one bucket a cell; a cell is listed in each bucket that its bounding box touches.
template <int D, real_scalar T>
class CellBins {
 public:
  void build(const std::vector<Vec<T, D>>& nodes, const std::vector<std::array<Index, D + 1>>& cells) {
    lower_ = nodes[cells[0][0]];
    Vec<T, D> upper = lower_;
    for (const auto& cell : cells)
      for (const Index i : cell) {
        lower_ = lower_.cwiseMin(nodes[i]);
        upper = upper.cwiseMax(nodes[i]);
      }
    const Vec<T, D> extent = upper - lower_;
    const T edge = std::pow(extent.prod() / static_cast<T>(cells.size()), T(1) / D);
    std::size_t total = 1;
    for (int k = 0; k < D; ++k) {
      count_[static_cast<std::size_t>(k)] = std::clamp<long>(std::lround(extent[k] / edge), 1, 4096);
      per_metre_[k] = static_cast<T>(count_[static_cast<std::size_t>(k)]) / extent[k];
      total *= static_cast<std::size_t>(count_[static_cast<std::size_t>(k)]);
    }
    cells_.build(total, [&](auto&& add) { visit(nodes, cells, add); });
  }

  /// Cells near x (the nearest bucket's, if x lies outside), ascending.
  std::span<const Index> at(const Vec<T, D>& x) const {
    std::size_t bin = 0;
    for (int k = D - 1; k >= 0; --k)
      bin = bin * static_cast<std::size_t>(count_[static_cast<std::size_t>(k)]) +
            static_cast<std::size_t>(slot(x[k], k));
    return cells_[bin];
  }

 private:
  long slot(T x, int k) const {
    const T s = std::floor((x - lower_[k]) * per_metre_[k]);
    const long last = count_[static_cast<std::size_t>(k)] - 1;
    return s <= 0 ? 0 : s >= static_cast<T>(last) ? last : static_cast<long>(s);
  }

  template <class F>
  void visit(const std::vector<Vec<T, D>>& nodes, const std::vector<std::array<Index, D + 1>>& cells,
             F&& f) const {
    for (std::size_t c = 0; c < cells.size(); ++c) {
      Vec<T, D> low = nodes[cells[c][0]], high = low;
      for (const Index i : cells[c]) {
        low = low.cwiseMin(nodes[i]);
        high = high.cwiseMax(nodes[i]);
      }
      std::array<long, 3> first{}, last{};
      for (std::size_t k = 0; k < D; ++k) {
        const T slack = T(1e-3) / per_metre_[static_cast<int>(k)];
        first[k] = slot(low[static_cast<int>(k)] - slack, static_cast<int>(k));
        last[k] = slot(high[static_cast<int>(k)] + slack, static_cast<int>(k));
      }
      for (long z = first[2]; z <= last[2]; ++z)
        for (long y = first[1]; y <= last[1]; ++y)
          for (long x = first[0]; x <= last[0]; ++x)
            f(static_cast<std::size_t>((z * count_[1] + y) * count_[0] + x), static_cast<Index>(c));
    }
  }

  Vec<T, D> lower_ = zeros<Vec<T, D>>();
  Vec<T, D> per_metre_ = filled<Vec<T, D>>(1);
  std::array<long, 3> count_{1, 1, 1};
  Lists cells_;  // [buckets]
};

}  // namespace arenite::inline ARENITE_INSTRUCTION_SET
