// Cell sums: what P2G leaves of the points of a cell to later stages of the step, so that these need not read
// them again.
#pragma once
// SPDX-License-Identifier: BSD-3-Clause

#include <array>
#include <cstddef>

#include <arenite/simd/lanes.hpp>

namespace arenite::inline ARENITE_INSTRUCTION_SET {

/// Sums over the points of one body in one cell of a simplex mesh, each kept only if the scene's numerics use
/// it: a body keeps none if they use no sum at all.
template <class T, int D>
struct CellSums {
  static constexpr std::size_t edges = static_cast<std::size_t>(D * (D + 1) / 2);
  T volume = 0;                          ///< sum V, m3
  T volume_factor = 1;                   ///< volume over which the cell carries its stress, over sum V, -
  T dilation = 0;                        ///< mean of the points' dilation by volume, -
  bool open = false;                     ///< whether one of the points is open (`knows_opening`)
  std::array<T, edges> edge_mass{};      ///< sum m w_i w_j for i < j, as (0, 1), (0, 2), .., (1, 2), .., kg
  std::array<T, D == 2 ? 3 : 0> hoop{};  ///< sum V w_i / r in axisymmetry, m2
};

/// Calls `f(e, i, j)` for the edges e of a simplex with `Nodes` nodes, in the order of `CellSums`.
template <std::size_t Nodes, class F>
constexpr void for_each_edge(F&& f) {
  repeat<Nodes>([&](std::size_t i) {
    repeat<Nodes>([&](std::size_t j) {
      if (i < j) f(i * (2 * Nodes - i - 1) / 2 + j - i - 1, i, j);
    });
  });
}

}  // namespace arenite::inline ARENITE_INSTRUCTION_SET
