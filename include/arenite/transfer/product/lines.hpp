// Functions along the axes, whose products the functions of a cell are, and sums over its nodes: axis by
// axis, which takes a third of the arithmetic of a sum node by node.
#pragma once
// SPDX-License-Identifier: BSD-3-Clause

#include <algorithm>
#include <array>
#include <cstddef>

#include <arenite/simd/lanes.hpp>

namespace arenite::inline ARENITE_INSTRUCTION_SET {
namespace product {

/// Points of one cell computed at once: more than it is likely to hold would be wasted.
template <int D, int Width>
inline constexpr int cell_width = std::min(Width, D == 2 ? 4 : 8);

/// Calls `f(i)` for i < Count, unrolled up to three: with four nodes along each axis of space the code of 64
/// outweighs what it saves.
template <std::size_t Count, class F>
void repeat_all(F&& f) {
  if constexpr (Count <= 3)
    repeat<Count>(f);
  else
    for (std::size_t i = 0; i < Count; ++i) f(i);
}

/// Functions along each axis at a pack of points: [D][nodes along it].
template <class P, std::size_t D, std::size_t Along>
using LineFunctions = std::array<std::array<P, Along>, D>;

/// Sums of node vectors v_i [D]: `value` = sum w_i v_i, and `by_axis[k][a]` the same with the function along
/// axis a replaced by that of kind k.
template <class P, std::size_t D, std::size_t Kinds>
struct LineSums {
  std::array<P, D> value;
  std::array<std::array<std::array<P, D>, D>, Kinds> by_axis;

  /// The last kind.
  const auto& moments() const { return by_axis[Kinds - 1]; }
};

/// The functions of a cell along each axis at a pack of points: values; slopes, 1/m; and moments, values
/// times the offset of the node, m.
template <class P, class Cell>
struct Lines {
  static constexpr std::size_t D = Cell::D, N = Cell::nodes_per_axis;
  using Functions = LineFunctions<P, D, N>;
  Functions value, slope, moment;

  Lines(const Cell& cell, const std::array<P, D>& x)
      : value{cell.line_values(x)}, slope{cell.line_slopes(x)}, moment{cell.offsets(x)} {
    repeat<D>(
        [&](std::size_t a) { repeat<N>([&](std::size_t i) { moment[a][i] = moment[a][i] * value[a][i]; }); });
  }

  /// Sums over the vectors v[i] of all nodes. Kinds: `slope` gives the gradient sum v_i (grad w_i)^T,
  /// `moment` sum w_i v_i (x_i - x)^T, column by column.
  template <class Rows, class... Kinds>
  LineSums<P, D, sizeof...(Kinds)> sum(const Rows& v, const Kinds&... kind) const {
    return sum_over<D>(v, 0, std::array<Functions, sizeof...(Kinds)>{kind...});
  }

 private:
  /// Over the nodes of the first `Axes` axes: over lines, planes, then the cell, from node `first` on.
  template <std::size_t Axes, class Rows, std::size_t Kinds>
  LineSums<P, D, Kinds> sum_over(const Rows& v, std::size_t first,
                                 const std::array<Functions, Kinds>& kind) const {
    LineSums<P, D, Kinds> total;
    if constexpr (Axes == 0) {
      repeat<D>([&](std::size_t d) { total.value[d] = P(v[first][d]); });
    } else {
      constexpr std::size_t a = Axes - 1, stride = a == 0 ? 1 : a == 1 ? N : N * N;
      repeat<D>([&](std::size_t d) {
        total.value[d] = P(0);
        repeat<Kinds>(
            [&](std::size_t k) { repeat<Axes>([&](std::size_t b) { total.by_axis[k][b][d] = P(0); }); });
      });
      constexpr auto each = [](auto&& f) {
        if constexpr (a + 1 == D && D == 3)
          repeat_all<N>(f);
        else
          repeat<N>(f);
      };
      each([&](std::size_t j) {
        const auto part = sum_over<a>(v, first + j * stride, kind);
        repeat<D>([&](std::size_t d) {
          total.value[d] += value[a][j] * part.value[d];
          repeat<Kinds>([&](std::size_t k) {
            repeat<a>([&](std::size_t b) { total.by_axis[k][b][d] += value[a][j] * part.by_axis[k][b][d]; });
            total.by_axis[k][a][d] += kind[k][a][j] * part.value[d];
          });
        });
      });
    }
    return total;
  }
};

}  // namespace product
}  // namespace arenite::inline ARENITE_INSTRUCTION_SET
