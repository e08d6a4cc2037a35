// Lists of numbers, one for each row, in one array (compressed sparse rows): cells at the nodes, cells in the
// buckets of a search, blocks of a colour.
#pragma once

#include <algorithm>
#include <cstddef>
#include <span>
#include <vector>

#include <arenite/core/scalar.hpp>

namespace arenite::inline ARENITE_INSTRUCTION_SET {

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

  /// The same, in the memory that is there if it suffices.
  template <class Visit>
  void build(std::size_t rows, Visit&& visit) {
    start_.assign(rows + 1, 0);
    visit([&](std::size_t row, Index) { ++start_[row + 1]; });
    for (std::size_t row = 0; row < rows; ++row) start_[row + 1] += start_[row];
    values_.resize(start_.back());
    // Each row's start moves up to its end, which is the start of the next.
    visit([&](std::size_t row, Index value) { values_[start_[row]++] = value; });
    std::copy_backward(start_.begin(), start_.end() - 1, start_.end());
    start_[0] = 0;
  }

  std::size_t size() const { return start_.size() - 1; }
  std::span<const Index> operator[](std::size_t row) const {
    return {values_.data() + start_[row], values_.data() + start_[row + 1]};
  }
  std::size_t bytes() const { return (start_.size() + values_.size()) * sizeof(Index); }

 private:
  std::vector<Index> start_{0};  // [rows + 1]
  std::vector<Index> values_;    // row by row
};

}  // namespace arenite::inline ARENITE_INSTRUCTION_SET
