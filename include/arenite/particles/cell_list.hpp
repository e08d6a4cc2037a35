// Cell list: which points lie in which cell. The points of a cell are neighbours in memory; one that moves to
// another cell becomes a guest there until all are regrouped.
#pragma once

#include <algorithm>
#include <numeric>
#include <vector>

#include <arenite/core/error.hpp>
#include <arenite/core/scalar.hpp>
#include <arenite/mesh/blocks.hpp>

namespace arenite::inline ARENITE_INSTRUCTION_SET {

/// Points of each cell: a run of neighbours that it owns, and guests, whose columns lie where their old
/// cell's run ended. A step moves few points (0.5 % is common), so that a list of guests costs far less than
/// a new order.
class CellList {
 public:
  /// A change of cell.
  struct Move {
    Index point, to;
    bool from_run = false;  ///< whether its cell owned the point until now
  };

  /// Takes points that are sorted by cell. Throws `error` if they are not.
  void build(const std::vector<Index>& cell, Index cell_count) {
    require(std::is_sorted(cell.begin(), cell.end()), "CellList: points", cell.size(),
            "must be sorted by cell");
    start_.assign(cell_count + 1, 0);
    for (const Index c : cell) ++start_[c + 1];
    for (std::size_t c = 1; c < start_.size(); ++c) start_[c] += start_[c - 1];
    owned_.resize(cell_count);
    own_all();
    reserve(cell.size());
  }
  /// Takes the memory that relocation of so many points needs, so that a step allocates nothing.
  void reserve(std::size_t points) {
    guests_.reserve(points / 8 + 64);
    all_guests_.reserve(points / 8 + 64);
    next_.reserve(start_.size());
    order_.reserve(points);
  }

  /// The order of points that puts those of each cell side by side, its guests behind its own. Points of cell
  /// `none` are left out. Call `take_order` once they stand so.
  const std::vector<Index>& order(const Blocks& blocks) {
    next_.assign(start_.size(), 0);
    for (Index c = 0; c < owned_.size(); ++c)
      next_[c + 1] = next_[c] + owned_[c] + guest_start_[c + 1] - guest_start_[c];
    order_.resize(next_.back());
    blocks.for_each_block([&](std::size_t, Index begin, Index end) {
      for (Index c = begin; c < end; ++c) {
        const auto own = order_.begin() + next_[c], guests = own + owned_[c];
        std::iota(own, guests, start_[c]);
        std::copy(guests_.begin() + guest_start_[c], guests_.begin() + guest_start_[c + 1], guests);
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
  /// `admit` for each, then `list_guests`.
  template <class Swap>
  void leave(Move& move, std::vector<Index>& cell, Swap&& swap) {
    const Index from = cell[move.point];
    move.from_run = move.point - start_[from] < owned_[from];
    if (move.from_run) {
      const Index last = start_[from] + --owned_[from];
      if (move.point != last) swap(move.point, last);
      move.point = last;
    }
    cell[move.point] = move.to;
  }

  /// Makes a point that has left its cell a guest.
  void admit(const Move& move) {
    if (move.from_run) all_guests_.push_back(move.point);
  }

  /// Makes a point that is new, behind all others, a guest.
  void admit_new(Index point) { all_guests_.push_back(point); }

  /// Lists the guests by cell; those of cell `none` are left out.
  void list_guests(const std::vector<Index>& cell) {
    guest_start_.assign(guest_start_.size(), 0);
    for (const Index p : all_guests_)
      if (cell[p] != none) ++guest_start_[cell[p] + 1];
    for (std::size_t c = 1; c < guest_start_.size(); ++c) guest_start_[c] += guest_start_[c - 1];
    guests_.resize(guest_start_.back());
    next_.assign(guest_start_.begin(), guest_start_.end());
    for (const Index p : all_guests_)
      if (cell[p] != none) guests_[next_[cell[p]]++] = p;
  }

  /// Where the run of neighbours ends that point p of a cell belongs to: a guest is alone.
  Index run_end(Index p, Index cell) const {
    return p - start_[cell] < owned_[cell] ? start_[cell] + owned_[cell] : p + 1;
  }

  /// Entries of the lists of all cells before this one: its own begin here when they stand in one row.
  std::size_t offset(Index cell) const { return std::size_t{start_[cell]} + guest_start_[cell]; }

  std::size_t guests() const { return all_guests_.size(); }
  /// The guests of all cells, in the order of their moves.
  const std::vector<Index>& all_guests() const { return all_guests_; }

  /// Calls `f(point, count)` for the points of a cell, at most `Width` neighbours at a time.
  template <int Width, class F>
  void for_packs(Index cell, F&& f) const {
    Index p = start_[cell], g = guest_start_[cell];
    const Index end = p + owned_[cell], guest_end = guest_start_[cell + 1];
    for (;;) {  // one call of f, so that it is compiled into the loop once
      Index first, left;
      if (p < end) {
        first = p;
        left = end - p;
        p += Width;
      } else if (g < guest_end) {
        first = guests_[g++];
        left = 1;
      } else {
        break;
      }
      f(first, static_cast<int>(left < Width ? left : Width));
    }
  }

  /// The points of a cell, for a loop: `for (const Index p : cells[c])`.
  class Range {
   public:
    class Iterator {
     public:
      Iterator(Index own, Index own_end, const Index* guest) : own_{own}, own_end_{own_end}, guest_{guest} {}
      Index operator*() const { return own_ < own_end_ ? own_ : *guest_; }
      Iterator& operator++() {
        if (own_ < own_end_)
          ++own_;
        else
          ++guest_;
        return *this;
      }
      bool operator==(const Iterator& o) const { return own_ == o.own_ && guest_ == o.guest_; }

     private:
      Index own_, own_end_;
      const Index* guest_;
    };
    Range(Index own, Index own_end, const Index* guest, const Index* guest_end)
        : own_{own}, own_end_{own_end}, guest_{guest}, guest_end_{guest_end} {}
    Iterator begin() const { return {own_, own_end_, guest_}; }
    Iterator end() const { return {own_end_, own_end_, guest_end_}; }
    std::size_t size() const { return own_end_ - own_ + static_cast<std::size_t>(guest_end_ - guest_); }
    bool empty() const { return size() == 0; }

   private:
    Index own_, own_end_;
    const Index *guest_, *guest_end_;
  };
  Range operator[](Index cell) const {
    return {start_[cell], start_[cell] + owned_[cell], guests_.data() + guest_start_[cell],
            guests_.data() + guest_start_[cell + 1]};
  }
  bool empty(Index cell) const { return owned_[cell] == 0 && guest_start_[cell] == guest_start_[cell + 1]; }

  /// Runs and guests; the rest follows from them and the points' cells.
  template <class F>
  void visit_state(F&& f) {
    f("runs", start_);
    f("guests", all_guests_);
  }
  /// Renews the rest. Throws `error` if it is no list of these points.
  void follow_state(const std::vector<Index>& cell, Index cell_count) {
    bool fits = start_.size() == std::size_t{cell_count} + 1 && start_.front() == 0 &&
                start_.back() <= cell.size() && std::is_sorted(start_.begin(), start_.end());
    std::vector<bool> is_guest(cell.size());
    for (const Index p : all_guests_) {
      fits = fits && p < cell.size() && !is_guest[p] && cell[p] < cell_count;
      if (!fits) break;
      is_guest[p] = true;
    }
    if (fits) {
      owned_.assign(cell_count, 0);
      for (Index c = 0; c < cell_count; ++c)
        for (Index p = start_[c]; p < start_[c + 1]; ++p) {
          if (is_guest[p]) continue;
          fits = fits && cell[p] == c && p == start_[c] + owned_[c];
          ++owned_[c];
        }
      for (std::size_t p = start_.back(); p < cell.size(); ++p) fits = fits && is_guest[p];
    }
    require(fits, "state: cells", cell_count, "runs and guests must list each point once");
    guest_start_.resize(start_.size());
    list_guests(cell);
  }

  std::size_t bytes() const {
    return (start_.size() + owned_.size() + guest_start_.size() + guests_.size() + all_guests_.size() +
            next_.size() + order_.size()) *
           sizeof(Index);
  }

 private:
  /// Lists the points as `start_` has them, without guests.
  void own_all() {
    for (std::size_t c = 0; c < owned_.size(); ++c) owned_[c] = start_[c + 1] - start_[c];
    guest_start_.assign(start_.size(), 0);
    guests_.clear();
    all_guests_.clear();
  }

  std::vector<Index> start_;         // [cells + 1] first point of each cell's run
  std::vector<Index> owned_;         // [cells] points of the run that are still in the cell
  std::vector<Index> guest_start_;   // [cells + 1] into guests_
  std::vector<Index> guests_;        // by cell
  std::vector<Index> all_guests_;    // in the order of their moves
  std::vector<Index> next_, order_;  // scratch
};

}  // namespace arenite::inline ARENITE_INSTRUCTION_SET
