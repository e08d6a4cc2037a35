// Cold functions of cell_list.hpp.
#pragma once
// SPDX-License-Identifier: BSD-3-Clause

#include <algorithm>

#include <arenite/particles/cell_list.hpp>

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
