// Sums over the nodes of a cell whose functions are products along the axes: axis by axis, which takes a
// third of the arithmetic of a sum node by node.
#pragma once

#include <array>
#include <cstddef>

#include <arenite/core/lanes.hpp>

namespace arenite {

/// Sums of node vectors v_i [D]: `value` = sum w_i v_i, and `along[a]` the same with the line functions of
/// axis a replaced by a second kind: slopes give the gradient, arms w (x_i - x) the affine motion of APIC.
template <class P, std::size_t D>
struct LineSums {
  std::array<P, D> value;
  std::array<std::array<P, D>, D> along;
};

/// `row(i)`: vector of local node i as an array of scalars; `first`, `second`: [D][3] line functions of the
/// points.
template <class P, std::size_t D, class Rows>
LineSums<P, D> line_sums(const Rows& row, const std::array<std::array<P, 3>, D>& first,
                         const std::array<std::array<P, 3>, D>& second) {
  using Sums = std::array<std::array<P, D>, D + 1>;  // the plain sum, then one with each axis' second kind
  const auto clear = [](Sums& sums) {
    repeat<D + 1>([&](std::size_t k) { repeat<D>([&](std::size_t d) { sums[k][d] = P(0); }); });
  };
  // Along x: each line of three nodes.
  const auto line = [&](std::size_t begin) {
    Sums sums;
    clear(sums);
    repeat<3>([&](std::size_t i) {
      repeat<D>([&](std::size_t d) {
        const P v(row[begin + i][d]);
        sums[0][d] += first[0][i] * v;
        sums[1][d] += second[0][i] * v;
      });
    });
    return sums;
  };
  // Across axis a: sums of the axes before it, and the new one.
  const auto across = [&](std::size_t a, Sums& total, std::size_t j, const Sums& part) {
    repeat<D>([&](std::size_t d) {
      total[0][d] += first[a][j] * part[0][d];
      total[1][d] += first[a][j] * part[1][d];
      if (a == 2) total[2][d] += first[a][j] * part[2][d];
      total[a + 1][d] += second[a][j] * part[0][d];
    });
  };
  const auto layer = [&](std::size_t begin) {
    Sums sums;
    clear(sums);
    repeat<3>([&](std::size_t j) { across(1, sums, j, line(begin + 3 * j)); });
    return sums;
  };
  Sums all;
  if constexpr (D == 2) {
    all = layer(0);
  } else {
    clear(all);
    repeat<3>([&](std::size_t k) { across(2, all, k, layer(9 * k)); });
  }
  LineSums<P, D> result;
  result.value = all[0];
  repeat<D>([&](std::size_t a) { result.along[a] = all[a + 1]; });
  return result;
}

}  // namespace arenite
