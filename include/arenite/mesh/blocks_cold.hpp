// Cold functions of blocks.hpp.
#pragma once
// SPDX-License-Identifier: BSD-3-Clause

#include <arenite/mesh/blocks.hpp>

namespace arenite::inline ARENITE_INSTRUCTION_SET {

ARENITE_COLD Blocks::Blocks(Index cell_count, Index node_count, Index size, CellNodes nodes_of)
    : cells_{cell_count}, size_{std::max<Index>(size, 1)} {
  const Index blocks = (cell_count + size_ - 1) / size_;
  std::vector<Index> color_of(blocks, 0);
  std::vector<std::vector<Index, ArrayMemory<Index>>>
      last;  // [color][node] the last block of that colour at that node
  std::vector<Index> nodes;
  const auto is_free = [&](Index block, const std::vector<Index, ArrayMemory<Index>>& taken) {
    for (Index c = begin(block); c < end(block); ++c) {
      nodes_of.list(nodes_of.of, c, nodes);
      for (const Index node : nodes)
        if (taken[node] != none && taken[node] != block) return false;
    }
    return true;
  };
  for (Index b = 0; b < blocks; ++b) {
    Index color = 0;
    for (;; ++color) {
      if (color == last.size()) last.emplace_back(node_count, none);
      if (is_free(b, last[color])) break;
    }
    for (Index c = begin(b); c < end(b); ++c) {
      nodes_of.list(nodes_of.of, c, nodes);
      for (const Index node : nodes) last[color][node] = b;
    }
    color_of[b] = color;
  }
  of_color_.build(last.size(), [&](auto&& add) {
    for (Index b = 0; b < blocks; ++b) add(color_of[b], b);
  });
}

}  // namespace arenite::inline ARENITE_INSTRUCTION_SET
