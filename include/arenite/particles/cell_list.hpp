// Cell list: which points lie in which cell. The points of a cell are neighbours in memory; one that moves to
// another cell becomes an unsorted point there until all are regrouped.
#pragma once
// SPDX-License-Identifier: BSD-3-Clause

#include <algorithm>
#include <numeric>
#include <span>
#include <vector>

#include <arenite/core/cold.hpp>
#include <arenite/core/error.hpp>
#include <arenite/core/lists.hpp>
#include <arenite/core/scalar.hpp>
#include <arenite/mesh/blocks.hpp>

namespace arenite::inline ARENITE_INSTRUCTION_SET {

/// Points of each cell: a run of neighbours that it owns, and unsorted points, whose columns lie where their
/// old cell's run ended. A step moves few points (0.5 % is common), so that a list of unsorted points costs
/// far less than a new order.
class CellList {
 public:
  /// A change of cell.
  struct Move {
    Index point, to;
    bool from_run = false;  ///< whether its cell owned the point until now
  };

  /// Takes points that are sorted by cell. Throws `error` if they are not.
  void build(const std::vector<Index>& cell, Index cell_count);
  /// Reserves the memory that relocation of `points` points needs, so that a step allocates nothing.
  void reserve(std::size_t points) {
    unsorted_.reserve(points / 8 + 64);
    all_unsorted_.reserve(points / 8 + 64);
    next_.reserve(start_.size());
    order_.reserve(points);
  }

  /// The order of points that puts those of each cell side by side, its unsorted points after its own.
  /// Points of cell `none` are left out. Call `take_order` once the columns have this order.
  const std::vector<Index>& order(const Blocks& blocks) {
    next_.assign(start_.size(), 0);
    for (Index c = 0; c < owned_.size(); ++c)
      next_[c + 1] = next_[c] + owned_[c] + static_cast<Index>(unsorted_[c].size());
    order_.resize(next_.back());
    blocks.for_each_block([&](std::size_t, Index begin, Index end) {
      for (Index c = begin; c < end; ++c) {
        const auto own = order_.begin() + next_[c], behind = own + owned_[c];
        std::iota(own, behind, start_[c]);
        std::copy(unsorted_[c].begin(), unsorted_[c].end(), behind);
      }
    });
    return order_;
  }
  void take_order() {
    start_.swap(next_);
    own_all();
  }

  /// Takes a point out of its cell; `swap(a, b)` exchanges two points' columns. A point that its cell owns
  /// changes places with the last of the run first; `move.point` is its place from then on. Moves of one cell
  /// must come with its last point first; those of different cells may be taken at the same time. Call
  /// `admit` for each, then `list_unsorted`.
  template <class Swap>
  void leave(Move& move, std::vector<Index>& cell, Swap&& swap) {
    const Index from = cell[move.point];
    // A point far from its cell's run is not the run's: the count of a cell of other blocks may change meanwhile.
    move.from_run = move.point >= start_[from] && move.point < start_[from + 1] &&
                    move.point - start_[from] < owned_[from];
    if (move.from_run) {
      const Index last = start_[from] + --owned_[from];
      if (move.point != last) swap(move.point, last);
      move.point = last;
    }
    cell[move.point] = move.to;
  }

  /// Makes a point that has left its cell an unsorted point.
  void admit(const Move& move) {
    if (move.from_run) all_unsorted_.push_back(move.point);
  }

  /// Makes a new point, placed after all others, an unsorted point.
  void admit_new(Index point) { all_unsorted_.push_back(point); }

  /// Lists the unsorted points by cell; those of cell `none` are left out.
  void list_unsorted(const std::vector<Index>& cell) {
    unsorted_.build(owned_.size(), [&](auto&& add) {
      for (const Index p : all_unsorted_)
        if (cell[p] != none) add(cell[p], p);
    });
  }

  /// End of the run of neighbours that point p of a cell belongs to; an unsorted point is a run of one.
  Index run_end(Index p, Index cell) const {
    return p - start_[cell] < owned_[cell] ? start_[cell] + owned_[cell] : p + 1;
  }

  /// Entries of the lists of all cells before this one: its own begin here when they stand in one row.
  std::size_t offset(Index cell) const { return std::size_t{start_[cell]} + unsorted_.before(cell); }

  std::size_t unsorted() const { return all_unsorted_.size(); }
  /// The unsorted points of all cells, in the order of their moves.
  const std::vector<Index>& all_unsorted() const { return all_unsorted_; }

  /// Calls `f(point, count)` for the points of a cell, at most `Width` neighbours at a time.
  template <int Width, class F>
  void for_packs(Index cell, F&& f) const {
    Index p = start_[cell], g = unsorted_.before(cell);
    const Index end = p + owned_[cell], unsorted_end = unsorted_.before(cell + 1);
    for (;;) {  // one call of f, so that it is compiled into the loop once
      Index first, left;
      if (p < end) {
        first = p;
        left = end - p;
        p += Width;
      } else if (g < unsorted_end) {
        first = unsorted_.values()[g++];
        left = 1;
      } else {
        break;
      }
      f(first, static_cast<int>(left < Width ? left : Width));
    }
  }

  /// Calls `f(point, count)` for the points that lie in the memory of the runs of cells [begin, end), whatever their cells, at most
  /// `Width` neighbours at a time. Those after all runs, up to `points`, belong to the last cell's.
  template <int Width, class F>
  void for_packs_in_memory(Index begin, Index end, std::size_t points, F&& f) const {
    const Index last = end == owned_.size() ? static_cast<Index>(points) : start_[end];
    for (Index p = start_[begin]; p < last; p += Width)
      f(p, static_cast<int>(std::min<Index>(Width, last - p)));
  }

  /// The points of a cell, for a loop: `for (const Index p : cells[c])`.
  class Range {
   public:
    class Iterator {
     public:
      Iterator(Index own, Index own_end, const Index* unsorted_point)
          : own_{own}, own_end_{own_end}, unsorted_{unsorted_point} {}
      Index operator*() const { return own_ < own_end_ ? own_ : *unsorted_; }
      Iterator& operator++() {
        if (own_ < own_end_)
          ++own_;
        else
          ++unsorted_;
        return *this;
      }
      bool operator==(const Iterator& o) const { return own_ == o.own_ && unsorted_ == o.unsorted_; }

     private:
      Index own_, own_end_;
      const Index* unsorted_;
    };
    Range(Index own, Index own_end, const Index* unsorted_point, const Index* unsorted_end)
        : own_{own}, own_end_{own_end}, unsorted_{unsorted_point}, unsorted_end_{unsorted_end} {}
    Iterator begin() const { return {own_, own_end_, unsorted_}; }
    Iterator end() const { return {own_end_, own_end_, unsorted_end_}; }
    std::size_t size() const { return own_end_ - own_ + static_cast<std::size_t>(unsorted_end_ - unsorted_); }
    bool empty() const { return size() == 0; }

   private:
    Index own_, own_end_;
    const Index *unsorted_, *unsorted_end_;
  };
  Range operator[](Index cell) const {
    const auto unsorted = unsorted_[cell];
    return {start_[cell], start_[cell] + owned_[cell], unsorted.data(), unsorted.data() + unsorted.size()};
  }
  bool empty(Index cell) const {
    return owned_[cell] == 0 && unsorted_.before(cell) == unsorted_.before(cell + 1);
  }

  /// Runs and unsorted points; the rest follows from them and the points' cells.
  template <class F>
  void visit_state(F&& f) {
    f("runs", std::span(start_));
    f("unsorted", all_unsorted_);
  }
  /// Renews the rest. Throws `error` if it is no list of these points.
  void follow_state(const std::vector<Index>& cell, Index cell_count) {
    bool fits = start_.size() == std::size_t{cell_count} + 1 && start_.front() == 0 &&
                start_.back() <= cell.size() && std::is_sorted(start_.begin(), start_.end());
    std::vector<bool> is_unsorted(cell.size());
    for (const Index p : all_unsorted_) {
      fits = fits && p < cell.size() && !is_unsorted[p] && cell[p] < cell_count;
      if (!fits) break;
      is_unsorted[p] = true;
    }
    if (fits) {
      owned_.assign(cell_count, 0);
      for (Index c = 0; c < cell_count; ++c)
        for (Index p = start_[c]; p < start_[c + 1]; ++p) {
          if (is_unsorted[p]) continue;
          fits = fits && cell[p] == c && p == start_[c] + owned_[c];
          ++owned_[c];
        }
      for (std::size_t p = start_.back(); p < cell.size(); ++p) fits = fits && is_unsorted[p];
    }
    require(fits, "state: cells", cell_count, "runs and unsorted must list each point once");
    list_unsorted(cell);
  }

  std::size_t bytes() const {
    return (start_.size() + owned_.size() + all_unsorted_.size() + next_.size() + order_.size()) *
               sizeof(Index) +
           unsorted_.bytes();
  }

 private:
  /// Lists the points as `start_` has them, without unsorted points.
  void own_all() {
    for (std::size_t c = 0; c < owned_.size(); ++c) owned_[c] = start_[c + 1] - start_[c];
    all_unsorted_.clear();
    unsorted_.build(owned_.size(), [](auto&&) {});
  }

  std::vector<Index> start_;         // [cells + 1] first point of each cell's run
  std::vector<Index> owned_;         // [cells] points of the run that are still in the cell
  Lists unsorted_;                   // [cells]
  std::vector<Index> all_unsorted_;  // in the order of their moves
  std::vector<Index> next_, order_;  // scratch
};

}  // namespace arenite::inline ARENITE_INSTRUCTION_SET

#if ARENITE_HAS_COLD

namespace arenite::inline ARENITE_INSTRUCTION_SET {

ARENITE_COLD void CellList::build(const std::vector<Index>& cell, Index cell_count) {
  require(std::is_sorted(cell.begin(), cell.end()), "CellList: points", cell.size(),
          "must be sorted by cell");
  begin_rows(start_, cell_count, [&](auto&& count) {
    for (const Index c : cell) count(c);
  });
  owned_.resize(cell_count);
  own_all();
  reserve(cell.size());
}

}  // namespace arenite::inline ARENITE_INSTRUCTION_SET

#endif  // ARENITE_HAS_COLD
