// Blocks of cells in colours: blocks of one colour share no node, so that threads scatter to nodes without
// atomics and each node's order of summation is the same for any number of threads.
#pragma once
// SPDX-License-Identifier: BSD-3-Clause

#include <algorithm>
#include <span>
#include <vector>

#include <arenite/core/cold.hpp>
#include <arenite/core/lists.hpp>
#include <arenite/core/scalar.hpp>
#include <arenite/parallel/array_memory.hpp>
#include <arenite/parallel/parallel.hpp>

namespace arenite::inline ARENITE_INSTRUCTION_SET {

/// A partition of the cells [0, n) into runs of consecutive cells, and of the runs into colours.
class Blocks {
 public:
  Blocks() = default;

  /// Greedy colouring of blocks of `size` consecutive cells. `nodes_of(cell)` gives a range of node numbers
  /// below `node_count`. Cost: one pass over cells x nodes.
  template <class NodesOf>
  Blocks(Index cell_count, Index node_count, Index size, const NodesOf& nodes_of)
      : Blocks(cell_count, node_count, size,
               CellNodes{[](const void* of, Index cell, std::vector<Index>& nodes) {
                           const auto& all = (*static_cast<const NodesOf*>(of))(cell);
                           nodes.assign(all.begin(), all.end());
                         },
                         &nodes_of}) {}

  /// Gives each thread a share of the blocks with an equal sum of `work(cell)`, a number of points, the same
  /// in every loop: what it touched is still in its cache.
  template <class Work>
  void balance_threads(Work&& work) {
    work_before_.resize(count() + 1);
    for (Index b = 0; b < count(); ++b) {
      std::size_t sum = 0;
      for (Index c = begin(b); c < end(b); ++c) sum += work(c);
      work_before_[b + 1] = work_before_[b] + sum;
    }
  }

  std::size_t colors() const { return of_color_.size(); }
  std::size_t count() const { return (std::size_t{cells_} + size_ - 1) / size_; }
  /// Blocks of a colour, ascending.
  std::span<const Index> of_color(std::size_t k) const { return of_color_[k]; }
  Index begin(Index block) const { return block * size_; }
  Index end(Index block) const { return std::min(cells_, (block + 1) * size_); }

  /// Calls `f(cell)` for all cells; cells whose blocks share a node never run at once, and those that share
  /// a node run in the same order for any number of threads.
  template <class F>
  void for_each_colored(F&& f) const {
    for (std::size_t k = 0; k < colors(); ++k) {
      const auto blocks = of_color(k);
      parallel_for(
          blocks.size(), worthwhile(),
          [&](std::size_t i) {
            for (Index c = begin(blocks[i]); c < end(blocks[i]); ++c) f(c);
          },
          [&](std::size_t t, std::size_t parts) {
            const auto at = std::lower_bound(blocks.begin(), blocks.end(), first_of_part(t, parts));
            return static_cast<std::size_t>(at - blocks.begin());
          });
    }
  }

  /// Calls `f(cell)` for all cells, in any order: for work that writes to no node.
  template <class F>
  void for_each(F&& f) const {
    for_each_block([&](std::size_t, Index first, Index last) {
      for (Index c = first; c < last; ++c) f(c);
    });
  }

  /// Calls `f(block, begin, end)` for all blocks, with the cells [begin, end) of each, in any order.
  template <class F>
  void for_each_block(F&& f) const {
    parallel_for(
        count(), worthwhile(),
        [&](std::size_t b) {
          const auto block = static_cast<Index>(b);
          f(b, begin(block), end(block));
        },
        [&](std::size_t t, std::size_t parts) { return std::size_t{first_of_part(t, parts)}; });
  }

  /// Joins `f(begin, end)` over all blocks of cells, in order.
  template <class R, class F, class Join>
  R reduce_blocks(R start, F&& f, Join&& join) const {
    ReductionParts<R> part(count(), start);
    for_each_block([&](std::size_t b, Index first, Index last) { part[b] = f(first, last); });
    for (const R& p : part) start = join(start, p);
    return start;
  }

  /// Joins `f(cell)` over all cells: block by block, in order.
  template <class R, class F, class Join>
  R reduce(R start, F&& f, Join&& join) const {
    return reduce_blocks(
        start,
        [&](Index first, Index last) {
          R sum = start;
          for (Index c = first; c < last; ++c) sum = join(sum, f(c));
          return sum;
        },
        join);
  }

 private:
  /// Puts the nodes of a cell into a list.
  struct CellNodes {
    void (*list)(const void* of, Index cell, std::vector<Index>& nodes);
    const void* of;
  };
  Blocks(Index cell_count, Index node_count, Index size, CellNodes nodes_of);

  /// Fewer cells than this do not pay for threads.
  bool worthwhile() const { return cells_ >= 1000; }

  /// The first block of share t of `parts`.
  Index first_of_part(std::size_t t, std::size_t parts) const {
    if (work_before_.empty()) return static_cast<Index>(count() * t / parts);
    const std::size_t before = work_before_.back() * t / parts;
    const auto at = std::lower_bound(work_before_.begin(), work_before_.end() - 1, before);
    return static_cast<Index>(at - work_before_.begin());
  }

  Index cells_ = 0;
  Index size_ = 1;
  Lists of_color_;                          // [colours] the blocks of each
  std::vector<std::size_t> work_before_{};  // [blocks + 1] sum of the work of all blocks before
};

}  // namespace arenite::inline ARENITE_INSTRUCTION_SET

#if ARENITE_HAS_COLD

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

#endif  // ARENITE_HAS_COLD
