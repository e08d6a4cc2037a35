// Sums over the nodes of a cell whose functions are products along the axes: axis by axis, which takes a
// third of the arithmetic of a sum node by node.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>

#include <arenite/core/lanes.hpp>

namespace arenite::inline ARENITE_INSTRUCTION_SET {

/// Points of one cell computed at once: more than it is likely to hold would be wasted.
template <int D, int Width>
inline constexpr int cell_width = std::min(Width, D == 2 ? 4 : 8);

/// Functions along each axis, whose products the functions of a cell are: [D][3].
template <class P, std::size_t D>
using LineFunctions = std::array<std::array<P, 3>, D>;

/// Line functions of a pack at x: values, slopes (1/m) and arms, values times the way to the node (m).
template <class P, class Cell>
struct LineSet {
  static constexpr std::size_t D = Cell::D;
  LineFunctions<P, D> value, slope, arm;

  LineSet(const Cell& cell, const std::array<P, D>& x)
      : value{cell.line_values(x)}, slope{cell.line_slopes(x)}, arm{cell.ways(x)} {
    repeat<D>([&](std::size_t a) { repeat<3>([&](std::size_t i) { arm[a][i] = arm[a][i] * value[a][i]; }); });
  }
};

/// Sums of node vectors v_i [D]: `value` = sum w_i v_i, and `along[k][a]` the same with the line functions of
/// axis a replaced by those of kind k: slopes give the gradient, arms w (x_i - x) the affine motion of APIC.
template <class P, std::size_t D, std::size_t Kinds>
struct LineSums {
  std::array<P, D> value;
  std::array<std::array<std::array<P, D>, D>, Kinds> along;
};

/// `row[i]`: vector of local node i as an array of scalars; `value`: line functions at the points; `kind`:
/// those that take their place along one axis.
template <class P, std::size_t D, std::size_t Kinds, class Rows>
LineSums<P, D, Kinds> line_sums(const Rows& row, const LineFunctions<P, D>& value,
                                const std::array<LineFunctions<P, D>, Kinds>& kind) {
  using Sums = LineSums<P, D, Kinds>;
  const auto clear = [](Sums& sums) {
    repeat<D>([&](std::size_t d) {
      sums.value[d] = P(0);
      repeat<Kinds>([&](std::size_t k) { repeat<D>([&](std::size_t a) { sums.along[k][a][d] = P(0); }); });
    });
  };
  // Along x: a line of three nodes.
  const auto line = [&](std::size_t begin) {
    Sums sums;
    clear(sums);
    repeat<3>([&](std::size_t i) {
      repeat<D>([&](std::size_t d) {
        const P v(row[begin + i][d]);
        sums.value[d] += value[0][i] * v;
        repeat<Kinds>([&](std::size_t k) { sums.along[k][0][d] += kind[k][0][i] * v; });
      });
    });
    return sums;
  };
  // Across axis a: the sums of the axes before it, and the new one.
  const auto across = [&](std::size_t a, Sums& total, std::size_t j, const Sums& part) {
    repeat<D>([&](std::size_t d) {
      total.value[d] += value[a][j] * part.value[d];
      repeat<Kinds>([&](std::size_t k) {
        repeat<D>([&](std::size_t b) {
          if (b < a) total.along[k][b][d] += value[a][j] * part.along[k][b][d];
        });
        total.along[k][a][d] += kind[k][a][j] * part.value[d];
      });
    });
  };
  const auto layer = [&](std::size_t begin) {
    Sums sums;
    clear(sums);
    repeat<3>([&](std::size_t j) { across(1, sums, j, line(begin + 3 * j)); });
    return sums;
  };
  if constexpr (D == 2) {
    return layer(0);
  } else {
    Sums all;
    clear(all);
    repeat<3>([&](std::size_t k) { across(2, all, k, layer(9 * k)); });
    return all;
  }
}

}  // namespace arenite::inline ARENITE_INSTRUCTION_SET
