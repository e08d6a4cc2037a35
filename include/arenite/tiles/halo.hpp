// Halo: where the copies of shared nodes are, for the tiles of one rank.
#pragma once
// SPDX-License-Identifier: BSD-3-Clause

#include <algorithm>
#include <array>
#include <cstddef>
#include <map>
#include <utility>
#include <vector>

#include <arenite/mesh/portion.hpp>
#include <arenite/tiles/split_grid.hpp>

namespace arenite::inline ARENITE_INSTRUCTION_SET {

/// [nodes of the whole mesh] the tiles that have a copy of a node, ascending, where they are at least two; else none. A tile has its
/// own cells, and those that share a node with one of them.
template <int D>
std::vector<std::vector<int>> copies_of_nodes(const MeshData<D>& whole, const std::vector<int>& tile) {
  const auto add = [](std::vector<int>& to, int t) {
    const auto at = std::ranges::lower_bound(to, t);
    if (at == to.end() || *at != t) to.insert(at, t);
  };
  std::vector<std::vector<int>> touching(whole.nodes.size()), copies(whole.nodes.size());
  for (std::size_t c = 0; c < whole.cells.size(); ++c)
    for (const Index i : whole.cells[c]) add(touching[i], tile[c]);
  for (const auto& nodes : whole.cells)
    for (const Index i : nodes)
      for (const int t : touching[i])
        for (const Index j : nodes) add(copies[j], t);
  for (auto& tiles : copies)
    if (tiles.size() < 2) tiles.clear();
  return copies;
}

/// Copies of the nodes that the tiles of a rank share with each other and with those of other ranks. Numbers at them travel in
/// buffers: one of each tile here with all its shared nodes, and one of each other rank with those of its nodes that have a copy here.
struct Halo {
  /// A copy in one of the buffers.
  struct Place {
    std::size_t buffer = 0, node = 0;
  };
  struct Tile {
    std::vector<Index> nodes;        ///< shared ones, by their numbers in the tile
    std::vector<std::size_t> first;  ///< [nodes + 1] of a node's copies in `copies`
    std::vector<Place> copies;       ///< of each node, in the order of the tiles: that of sums
    std::vector<Place> owned;        ///< [nodes] the copy of the tile that owns the node
  };
  struct Neighbour {
    int rank = 0;
    std::vector<Place> sent;   ///< copies here of nodes that have one there, in the order of tiles and nodes
    std::size_t received = 0;  ///< nodes in its buffer
  };
  std::vector<Tile> tiles;            ///< of this rank, in their order
  std::vector<Neighbour> neighbours;  ///< other ranks with copies of the same nodes, ascending
};

/// [nodes of the windows `here`] the tiles whose window has a node, by its number in the whole grid. `nodes`: [tiles] the nodes of each
/// window, by their places along the axes; `count`: of the whole grid along each axis.
template <int D>
class CopiesInWindows {
 public:
  CopiesInWindows(std::vector<CellRange<D>> nodes,
                  const std::array<Index, static_cast<std::size_t>(D)>& count)
      : nodes_{std::move(nodes)}, count_{count} {}

  const std::vector<int>& operator()(int tile, std::uint64_t node) {
    if (tile != looked_at_) look_near(tile);
    std::array<Index, static_cast<std::size_t>(D)> at;
    for (std::size_t k = 0; k < at.size(); ++k) {
      at[k] = static_cast<Index>(node % count_[k]);
      node /= count_[k];
    }
    found_.clear();
    for (const int t : near_)
      if (nodes_[static_cast<std::size_t>(t)].holds(at)) found_.push_back(t);
    if (found_.size() < 2) found_.clear();
    return found_;
  }

 private:
  /// Looks from here on only at the tiles that share nodes with this one.
  void look_near(int tile) {
    looked_at_ = tile;
    near_.clear();
    for (std::size_t t = 0; t < nodes_.size(); ++t)
      if (nodes_[t].meets(nodes_[static_cast<std::size_t>(tile)])) near_.push_back(static_cast<int>(t));
  }

  std::vector<CellRange<D>> nodes_;
  std::array<Index, static_cast<std::size_t>(D)> count_;
  std::vector<int> near_{}, found_{};
  int looked_at_ = -1;
};

/// The halo of a rank. `copies(tile, node)`: the tiles that have a copy of a node of a tile, ascending, none where it is the only one;
/// `rank_of`: [tiles]; `here`: portions of the tiles of the rank, in their order.
template <int D, class Copies>
Halo make_halo(Copies&& copies, const std::vector<int>& rank_of, int rank,
               const std::vector<const MeshPortion<D>*>& here) {
  using Copy = std::pair<int, std::uint64_t>;  // tile, node of the whole mesh
  std::map<Copy, Halo::Place> place;
  std::map<int, std::vector<Copy>> from, to;  // by rank
  Halo halo;
  halo.tiles.resize(here.size());
  for (std::size_t t = 0; t < here.size(); ++t) {
    const auto& portion = *here[t];
    for (Index i = 0; i < portion.whole_node.size(); ++i) {
      const auto& tiles = copies(portion.number, portion.whole_node[i]);
      if (tiles.empty()) continue;
      const Copy own{portion.number, portion.whole_node[i]};
      place[own] = {t, halo.tiles[t].nodes.size()};
      halo.tiles[t].nodes.push_back(i);
      for (const int other : tiles) {
        const int r = rank_of[static_cast<std::size_t>(other)];
        if (r == rank) continue;
        from[r].push_back({other, own.second});
        to[r].push_back(own);
      }
    }
  }
  for (auto& [r, nodes] : from) {
    const auto unique = [](std::vector<Copy>& all) {
      std::ranges::sort(all);
      all.erase(std::unique(all.begin(), all.end()), all.end());
    };
    unique(nodes);
    unique(to[r]);
    auto& neighbour = halo.neighbours.emplace_back();
    neighbour.rank = r;
    neighbour.received = nodes.size();
    for (const auto& copy : to[r]) neighbour.sent.push_back(place.at(copy));
    for (std::size_t k = 0; k < nodes.size(); ++k)
      place[nodes[k]] = {here.size() + halo.neighbours.size() - 1, k};
  }
  for (std::size_t t = 0; t < here.size(); ++t) {
    auto& tile = halo.tiles[t];
    tile.first.push_back(0);
    for (const Index i : tile.nodes) {
      const std::uint64_t node = here[t]->whole_node[i];
      for (const int other : copies(here[t]->number, node)) tile.copies.push_back(place.at({other, node}));
      tile.first.push_back(tile.copies.size());
      tile.owned.push_back(place.at({here[t]->node_owner[i], node}));
    }
  }
  return halo;
}

}  // namespace arenite::inline ARENITE_INSTRUCTION_SET
