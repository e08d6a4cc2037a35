// Cold functions of jitter.hpp.
#pragma once

#include <arenite/particles/jitter.hpp>

namespace arenite::inline ARENITE_INSTRUCTION_SET {

template <class T, int D>
ARENITE_COLD void jitter_points(const CellBox<T, D>& box, Index cell, double share, std::uint64_t seed,
                                Places<Vec<T, D>>& points, int per_cell, bool even) {
  const auto along = even ? even_counts<T, D>(per_cell, box.extent) : lattice_counts<D>(per_cell);
  for (std::size_t p = 0; p < points.size(); ++p) {
    detail::RandomAt random(seed, cell, p);
    for (int k = 0; k < D; ++k)
      points[p][k] += static_cast<T>(share * (1.0 / along[static_cast<std::size_t>(k)])) * box.extent[k] *
                      static_cast<T>(random.uniform() - 0.5);
  }
}

#ifdef ARENITE_COLD_LIBRARY
template void jitter_points<float, 2>(const CellBox<float, 2>&, Index, double, std::uint64_t,
                                      Places<Vec<float, 2>>&, int, bool);
template void jitter_points<float, 3>(const CellBox<float, 3>&, Index, double, std::uint64_t,
                                      Places<Vec<float, 3>>&, int, bool);
template void jitter_points<double, 2>(const CellBox<double, 2>&, Index, double, std::uint64_t,
                                       Places<Vec<double, 2>>&, int, bool);
template void jitter_points<double, 3>(const CellBox<double, 3>&, Index, double, std::uint64_t,
                                       Places<Vec<double, 3>>&, int, bool);
template void jitter_points<long double, 2>(const CellBox<long double, 2>&, Index, double, std::uint64_t,
                                            Places<Vec<long double, 2>>&, int, bool);
template void jitter_points<long double, 3>(const CellBox<long double, 3>&, Index, double, std::uint64_t,
                                            Places<Vec<long double, 3>>&, int, bool);
#endif

}  // namespace arenite::inline ARENITE_INSTRUCTION_SET
