// Rows of points where nodes collect mass and one vector, the momentum of the end of the step: four lanes a
// node. A point is a row, so that sums over points need no sums across lanes.
#pragma once
// SPDX-License-Identifier: BSD-3-Clause

#include <arenite/transfer/product/rows.hpp>

namespace arenite::inline ARENITE_INSTRUCTION_SET {
namespace product {

/// Rows of up to `capacity` points. A node at (i, j, k) of the cell collects, with the functions N along each
/// axis, their moments M (N times the offset of the node, for an affine velocity) and their slopes G (for a
/// force),
///   N_i N_j N_k own + sum over the axes of (M_i moment + G_i slope) N_j N_k
/// What belongs to one axis is summed while points are columns: E_i = M_i moment + G_i slope along the first
/// axes, and along the last one E_k + N_k own.
template <class Cell, int Width>
class MomentumBuffer {
  using T = typename Cell::T;
  static constexpr std::size_t D = Cell::D, N = Cell::nodes_per_axis, last = D - 1;
  static constexpr std::size_t at_once = static_cast<std::size_t>(std::min(Width, 4));
  using L = lanes_of<T, static_cast<int>(at_once)>;

 public:
  static constexpr int width = cell_width<Cell::D, Width>;  ///< points that come at once
  using P = lanes_of<T, width>;

  MomentumBuffer() {}  // a row is written before it is read: nothing to clear for each cell

  bool full() const { return count_ + width > capacity; }

  /// Takes the first `count` points of a pack, of masses m and velocity fields v: `impulse` [D] by value and
  /// `slope` [D x D, by axis] times the gradient, N s.
  template <class Field>
  void push(int count, const P& m, const Field& v, const std::array<P, D>& impulse,
            const std::array<P, D * D>& slope, const Lines<P, Cell>& line) {
    repeat<D>([&](std::size_t a) {
      repeat<N>([&](std::size_t i) {
        std::array<P, 4> lane{P(0), P(0), P(0), P(0)};
        repeat<D>([&](std::size_t d) {
          lane[d] = line.slope[a][i] * slope[a * D + d];
          if constexpr (Field::linear) lane[d] += line.moment[a][i] * (m * v.gradient[a * D + d]);
          if (a == last) lane[d] += line.value[a][i] * (m * v.value[d] + impulse[d]);
        });
        if (a == last) lane[D] = line.value[a][i] * m;
        store_quads(lane, row_[a][i][count_].data());
        store_lanes(&value_[a][i][count_], width, line.value[a][i]);
      });
    });
    count_ += static_cast<std::size_t>(count);
  }

  /// Calls `add(node, lane, pack)` with what each local node collects in the lanes from number `lane` on, and
  /// forgets the points.
  template <class Add>
  void spread(Add&& add) {
    repeat<4 / at_once>([&](std::size_t part) {
      if (part * at_once > D) return;
      repeat_all<D == 2 ? 1 : N>([&](std::size_t k) { spread_layer(part * at_once, k, add); });
    });
    count_ = 0;
  }

 private:
  static constexpr std::size_t capacity = 32;

  /// Sums of layer k of the nodes (all of them, in the plane), in the lanes from number `lane` on.
  template <class Add>
  void spread_layer(std::size_t lane, std::size_t k, Add& add) const {
    const auto row = [&](std::size_t a, std::size_t i, std::size_t p) {
      return load_lanes<L>(row_[a][i][p].data() + lane, static_cast<int>(at_once));
    };
    std::array<L, N * N> sum;
    repeat<N * N>([&](std::size_t n) { sum[n] = L(0); });
    for (std::size_t p = 0; p < count_; ++p) {
      std::array<L, N> n_x, e_x;
      repeat<N>([&](std::size_t i) {
        n_x[i] = L(value_[0][i][p]);
        e_x[i] = row(0, i, p);
        if constexpr (D == 3) e_x[i] = e_x[i] * L(value_[2][k][p]);
      });
      repeat<N>([&](std::size_t j) {
        const L n_y(value_[1][j][p]);
        L line = row(1, j, p);
        if constexpr (D == 3) line = line * L(value_[2][k][p]) + row(2, k, p) * n_y;
        repeat<N>([&](std::size_t i) { sum[N * j + i] += line * n_x[i]; });
        repeat<N>([&](std::size_t i) { sum[N * j + i] += e_x[i] * n_y; });
      });
    }
    repeat<N * N>([&](std::size_t n) { add(N * N * k + n, lane, sum[n]); });
  }

  std::size_t count_ = 0;
  alignas(64) std::array<std::array<std::array<std::array<T, 4>, capacity>, N>, D> row_;
  std::array<std::array<std::array<T, capacity>, N>, D> value_;
};

}  // namespace product
}  // namespace arenite::inline ARENITE_INSTRUCTION_SET
