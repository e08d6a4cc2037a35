// Cold functions of cell_points.hpp.
#pragma once
// SPDX-License-Identifier: BSD-3-Clause

#include <arenite/fill/cell_points.hpp>

namespace arenite::inline ARENITE_INSTRUCTION_SET {

template <int D>
ARENITE_COLD std::array<int, static_cast<std::size_t>(D)> lattice_counts(int n) {
  const int k = static_cast<int>(std::lround(std::pow(n, 1.0 / D)));
  require(n >= 1 && (D == 2 ? k * k : k * k * k) == n, "per_cell", n,
          D == 2 ? "must be a square (1, 4, 9, ..)" : "must be a cube (1, 8, 27, ..)");
  std::array<int, static_cast<std::size_t>(D)> along;
  along.fill(k);
  return along;
}

template <class T, int D>
ARENITE_COLD std::array<int, static_cast<std::size_t>(D)> even_counts(int n, const Vec<T, D>& edges) {
  auto along = lattice_counts<D>(n);
  const double apart = std::pow(static_cast<double>(edges.prod()) / n, 1.0 / D);
  for (std::size_t k = 0; k < along.size(); ++k)
    along[k] =
        std::max(n > 1 ? 2 : 1,
                 static_cast<int>(std::lround(static_cast<double>(edges[static_cast<int>(k)]) / apart)));
  return along;
}

template <class T, int D>
ARENITE_COLD Places<Vec<T, D>> initial_points(const CellBox<T, D>& cell, int n, bool even) {
  Places<Vec<T, D>> points;
  for (const auto& s : lattice_points(even ? even_counts<T, D>(n, cell.extent) : lattice_counts<D>(n))) {
    Vec<T, D> x;
    for (int k = 0; k < D; ++k) x[k] = cell.corner[k] + cell.extent[k] * static_cast<T>(s[k]);
    points.push_back(x);
  }
  return points;
}

#define ARENITE_INSTANCES(D) template std::array<int, D> lattice_counts<D>(int);
ARENITE_FOR_DIMENSIONS(ARENITE_INSTANCES)
#undef ARENITE_INSTANCES

#define ARENITE_INSTANCES(T, D)                                   \
  template std::array<int, D> even_counts(int, const Vec<T, D>&); \
  template Places<Vec<T, D>> initial_points(const CellBox<T, D>&, int, bool);
ARENITE_FOR_NUMBERS_AND_DIMENSIONS(ARENITE_INSTANCES)
#undef ARENITE_INSTANCES

}  // namespace arenite::inline ARENITE_INSTRUCTION_SET
