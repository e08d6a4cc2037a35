// Jitter: initial points moved at random, each within its share of the cell.
#pragma once
// SPDX-License-Identifier: BSD-3-Clause

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

#include <arenite/core/cold.hpp>
#include <arenite/core/error.hpp>
#include <arenite/fill/cell_points.hpp>

namespace arenite::inline ARENITE_INSTRUCTION_SET {
namespace detail {

/// Random numbers that are a function of seed and place, with the same bits on any machine: splitmix64
/// (Steele, Lea and Flood, OOPSLA 2014).
class RandomAt {
 public:
  RandomAt(std::uint64_t seed, std::uint64_t cell, std::uint64_t point)
      : state_{mixed(mixed(mixed(seed) ^ cell) ^ point)} {}

  /// In [0, 1).
  double uniform() { return static_cast<double>(mixed(state_ += step) >> 11) * 0x1p-53; }

 private:
  static constexpr std::uint64_t step = 0x9e3779b97f4a7c15;
  static constexpr std::uint64_t mixed(std::uint64_t x) {
    x += step;
    x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9;
    x = (x ^ (x >> 27)) * 0x94d049bb133111eb;
    return x ^ (x >> 31);
  }
  std::uint64_t state_;
};

/// Barycentric coordinates of a random position in a simplex, each as likely as another: the gaps between
/// sorted numbers.
template <int D>
Vec<double, D + 1> random_in_simplex(RandomAt& random) {
  std::array<double, D + 2> cuts{};
  for (std::size_t k = 1; k <= D; ++k) cuts[k] = random.uniform();
  cuts[D + 1] = 1;
  std::sort(cuts.begin(), cuts.end());
  Vec<double, D + 1> b;
  for (int k = 0; k <= D; ++k)
    b[k] = cuts[static_cast<std::size_t>(k) + 1] - cuts[static_cast<std::size_t>(k)];
  return b;
}

/// `jitter_points` in a simplex.
template <class M>
void jitter_in_simplex(const M& mesh, Index cell, std::uint64_t number, double share, std::uint64_t seed,
                       Places<typename M::Point>& points) {
  using T = typename M::scalar;
  constexpr int D = M::dimension;
  double size = 1;  // of a sub-cell, in cells
  for (const auto& x : points)
    size = std::min(size, (D + 1) * static_cast<double>(mesh.barycentric(cell, x).minCoeff()));
  const auto scale = static_cast<T>(share * size);
  for (std::size_t p = 0; p < points.size(); ++p) {
    RandomAt random(seed, number, p);
    const auto b = random_in_simplex<D>(random);
    for (int k = 0; k <= D; ++k)
      points[p] += scale * static_cast<T>(b[k] - 1.0 / (D + 1)) *
                   mesh.position(mesh.nodes(cell)[static_cast<std::size_t>(k)]);
  }
}

}  // namespace detail

/// Moves the initial points of a cell at random, each as likely to any place in its sub-cell, times `share`
/// from 0 to 1. On a grid the sub-cell is the point's part of the lattice (`per_cell`, `even`: see
/// `initial_points`); in a simplex a copy of it about the point, as large as keeps all points in the cell.
/// `number`: of the cell in the whole mesh. The points do not depend on the machine, nor on the order of the cells.
template <class T, int D>
void jitter_points(const CellBox<T, D>& box, std::uint64_t number, double share, std::uint64_t seed,
                   Places<Vec<T, D>>& points, int per_cell, bool even);
template <class M>
void jitter_points(const M& mesh, Index cell, std::uint64_t number, double share, std::uint64_t seed,
                   Places<typename M::Point>& points, [[maybe_unused]] int per_cell,
                   [[maybe_unused]] bool even = false) {
  if (share == 0) return;
  if constexpr (is_simplex_mesh<M>)
    detail::jitter_in_simplex(mesh, cell, number, share, seed, points);
  else
    jitter_points(cell_box(mesh, cell), number, share, seed, points, per_cell, even);
}

}  // namespace arenite::inline ARENITE_INSTRUCTION_SET

#if ARENITE_HAS_COLD

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

#endif  // ARENITE_HAS_COLD
