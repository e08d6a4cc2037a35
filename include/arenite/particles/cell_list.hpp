// Cell list: which points lie in which cell. After a sort the points of a cell are neighbours in memory; a
// point that moves to another cell becomes a guest there until the next sort.
#pragma once

#include <algorithm>
#include <vector>

#include <arenite/core/error.hpp>
#include <arenite/core/scalar.hpp>

namespace arenite {

/// Points of each cell: a run of neighbours that it owns, and guests, whose columns lie where their old
/// cell's run ended. A step moves few points (0.5 % is common), so that a list of guests costs far less than
/// a sort.
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
    sorted(cell, cell_count);
    owned_.resize(cell_count);
    take_sorted();
    // Room for what relocation lets come together before it sorts, so that a step allocates nothing.
    guests_.reserve(cell.size() / 8 + 64);
    all_guests_.reserve(cell.size() / 8 + 64);
    next_.reserve(cell_count + 1);
  }

  /// The order that sorts points by cell, stable; those of cell `none` are left out.
  const std::vector<Index>& sorted(const std::vector<Index>& cell, Index cell_count) {
    start_.assign(cell_count + 1, 0);
    std::size_t kept = 0;
    for (const Index c : cell) {
      if (c == none) continue;
      ++start_[c + 1];
      ++kept;
    }
    for (std::size_t c = 1; c < start_.size(); ++c) start_[c] += start_[c - 1];
    next_.assign(start_.begin(), start_.end());
    order_.resize(kept);
    for (std::size_t p = 0; p < cell.size(); ++p)
      if (cell[p] != none) order_[next_[cell[p]]++] = static_cast<Index>(p);
    return order_;
  }

  /// Lists the points as `sorted` has put them, once they stand in that order.
  void take_sorted() {
    for (std::size_t c = 0; c < owned_.size(); ++c) owned_[c] = start_[c + 1] - start_[c];
    guest_start_.assign(start_.size(), 0);
    guests_.clear();
    all_guests_.clear();
  }

  /// Takes a point out of its cell; `swap(a, b)` exchanges two points' columns. A point that its cell owns
  /// changes places with the last of the run first; `move.point` is its place from then on. Moves of one cell
  /// must come with its last point first; those of different cells may be taken at the same time. Call
  /// `admit` for each, then `seat_guests`.
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

  /// Lists the guests by cell.
  void seat_guests(const std::vector<Index>& cell) {
    guest_start_.assign(guest_start_.size(), 0);
    for (const Index p : all_guests_) ++guest_start_[cell[p] + 1];
    for (std::size_t c = 1; c < guest_start_.size(); ++c) guest_start_[c] += guest_start_[c - 1];
    guests_.resize(all_guests_.size());
    next_.assign(guest_start_.begin(), guest_start_.end());
    for (const Index p : all_guests_) guests_[next_[cell[p]]++] = p;
  }

  /// Where the run of neighbours ends that point p of a cell belongs to: a guest is alone.
  Index run_end(Index p, Index cell) const {
    return p - start_[cell] < owned_[cell] ? start_[cell] + owned_[cell] : p + 1;
  }

  /// Entries of the lists of all cells before this one: its own begin here when they stand in one row.
  std::size_t offset(Index cell) const { return std::size_t{start_[cell]} + guest_start_[cell]; }

  std::size_t guests() const { return all_guests_.size(); }

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

  std::size_t bytes() const {
    return (start_.size() + owned_.size() + guest_start_.size() + guests_.size() + all_guests_.size() +
            next_.size() + order_.size()) *
           sizeof(Index);
  }

 private:
  std::vector<Index> start_;         // [cells + 1] first point of each cell's run
  std::vector<Index> owned_;         // [cells] points of the run that are still in the cell
  std::vector<Index> guest_start_;   // [cells + 1] into guests_
  std::vector<Index> guests_;        // by cell
  std::vector<Index> all_guests_;    // in the order of their moves
  std::vector<Index> next_, order_;  // scratch
};

}  // namespace arenite
