// Shared by the readers of all Gmsh formats: node tags turned into indices,
// physical groups turned into regions and node sets, and the checks of the mesh as a whole.
#pragma once
// SPDX-License-Identifier: BSD-3-Clause

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <numeric>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include <arenite/core/instruction_set.hpp>
#include <arenite/core/lists.hpp>
#include <arenite/core/map.hpp>
#include <arenite/core/scalar.hpp>
#include <arenite/io/gmsh_kinds.hpp>
#include <arenite/io/mesh_input.hpp>
#include <arenite/mesh/mesh_data.hpp>

namespace arenite::inline ARENITE_INSTRUCTION_SET::shared_detail {

/// Takes nodes, then elements, in the order of a file; `finish` makes the mesh of them.
template <int D>
class GmshMesh {
 public:
  using Nodes = std::array<Index, 4>;  ///< of one element; the longest are tetrahedron and quadrangle

  /// The physical group `tag` of dimension `dim` is called `name`.
  void name_group(const MeshInput& in, int dim, int tag, const std::string& name) {
    in.check(dim >= 0 && dim <= 3, "dimension of the group", dim, "must be 0, 1, 2 or 3");
    in.check(tag >= 1, "tag of the group", tag, "must be at least 1");
    in.check(names_.emplace(std::pair(dim, tag), name).second, "tag of the group", tag, "is named twice");
    if (dim == D)
      in.check(result_.region_names.emplace(name, tag).second, "name", MeshInput::quote(name),
               "is the name of two regions");
  }

  void reserve_nodes(std::uint64_t count) {
    tags_.reserve(count);
    positions_.reserve(count);
  }

  void add_tag(const MeshInput& in, std::uint64_t tag) {
    in.check(tag >= 1, "tag of the node", tag, "must be at least 1");
    tags_.push_back(tag);
  }

  /// Reads the position of the next node that has none yet.
  void read_position(MeshInput& in) {
    add_position(in, [&](std::size_t i) { return in.real(axes[i]); });
    in.end_row("position of the node");
  }
  /// A node from the caller's numbers, `x(0)` to `x(2)`, m.
  template <class X>
  void add_position(const MeshInput& in, const X& x) {
    auto& position = positions_.emplace_back();
    for (std::size_t i = 0; i < 3; ++i) {
      position[i] = x(i);
      if (!std::isfinite(position[i]))
        in.fail(joined_text({axes[i], " of node ", tags_[positions_.size() - 1]}), position[i],
                "must be finite");
    }
  }

  /// Sorts the nodes by tag, so that a mesh is the same whatever format it was saved in.
  void end_nodes(const MeshInput& in) {
    in.check(tags_.size() < none, "number of nodes", tags_.size(), "must be less than 2^32 - 1");
    if (!std::is_sorted(tags_.begin(), tags_.end())) sort_nodes();
    const auto twice = std::adjacent_find(tags_.begin(), tags_.end());
    if (twice != tags_.end()) in.fail("tag of the node", *twice, "is given twice");
    if (tags_.empty() || tags_.back() - tags_.front() > 4 * tags_.size() + 1024)
      return;  // too sparse for a table
    index_.assign(tags_.back() - tags_.front() + 1, none);
    for (std::size_t i = 0; i < tags_.size(); ++i) index_[tags_[i] - tags_.front()] = static_cast<Index>(i);
  }

  /// The kind of element under Gmsh's number, if this mesh can take it.
  const GmshKind& kind(const MeshInput& in, int number) const {
    const auto found = std::find_if(gmsh_kinds.begin(), gmsh_kinds.end(),
                                    [&](const GmshKind& k) { return k.number == number; });
    in.check(found != gmsh_kinds.end(), "type of element", number, "is no known type");
    const char* rule = nullptr;
    if (found->dim > D)
      rule = "a plane mesh holds triangles; read solids in 3 dimensions";
    else if (found->nodes == 0)
      rule = "must be of first order (Gmsh: Mesh.ElementOrder = 1)";
    else if (found->dim == D && found->nodes != D + 1)
      rule = D == 2 ? "the cells must be triangles" : "the cells must be tetrahedra";
    if (rule != nullptr) in.fail("type of element", joined_text({number, " (", found->name, ")"}), rule);
    return *found;
  }

  void reserve_cells(std::uint64_t count) {
    result_.cells.reserve(count);
    result_.region.reserve(count);
  }

  /// Index of the node with this tag.
  Index node(const MeshInput& in, std::uint64_t tag) const {
    Index i = none;
    if (!index_.empty()) {
      if (tag >= tags_.front() && tag <= tags_.back()) i = index_[tag - tags_.front()];
    } else {
      const auto found = std::lower_bound(tags_.begin(), tags_.end(), tag);
      if (found != tags_.end() && *found == tag) i = static_cast<Index>(found - tags_.begin());
    }
    in.check(i != none, "node of the element", tag, "is not among $Nodes");
    return i;
  }

  /// A cell may stand once for each of its groups, as format 2.2 has it.
  void repeat_elements() { repeats_ = true; }

  /// Adds an element of the physical groups `groups` (0: none). Those of a cell are its region.
  void add_element(const MeshInput& in, const GmshKind& kind, std::span<const int> groups,
                   const Nodes& nodes) {
    if (kind.dim < D) {
      for (const int group : groups) {
        if (group == 0) continue;
        auto& set = sets_[{static_cast<int>(kind.dim), unsigned_tag(in, group)}];
        set.insert(set.end(), nodes.begin(), nodes.begin() + std::ptrdiff_t(kind.nodes));
      }
      return;
    }
    std::array<Index, D + 1> cell;
    std::copy_n(nodes.begin(), cell.size(), cell.begin());
    for (std::size_t i = 0; i < cell.size(); ++i)
      for (std::size_t j = 0; j < i; ++j)
        in.check(cell[i] != cell[j], "node of the cell", tags_[cell[i]], "is named twice by one cell");
    result_.cells.push_back(cell);
    std::vector<int> own;
    for (const int group : groups) own.push_back(unsigned_tag(in, group));
    result_.region.push_back(region_of(std::move(own)));
  }

  MeshData<D> finish(const MeshInput& in) && {
    if (result_.cells.empty())
      in.refuse("cells", 0, D == 2 ? "the mesh must hold triangles" : "the mesh must hold tetrahedra");
    join_repeated_cells(in);
    const std::vector<Index> number = number_used_nodes();
    if constexpr (D == 2) refuse_curved(in, number);
    for (std::size_t i = 0; i < number.size(); ++i)
      if (number[i] != none) {
        Vec<double, D> x;
        for (std::size_t k = 0; k < D; ++k) x[static_cast<Eigen::Index>(k)] = positions_[i][k];
        result_.nodes.push_back(x);
      }
    for (auto& cell : result_.cells)
      for (Index& node : cell) node = number[node];
    for (const auto& [group, nodes] : sets_) {
      const auto name = names_.find(group);
      const std::string key =
          name != names_.end() ? name->second : joined_text({group.first, ":", group.second});
      for (const Index node : nodes)
        if (number[node] != none) result_.node_sets[key].push_back(number[node]);
    }
    for (const auto& [groups, region] : shared_)
      for (const int group : groups)
        if (const auto name = names_.find({D, group}); name != names_.end())
          result_.shared_regions[name->second].push_back(region);
    for (auto& [name, nodes] : result_.node_sets) {
      std::sort(nodes.begin(), nodes.end());
      nodes.erase(std::unique(nodes.begin(), nodes.end()), nodes.end());
    }
    return std::move(result_);
  }

 private:
  static constexpr std::array<const char*, 3> axes{"x", "y", "z"};

  /// Region of the cells of these groups: the tag of a single one; -1, -2, .. for each set of several.
  int region_of(std::vector<int> groups) {
    std::erase(groups, 0);
    std::sort(groups.begin(), groups.end(), MapOrder());
    groups.erase(std::unique(groups.begin(), groups.end()), groups.end());
    if (groups.size() < 2) return groups.empty() ? 0 : groups.front();
    return shared_.try_emplace(std::move(groups), -1 - static_cast<int>(shared_.size())).first->second;
  }

  /// Gmsh gives a group a negative tag on an entity that the group contains reversed: the group is the same.
  static int unsigned_tag(const MeshInput& in, int tag) {
    in.check(tag > -2147483647, "physical tag", tag, "must fit an int without its sign");
    return std::abs(tag);
  }

  void sort_nodes() {
    std::vector<Index> order(tags_.size());
    std::iota(order.begin(), order.end(), Index{0});
    std::sort(order.begin(), order.end(),
              [&](Index a, Index b) { return tags_[a] != tags_[b] ? tags_[a] < tags_[b] : a < b; });
    auto tags = tags_;
    auto positions = positions_;
    for (std::size_t i = 0; i < order.size(); ++i) {
      tags[i] = tags_[order[i]];
      positions[i] = positions_[order[i]];
    }
    tags_.swap(tags);
    positions_.swap(positions);
  }

  /// Index in the result of each node; none: no cell uses it.
  std::vector<Index> number_used_nodes() const {
    std::vector<Index> number(tags_.size(), none);
    for (const auto& cell : result_.cells)
      for (const Index node : cell) number[node] = 0;
    Index next = 0;
    for (Index& n : number)
      if (n != none) n = next++;
    return number;
  }

  /// The groups of the cells of a region, as `region_of` sorts them.
  std::vector<int> groups_of(int region) const {
    for (const auto& [groups, shared] : shared_)
      if (shared == region) return groups;
    return region == 0 ? std::vector<int>() : std::vector{region};
  }

  /// A mesh must not contain a cell twice, but format 2.2 repeats it for each of its physical groups: of two
  /// copies each must be in a group that the other is not in.
  void join_repeated_cells(const MeshInput& in) {
    const Lists by_lowest_node(tags_.size(), [&](auto&& add) {
      for (std::size_t c = 0; c < result_.cells.size(); ++c)
        add(*std::min_element(result_.cells[c].begin(), result_.cells[c].end()), static_cast<Index>(c));
    });
    std::vector<char> again(result_.cells.size());
    // Cells of one lowest node, each with ascending nodes.
    std::vector<std::pair<std::array<Index, D + 1>, Index>> sorted;
    for (std::size_t i = 0; i < tags_.size(); ++i) {
      sorted.clear();
      for (const Index c : by_lowest_node[i]) {
        sorted.emplace_back(result_.cells[c], c);
        std::sort(sorted.back().first.begin(), sorted.back().first.end(), MapOrder());
      }
      std::sort(sorted.begin(), sorted.end(), MapOrder());
      for (std::size_t k = 0, next; k < sorted.size(); k = next) {
        next = k + 1;
        if (next == sorted.size() || sorted[next].first != sorted[k].first) continue;
        Map<std::vector<int>, int> all{{groups_of(result_.region[sorted[k].second]), 0}};
        for (; next < sorted.size() && sorted[next].first == sorted[k].first; ++next) {
          again[sorted[next].second] = true;
          auto own = groups_of(result_.region[sorted[next].second]);
          if (!repeats_ || std::ranges::any_of(all, [&](const auto& other) {
                return std::ranges::includes(own, other.first, MapOrder()) ||
                       std::ranges::includes(other.first, own, MapOrder());
              })) {
            std::string nodes;
            for (const Index node : sorted[k].first)
              nodes += joined_text({nodes.empty() ? "" : " ", tags_[node]});
            in.refuse("nodes of a cell", nodes, "the cell is given twice");
          }
          all.try_emplace(std::move(own), 0);
        }
        std::vector<int> groups;
        for (const auto& own : all)
          for (const int group : own.first) groups.push_back(group);
        result_.region[sorted[k].second] = region_of(std::move(groups));
      }
    }
    std::size_t kept = 0;
    for (std::size_t c = 0; c < again.size(); ++c) {
      if (again[c]) continue;
      result_.cells[kept] = result_.cells[c];
      result_.region[kept++] = result_.region[c];
    }
    result_.cells.resize(kept);
    result_.region.resize(kept);
  }

  /// All nodes of a plane mesh share one z, to 1e-9 of the mesh's size.
  void refuse_curved(const MeshInput& in, const std::vector<Index>& number) const {
    std::array<double, 2> low{}, high{};
    std::size_t first = number.size();
    for (std::size_t i = 0; i < number.size(); ++i) {
      if (number[i] == none) continue;
      for (std::size_t k = 0; k < 2; ++k) {
        low[k] = first == number.size() ? positions_[i][k] : std::min(low[k], positions_[i][k]);
        high[k] = first == number.size() ? positions_[i][k] : std::max(high[k], positions_[i][k]);
      }
      first = std::min(first, i);
    }
    const double tolerance = 1e-9 * std::max(high[0] - low[0], high[1] - low[1]);
    for (std::size_t i = 0; i < number.size(); ++i)
      if (number[i] != none && !(std::abs(positions_[i][2] - positions_[first][2]) <= tolerance))
        in.refuse(
            joined_text({"z of node ", tags_[i]}), positions_[i][2],
            joined_text({"must be ", positions_[first][2], ", as all nodes of a plane mesh share one z"}));
  }

  std::vector<std::uint64_t> tags_;                    // [nodes] ascending once `end_nodes` is done
  std::vector<std::array<double, 3>> positions_;       // [nodes]
  std::vector<Index> index_;                           // index by tag minus lowest tag; empty: search
  Map<std::pair<int, int>, std::string> names_;        // of a group: (dimension, tag)
  Map<std::pair<int, int>, std::vector<Index>> sets_;  // nodes of a group below dimension D
  Map<std::vector<int>, int> shared_;                  // region of the cells of several groups
  bool repeats_ = false;
  MeshData<D> result_;
};

}  // namespace arenite::inline ARENITE_INSTRUCTION_SET::shared_detail
