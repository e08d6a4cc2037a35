// Cold functions of jitter.hpp.
#pragma once
// SPDX-License-Identifier: BSD-3-Clause

#include <arenite/fill/jitter.hpp>

namespace arenite::inline ARENITE_INSTRUCTION_SET {

template <class T, int D>
ARENITE_COLD void jitter_points(const CellBox<T, D>& box, std::uint64_t number, double share,
                                std::uint64_t seed, Places<Vec<T, D>>& points, int per_cell, bool even) {
  const auto along = even ? even_counts<T, D>(per_cell, box.extent) : lattice_counts<D>(per_cell);
  for (std::size_t p = 0; p < points.size(); ++p) {
    detail::RandomAt random(seed, number, p);
    for (int k = 0; k < D; ++k)
      points[p][k] += static_cast<T>(share * (1.0 / along[static_cast<std::size_t>(k)])) * box.extent[k] *
                      static_cast<T>(random.uniform() - 0.5);
  }
}

#define ARENITE_INSTANCES(T, D)                                                           \
  template void jitter_points(const CellBox<T, D>&, std::uint64_t, double, std::uint64_t, \
                              Places<Vec<T, D>>&, int, bool);
ARENITE_FOR_NUMBERS_AND_DIMENSIONS(ARENITE_INSTANCES)
#undef ARENITE_INSTANCES

}  // namespace arenite::inline ARENITE_INSTRUCTION_SET
