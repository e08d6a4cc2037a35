// Lists of numbers, one for each row, in one array (compressed sparse rows): cells at the nodes, cells in the
// buckets of a search, blocks of a colour, unsorted points of a cell.
#pragma once
// SPDX-License-Identifier: BSD-3-Clause

#include <algorithm>
#include <cstddef>
#include <span>
#include <vector>

#include <arenite/core/scalar.hpp>

namespace arenite::inline ARENITE_INSTRUCTION_SET {

/// Where each of `rows` lists begins in one array, and the last one ends: `start` [rows + 1], in the memory
/// that is there if it suffices. `visit(count)` calls `count(row)` for each entry, row below `rows`.
template <class Visit>
void begin_rows(std::vector<Index>& start, std::size_t rows, Visit&& visit) {
  start.assign(rows + 1, 0);
  visit([&](std::size_t row) { ++start[row + 1]; });
  for (std::size_t row = 0; row < rows; ++row) start[row + 1] += start[row];
}

/// Made by a counting sort: the entries of a row keep the order in which they were named.
class Lists {
 public:
  Lists() = default;

  /// Makes `rows` lists. `visit(add)` calls `add(row, value)` for each entry, row below `rows`; it is called
  /// twice and must name the same entries in the same order.
  template <class Visit>
  Lists(std::size_t rows, Visit&& visit) {
    build(rows, visit);
  }

  /// Rebuilds the lists, in the memory that is there if it suffices.
  template <class Visit>
  void build(std::size_t rows, Visit&& visit) {
    begin_rows(start_, rows, [&](auto&& count) { visit([&](std::size_t row, Index) { count(row); }); });
    values_.resize(start_.back());
    // Each row's start moves up to its end, which is the start of the next.
    visit([&](std::size_t row, Index value) { values_[start_[row]++] = value; });
    std::copy_backward(start_.begin(), start_.end() - 1, start_.end());
    start_[0] = 0;
  }

  /// Reserves memory for this number of entries.
  void reserve(std::size_t entries) { values_.reserve(entries); }

  std::size_t size() const { return start_.size() - 1; }
  /// Entries of all rows before this one.
  Index before(std::size_t row) const { return start_[row]; }
  /// Entries of all rows, row by row.
  std::span<const Index> values() const { return values_; }
  std::span<const Index> operator[](std::size_t row) const {
    return {values_.data() + start_[row], values_.data() + start_[row + 1]};
  }
  std::size_t bytes() const { return (start_.size() + values_.size()) * sizeof(Index); }

 private:
  std::vector<Index> start_{0};  // [rows + 1]
  std::vector<Index> values_;    // row by row
};

}  // namespace arenite::inline ARENITE_INSTRUCTION_SET
