// Portion: a part of a mesh, with one layer of ghost cells, over which one scene is made.
#pragma once
// SPDX-License-Identifier: BSD-3-Clause

#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>
#include <set>
#include <utility>
#include <vector>

#include <arenite/mesh/simplex_mesh.hpp>
#include <arenite/mesh/window_grid.hpp>

namespace arenite::inline ARENITE_INSTRUCTION_SET {

/// Data that a scene over a part of a mesh needs about the whole (`split_mesh` makes it).
/// Its own cells contain its points; ghost cells are those of others that share a node with them, so that all
/// cells at an owned node are present. Bodies without points, and walls without nodes, are then valid.
template <int D>
struct MeshPortion {
  int number = 0;                         ///< of this portion
  std::vector<int> owner;                 ///< [cells] portion that owns a cell's points
  std::vector<std::uint64_t> whole_cell;  ///< [cells] number in the whole mesh, ascending
  std::vector<std::uint64_t> whole_node;  ///< [nodes] the same
  std::vector<int> node_owner;            ///< [nodes] portion that counts it in sums
  Vec<double, D> lower, upper;            ///< corners of the box around the whole mesh, m
  std::set<std::array<Index, static_cast<std::size_t>(D)>> cuts;  ///< faces across which the mesh continues

  bool owns_cell(Index c) const { return owner[c] == number; }
  bool owns_node(Index i) const { return node_owner[i] == number; }
  /// The cell with a number of the whole mesh, or `none`.
  Index find_cell(std::uint64_t whole) const {
    const auto at = std::ranges::lower_bound(whole_cell, whole);
    return at != whole_cell.end() && *at == whole ? static_cast<Index>(at - whole_cell.begin()) : none;
  }
  /// Like `find_cell`, but throws `run_error` where it gives `none`.
  Index cell_here(std::uint64_t whole) const {
    const Index cell = find_cell(whole);
    if (cell == none)
      throw run_error(joined_text({"cell ", whole, " of the whole mesh is not in portion ", number}));
    return cell;
  }

  /// Whether a position outside of this part of the mesh lies beyond its ghost cells, not beyond the hull of
  /// the whole mesh: which of the two is nearer. Checks all cells: few points are lost.
  template <class M>
  bool is_beyond_ghosts(const M& mesh, const typename M::Point& x) const {
    if constexpr (is_window<M>)
      return mesh.whole().walk(x) != none;
    else
      return is_behind_a_cut(mesh, x);
  }

 private:
  template <class M>
  bool is_behind_a_cut(const M& mesh, const typename M::Point& x) const {
    double least = std::numeric_limits<double>::infinity();
    std::array<Index, static_cast<std::size_t>(D)> nearest{};
    for (Index c = 0; c < mesh.cell_count(); ++c)
      for (int k = 0; k <= D; ++k) {
        if (mesh.neighbour(c, k) != none) continue;
        std::array<Index, static_cast<std::size_t>(D)> face{};
        std::size_t at = 0;
        for (int j = 0; j <= D; ++j)
          if (j != k) face[at++] = mesh.nodes(c)[static_cast<std::size_t>(j)];
        const double d = distance(mesh, face, x.template cast<double>());
        if (d >= least) continue;
        least = d;
        nearest = face;
      }
    std::ranges::sort(nearest);
    return cuts.count(nearest) > 0;
  }

  /// Distance of a position to a face, m; roughly where its foot lies beside the face.
  template <class M>
  static double distance(const M& mesh, const std::array<Index, static_cast<std::size_t>(D)>& face,
                         const Vec<double, D>& x) {
    Eigen::Matrix<double, D, D - 1> edges;
    const Vec<double, D> from = mesh.position(face[0]).template cast<double>();
    for (int k = 1; k < D; ++k)
      edges.col(k - 1) = mesh.position(face[static_cast<std::size_t>(k)]).template cast<double>() - from;
    Vec<double, D> share;  // of each node in the foot
    share.template tail<D - 1>() = (edges.transpose() * edges).inverse() * (edges.transpose() * (x - from));
    share[0] = 1 - share.template tail<D - 1>().sum();
    share = share.cwiseMax(0);
    share /= share.sum();
    return (from + edges * share.template tail<D - 1>() - x).norm();
  }
};

/// The part of a scene over a portion: with it the communicator of the scenes over all portions, by value (see
/// `parallel/communicator.hpp`).
template <class Portion, class Communicator>
struct OnPortion {
  struct PortionOfMesh;
  using OnlyOne = PortionOfMesh;
  static constexpr bool is_on_portion = true;

  Portion portion;
  Communicator communicator;
};
template <int D, class Communicator>
OnPortion<MeshPortion<D>, Communicator> on_portion(MeshPortion<D> portion, Communicator communicator) {
  return {std::move(portion), std::move(communicator)};
}

/// `owns(cell)`: whether a portion owns the points of a cell; `number(cell)`: its number in the whole mesh.
template <int D>
struct OwnedCells {
  static constexpr bool is_whole = false;
  const MeshPortion<D>& portion;
  bool operator()(Index c) const { return portion.owns_cell(c); }
  std::uint64_t number(Index c) const { return portion.whole_cell[c]; }
};

namespace detail {

/// Makes one portion of a mesh, step by step.
template <int D>
class PortionMaker {
 public:
  PortionMaker(const MeshData<D>& whole, const std::vector<int>& owner, int number)
      : whole_{whole}, owner_{owner}, number_{number} {}

  std::pair<MeshData<D>, MeshPortion<D>> make() {
    find_owners();
    portion_.number = number_;
    keep_nodes();
    keep_cells();
    find_cuts();
    keep_names();
    return {std::move(mesh_), std::move(portion_)};
  }

 private:
  static constexpr int nobody = std::numeric_limits<int>::max();
  static constexpr auto dim = static_cast<std::size_t>(D);

  /// Least owner of the cells at each node, and the nodes of cells that the portion owns.
  void find_owners() {
    touched_.resize(whole_.nodes.size());
    node_owner_.assign(whole_.nodes.size(), nobody);
    for (std::size_t c = 0; c < whole_.cells.size(); ++c)
      for (const Index i : whole_.cells[c]) {
        touched_[i] = touched_[i] || owner_[c] == number_;
        node_owner_[i] = std::min(node_owner_[i], owner_[c]);
      }
  }

  /// Whether a cell is owned by the portion, or a ghost, which shares a node with an owned cell.
  bool is_here(std::size_t cell) const {
    return std::ranges::any_of(whole_.cells[cell], [&](Index i) { return touched_[i]; });
  }

  /// Numbers the nodes of the cells that are here, and finds the box around the whole.
  void keep_nodes() {
    std::vector<bool> kept(whole_.nodes.size());
    for (std::size_t c = 0; c < whole_.cells.size(); ++c)
      if (is_here(c))
        for (const Index i : whole_.cells[c]) kept[i] = true;
    portion_.lower = Vec<double, D>::Constant(std::numeric_limits<double>::infinity());
    portion_.upper = -portion_.lower;
    local_.assign(whole_.nodes.size(), none);
    for (std::size_t i = 0; i < whole_.nodes.size(); ++i) {
      if (node_owner_[i] != nobody) {  // a cell has it
        portion_.lower = portion_.lower.cwiseMin(whole_.nodes[i]);
        portion_.upper = portion_.upper.cwiseMax(whole_.nodes[i]);
      }
      if (!kept[i]) continue;
      local_[i] = static_cast<Index>(mesh_.nodes.size());
      mesh_.nodes.push_back(whole_.nodes[i]);
      portion_.whole_node.push_back(i);
      portion_.node_owner.push_back(node_owner_[i]);
    }
  }

  void keep_cells() {
    for (std::size_t c = 0; c < whole_.cells.size(); ++c) {
      if (!is_here(c)) continue;
      auto cell = whole_.cells[c];
      for (Index& i : cell) i = local_[i];
      mesh_.cells.push_back(cell);
      mesh_.region.push_back(whole_.region.empty() ? 0 : whole_.region[c]);
      portion_.owner.push_back(owner_[c]);
      portion_.whole_cell.push_back(c);
    }
  }

  /// The faces that a cell elsewhere has in common with a ghost cell: all of their nodes are here.
  void find_cuts() {
    for (std::size_t c = 0; c < whole_.cells.size(); ++c) {
      if (is_here(c)) continue;
      for (std::size_t k = 0; k <= dim; ++k) {
        std::array<Index, dim> face{};
        for (std::size_t j = 0, at = 0; j <= dim; ++j)
          if (j != k) face[at++] = local_[whole_.cells[c][j]];
        std::ranges::sort(face);
        if (face.back() != none) portion_.cuts.insert(face);
      }
    }
  }

  void keep_names() {
    mesh_.region_names = whole_.region_names;
    mesh_.shared_regions = whole_.shared_regions;
    for (const auto& [name, nodes] : whole_.node_sets) {
      auto& here = mesh_.node_sets[name];
      for (const Index i : nodes)
        if (local_[i] != none) here.push_back(local_[i]);
    }
  }

  const MeshData<D>& whole_;
  const std::vector<int>& owner_;
  int number_;
  std::vector<bool> touched_{};    // [nodes of the whole] by an owned cell
  std::vector<int> node_owner_{};  // [nodes of the whole] `nobody` for a node that no cell has
  std::vector<Index> local_{};     // [nodes of the whole] number here, or none
  MeshData<D> mesh_{};
  MeshPortion<D> portion_{};
};

}  // namespace detail

/// Part number `number` of a mesh whose cells belong to the parts `owner` [cells]: its own cells and the
/// ghosts around them, in the order of the whole, and the data that its scene needs. A node belongs to the
/// least of the parts at it.
template <int D>
std::pair<MeshData<D>, MeshPortion<D>> split_mesh(const MeshData<D>& whole, const std::vector<int>& owner,
                                                  int number) {
  require(owner.size() == whole.cells.size(), "split_mesh.owner", owner.size(), "must have one entry a cell");
  return detail::PortionMaker<D>(whole, owner, number).make();
}

}  // namespace arenite::inline ARENITE_INSTRUCTION_SET
