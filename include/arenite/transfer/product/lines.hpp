// Functions along the axes, whose products the functions of a cell are, and sums over its nodes: axis by
// axis, and of differences. A sum node by node takes three times the arithmetic and more.
#pragma once
// SPDX-License-Identifier: BSD-3-Clause

#include <algorithm>
#include <array>
#include <cstddef>

#include <arenite/simd/kernel.hpp>
#include <arenite/transfer/node_field.hpp>

namespace arenite::inline ARENITE_INSTRUCTION_SET {
namespace product {
ARENITE_INLINE_BEGIN

/// Points of one cell computed at once: more lanes than a cell is likely to have points would be wasted.
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

/// A node in the middle of an axis of N.
template <std::size_t N>
inline constexpr std::size_t middle_node = (N - 1) / 2;

/// Vectors v_i of the nodes of a cell, for `Lines::sum`. Along an axis the functions w_j of a cell add up to 1, and
/// their slopes, and moments, g_j to 0. So with the differences d_j = v_j - v_m from the middle node
///   sum_j w_j v_j = v_m + sum_{j != m} w_j d_j     sum_j g_j v_j = sum_{j != m} g_j d_j
/// which saves a product for all points of the cell. Computed once a cell, along one axis after the other.
template <class Cell>
class Differences {
  static constexpr std::size_t N = Cell::nodes_per_axis, size = Cell::size, middle = middle_node<N>;
  using Rows = CellVectors<typename Cell::T, Cell::D, size>;

 public:
  explicit Differences(const Rows& vectors) {
    take([&](std::size_t i) { return vectors.pack(i); });
  }
  template <class Vectors>
  Differences(const Cell& cell, const Vectors& of_nodes) {
    take([&](std::size_t i) { return of_nodes.pack(cell.nodes[i]); });
  }

  auto component(std::size_t node, std::size_t d) const { return row_[node][d]; }

 private:
  template <class VectorOf>
  void take(VectorOf&& vector) {
    std::array<NodePack<typename Cell::T, Cell::D>, size> v;
    repeat<size>([&](std::size_t i) { v[i] = vector(i); });
    repeat<Cell::D>([&](std::size_t a) {
      const std::size_t stride = a == 0 ? 1 : a == 1 ? N : N * N;
      repeat<size>([&](std::size_t i) {
        const std::size_t j = i / stride % N;
        if (j != middle) v[i] = v[i] - v[i + (middle - j) * stride];
      });
    });
    repeat<size>([&](std::size_t i) { row_.set(i, v[i]); });
  }

  Rows row_;
};

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

  /// Sums over the vectors of all nodes. Kinds: `slope` gives the gradient sum v_i (grad w_i)^T,
  /// `moment` sum w_i v_i (x_i - x)^T, column by column.
  template <class... Kinds>
  LineSums<P, D, sizeof...(Kinds)> sum(const Differences<Cell>& v, const Kinds&... kinds) const {
    constexpr std::size_t count = sizeof...(Kinds);
    const std::array<Functions, count> kind{kinds...};
    LineSums<P, D, count> total;
    // A component after the other, all of whose sums stay in registers.
    repeat<D>([&](std::size_t d) {
      std::conditional_t<(count > 0), Functions, Nothing> across;
      total.value[d] = sum_over<D>(v, d, 0, across);
      if constexpr (count > 0)
        repeat<count * D>([&](std::size_t n) {
          const std::size_t k = n / D, a = n % D;
          P along(0);
          each_but_middle([&](std::size_t j) { along += kind[k][a][j] * across[a][j]; });
          total.by_axis[k][a][d] = along;
        });
    });
    return total;
  }

 private:
  static constexpr std::size_t middle = middle_node<N>;
  template <class F>
  static void each_but_middle(F&& f) {
    repeat<N>([&](std::size_t j) {
      if (j != middle) f(j);
    });
  }

  /// Of one component the sum over the first `Axes` axes. `across`: for the nodes j of each of these axes but the middle one the sum of
  /// the differences d_j over the others, or `Nothing`. They are copied one by one, for g++ 12 copies arrays through memory.
  template <std::size_t Axes, class Across>
  P sum_over(const Differences<Cell>& v, std::size_t d, std::size_t first, Across& across) const {
    if constexpr (Axes == 0) {
      return P(v.component(first, d));
    } else {
      constexpr std::size_t a = Axes - 1, stride = a == 0 ? 1 : a == 1 ? N : N * N;
      P total = sum_over<a>(v, d, first + middle * stride, across);
      each_but_middle([&](std::size_t j) {
        Across other;
        const P sum = sum_over<a>(v, d, first + j * stride, other);
        total += value[a][j] * sum;
        if constexpr (!std::same_as<Across, Nothing>) {
          repeat<a>([&](std::size_t b) {
            each_but_middle([&](std::size_t i) { across[b][i] += value[a][j] * other[b][i]; });
          });
          across[a][j] = sum;
        }
      });
      return total;
    }
  }
};

ARENITE_INLINE_END
}  // namespace product
}  // namespace arenite::inline ARENITE_INSTRUCTION_SET
