// Nodes near a box, found without a walk over all of them: what a rigid body may touch.
#pragma once
// SPDX-License-Identifier: BSD-3-Clause

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

#include <arenite/core/lists.hpp>
#include <arenite/geometry/box.hpp>
#include <arenite/shape/shape.hpp>

namespace arenite::inline ARENITE_INSTRUCTION_SET {

/// Bins of the nodes of a simplex mesh, some 16 in each.
template <class T, int D>
class NodeBins {
 public:
  template <class M>
  void build(const M& mesh) {
    moves_ = mesh.moves();
    lower_ = mesh.position(0);
    Vec<T, D> upper = lower_;
    for (const auto& x : mesh.positions()) {
      lower_ = lower_.cwiseMin(x);
      upper = upper.cwiseMax(x);
    }
    const T edge =
        std::pow(16 * (upper - lower_).prod() / static_cast<T>(mesh.node_count()), T(1) / static_cast<T>(D));
    for (std::size_t k = 0; k < D; ++k) {
      const T extent = upper[static_cast<int>(k)] - lower_[static_cast<int>(k)];
      count_[k] = static_cast<Index>(std::clamp(std::ceil(extent / edge), T(1), T(1024)));
      per_metre_[static_cast<int>(k)] = static_cast<T>(count_[k]) / extent;
    }
    std::size_t bins = 1;
    for (const Index n : count_) bins *= n;
    nodes_.build(bins, [&](auto&& add) {
      for (Index i = 0; i < mesh.node_count(); ++i) {
        std::size_t bin = 0;
        for (int k = D - 1; k >= 0; --k)
          bin = bin * count_[static_cast<std::size_t>(k)] +
                slot(static_cast<double>(mesh.position(i)[k]), static_cast<std::size_t>(k));
        add(bin, i);
      }
    });
    largest_ = 0;
    for (Index i = 0; i < mesh.node_count(); ++i) largest_ = std::max(largest_, mesh.node_size(i));
  }

  /// Whether they were built of this mesh, where it was then.
  template <class M>
  bool are_of(const M& mesh) const {
    return nodes_.values().size() == mesh.node_count() && moves_ == mesh.moves();
  }
  /// The largest `node_size`, m.
  double largest_size() const { return static_cast<double>(largest_); }

  /// Appends the nodes of all bins that a box touches, in no order.
  void collect(const Box<std::size_t{D}>& box, std::vector<Index>& found) const {
    std::array<Index, 3> first{}, last{};
    for (std::size_t k = 0; k < D; ++k) {
      first[k] = slot(box.lower[k], k);
      last[k] = slot(box.upper[k], k);
    }
    for (Index z = first[2]; z <= last[2]; ++z)
      for (Index y = first[1]; y <= last[1]; ++y) {
        const std::size_t row = (std::size_t{z} * count_[1] + y) * count_[0];
        const auto begin = nodes_[row + first[0]].data();
        const auto end = nodes_[row + last[0]].data() + nodes_[row + last[0]].size();
        found.insert(found.end(), begin, end);
      }
  }

 private:
  Index slot(double x, std::size_t k) const {
    const double s = (x - static_cast<double>(lower_[static_cast<int>(k)])) *
                     static_cast<double>(per_metre_[static_cast<int>(k)]);
    return !(s > 0) ? 0 : s >= count_[k] ? count_[k] - 1 : static_cast<Index>(s);
  }

  Vec<T, D> lower_ = Vec<T, D>::Zero(), per_metre_ = Vec<T, D>::Zero();
  std::array<Index, 3> count_{1, 1, 1};
  T largest_ = 0;
  std::size_t moves_ = 0;  // of the mesh
  Lists nodes_;            // [bins]
};

/// Finds the nodes near a box in one mesh, call after call; a box that hardly moves costs hardly anything. On
/// a simplex mesh that has moved since the last call it names all nodes.
template <class T, int D>
class NodesNear {
 public:
  /// Looks for the nodes no farther from a box than `sizes` times their `node_size`, along each axis. Its
  /// sides, m, may lie at infinity. Names perhaps other nodes, too.
  template <class Shape, class M>
  void find(const M& mesh, Box<std::size_t{D}> box, double sizes) {
    const Index nodes = Shape::node_count(mesh);
    double largest = 0;
    if constexpr (is_simplex_mesh<M>) {
      if (!bins_.are_of(mesh)) {
        const bool rests = nodes_ != nodes || moves_ == mesh.moves();
        moves_ = mesh.moves();
        nodes_ = nodes;
        forget();
        takes_all_ = !rests;
        if (takes_all_) return;
        bins_.build(mesh);
      }
      largest = bins_.largest_size();
    } else {
      if (nodes_ != nodes) forget();
      nodes_ = nodes;
      if constexpr (is_rectilinear<M>) {
        if (moves_ != mesh.moves()) forget();
        moves_ = mesh.moves();
      }
      largest = static_cast<double>(mesh.node_size(0));
    }
    // Round-off must not lose a node: 1e-3 cells more. And one cell more, for the calls that follow.
    bool is_inside = true;
    for (std::size_t k = 0; k < D; ++k) {
      double &lower = box.lower[k], &upper = box.upper[k];
      lower -= (sizes + 1e-3) * largest;
      upper += (sizes + 1e-3) * largest;
      is_inside = is_inside && lower >= searched_.lower[k] && upper <= searched_.upper[k];
      is_inside = is_inside && lower - 2 * largest <= searched_.lower[k];
      is_inside = is_inside && upper + 2 * largest >= searched_.upper[k];
    }
    if (is_inside) return;
    for (std::size_t k = 0; k < D; ++k) {
      searched_.lower[k] = box.lower[k] - largest;
      searched_.upper[k] = box.upper[k] + largest;
    }
    found_.clear();
    if constexpr (is_simplex_mesh<M>) {
      bins_.collect(searched_, found_);
      std::erase_if(found_, [&](Index i) {
        for (std::size_t k = 0; k < D; ++k) {
          const auto x = static_cast<double>(mesh.position(i)[static_cast<int>(k)]);
          if (x < searched_.lower[k] || x > searched_.upper[k]) return true;
        }
        return false;
      });
      std::ranges::sort(found_);
      takes_all_ = found_.size() == nodes;
    } else if constexpr (requires { Shape::node_count(mesh, 0); }) {
      collect_ranges<Shape>(mesh);
    } else {
      takes_all_ = true;
    }
  }

  /// Numbers of the nodes found, ascending.
  std::size_t size() const { return takes_all_ ? nodes_ : found_.size(); }
  Index operator[](std::size_t k) const { return takes_all_ ? static_cast<Index>(k) : found_[k]; }

 private:
  void forget() {
    searched_.lower.fill(std::numeric_limits<double>::infinity());
    searched_.upper.fill(-std::numeric_limits<double>::infinity());
  }

  /// The nodes of a grid: a range of numbers along each axis, on which places ascend (but for the first of a
  /// periodic one, which is then always named).
  template <class Shape, class M>
  void collect_ranges(const M& grid) {
    std::array<Index, 3> first{}, last{1, 1, 1}, on_axis{1, 1, 1};
    Index stride = 1;
    takes_all_ = true;
    for (std::size_t k = 0; k < D; ++k) {
      const auto at = [&](Index n) {
        return static_cast<double>(Shape::node_position(grid, n * stride)[static_cast<int>(k)]);
      };
      on_axis[k] = Shape::node_count(grid, static_cast<int>(k));
      first[k] = 0;
      last[k] = on_axis[k];
      while (first[k] < last[k] && at(first[k]) < searched_.lower[k]) ++first[k];
      while (first[k] < last[k] && at(last[k] - 1) > searched_.upper[k]) --last[k];
      takes_all_ = takes_all_ && last[k] - first[k] == on_axis[k];
      stride *= on_axis[k];
    }
    if (takes_all_) return;
    for (Index z = first[2]; z < last[2]; ++z)
      for (Index y = first[1]; y < last[1]; ++y)
        for (Index x = first[0]; x < last[0]; ++x) found_.push_back((z * on_axis[1] + y) * on_axis[0] + x);
  }

  std::vector<Index> found_{};  // in the box `searched_`
  Box<std::size_t{D}> searched_{};
  bool takes_all_ = false;
  Index nodes_ = 0;        // of the mesh
  std::size_t moves_ = 0;  // of the mesh, at the last call
  NodeBins<T, D> bins_{};
};

}  // namespace arenite::inline ARENITE_INSTRUCTION_SET
