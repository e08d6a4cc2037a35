// Rows of points: contributions of a cell's points to its nodes where the functions are products along the
// axes. A point is a row of four lanes, so that sums over points need no sums across lanes.
#pragma once
// SPDX-License-Identifier: BSD-3-Clause

#include <arenite/simd/kernel.hpp>
#include <arenite/transfer/product/lines.hpp>

namespace arenite::inline ARENITE_INSTRUCTION_SET {
namespace product {
ARENITE_INLINE_BEGIN

/// Writes four columns of neighbouring points as rows of four lanes, one a point.
template <class T, class P>
void store_quads(std::array<P, 4> column, T* to) {
  constexpr std::size_t width = static_cast<std::size_t>(lane_count<P>);
  if constexpr (width == 1) {
    repeat<4>([&](std::size_t k) { to[k] = column[k]; });
  } else if constexpr (width < 4) {
    static_assert(width == 2);
    repeat<2>([&](std::size_t k) {
      std::array<P, 2> half{column[2 * k], column[2 * k + 1]};
      transpose_lanes(half);
      repeat<2>([&](std::size_t r) { half[r].store(to + 4 * r + 2 * k); });
    });
  } else {
    transpose_lanes(column);  // row r: points r, r + 4, ..
    repeat<4>([&](std::size_t r) {
      std::array<T, width> rows;
      column[r].store(rows.data());
      repeat<width / 4>(
          [&](std::size_t k) { Pack<T, 4>::load(rows.data() + 4 * k).store(to + 4 * (4 * k + r)); });
    });
  }
}

/// Contributions of points in four lanes: by value, times a node's function, or by axis, times its moment or slope along each.
enum class Contribution { by_value, by_axis, both };

/// Rows of up to `capacity` points of a cell, with their contributions in `Groups` of four lanes. A node at (i, j, k) of the cell
/// collects, with the functions N along each axis, their moments M (N times the offset of the node, for an affine velocity) and their
/// slopes G (for a force),
///   N_i N_j N_k own + sum over the axes of (M_i moment + G_i slope) N_j N_k
/// The terms of one axis are summed while points are columns: E_i = M_i moment + G_i slope along the first axes, and along the last
/// one E_k + N_k own.
///
/// In an inner cell (`Cell::is_inner`) sums over points are those of the outer nodes and of the total of each axis, over which N adds
/// up to 1 and M and G to 0: the total is that of own, without a product. The middle node is the rest of the total, once a cell. At
/// faces, where the middle function may be small, the difference would leave round-off, and nodes are summed one by one.
template <class Cell, int Width, Contribution... Groups>
class Rows {
  using T = typename Cell::T;
  static constexpr std::size_t D = Cell::D, N = Cell::nodes_per_axis, last = D - 1, middle = middle_node<N>;
  static constexpr std::size_t at_once = static_cast<std::size_t>(std::min(Width, 4));
  using L = lanes_of<T, static_cast<int>(at_once)>;
  static constexpr std::array<Contribution, sizeof...(Groups)> contributions{Groups...};

 public:
  static constexpr int width = cell_width<Cell::D, Width>;  ///< points that come at once
  using P = lanes_of<T, width>;

  Rows() {}  // a row is written before it is read: nothing to clear for each cell

  bool full() const { return count_ + width > capacity; }

  /// Stores a pack's contributions to a group, each up to D + 1 lanes or `Nothing`: `own` by value, `moment(a)` and `slope(a)`
  /// along axis a. Call `take` after all groups.
  template <std::size_t Group, class Own, class Moment, class Slope>
  void hand(const Lines<P, Cell>& line, const Own& own, const Moment& moment, const Slope& slope) {
    constexpr bool axes = contributions[Group] != Contribution::by_value,
                   value = contributions[Group] != Contribution::by_axis;
    repeat<D>([&](std::size_t a) {
      if (!axes && a != last) return;
      repeat<N>([&](std::size_t i) {
        if (is_total(i)) return;
        auto lane = no_lanes();
        if constexpr (!std::same_as<Slope, Nothing>) add(lane, line.slope[a][i], slope(a));
        if constexpr (!std::same_as<Moment, Nothing>) add(lane, line.moment[a][i], moment(a));
        if constexpr (value)
          if (a == last) add(lane, line.value[a][i], own);
        store_quads(lane, row_[Group][a][i][count_].data());
      });
    });
    if constexpr (Cell::is_inner && value) {
      auto lane = no_lanes();
      add(lane, P(1), own);
      store_quads(lane, row_[Group][last][middle][count_].data());
    }
  }
  /// Adds the first `count` points of a pack, once `hand` has stored all groups.
  void take(int count, const Lines<P, Cell>& line) {
    repeat<D>([&](std::size_t a) {
      repeat<N>([&](std::size_t i) {
        if (!is_total(i)) store_lanes(&value_[a][i][count_], width, line.value[a][i]);
      });
    });
    count_ += static_cast<std::size_t>(count);
  }

  /// Calls `add(node, lane, pack)` with the sum of a group at each local node in the lanes from number `lane` on.
  template <std::size_t Group, class Add>
  void spread(Add&& add) const {
    repeat<4 / at_once>([&](std::size_t part) {
      if (part * at_once > D) return;
      const std::size_t lane = part * at_once;
      const auto hand = [&](std::size_t k, const Layer& sum) {
        repeat<N * N>([&](std::size_t n) { add(N * N * k + n, lane, sum[n]); });
      };
      if constexpr (D == 2 || !Cell::is_inner) {
        repeat_all<D == 2 ? 1 : N>([&](std::size_t k) { hand(k, layer<Group, false>(lane, k)); });
      } else {
        auto rest = layer<Group, true>(lane, middle);
        repeat_all<N>([&](std::size_t k) {
          if (k == middle) return;
          const auto sum = layer<Group, false>(lane, k);
          repeat<N * N>([&](std::size_t n) { rest[n] = rest[n] - sum[n]; });
          hand(k, sum);
        });
        hand(middle, rest);
      }
    });
  }
  void forget() { count_ = 0; }

 private:
  static constexpr std::size_t capacity = 32;
  using Layer = std::array<L, N * N>;

  /// Whether the place of node i is that of the total of its axis.
  static constexpr bool is_total(std::size_t i) { return Cell::is_inner && i == middle; }
  static std::array<P, 4> no_lanes() { return {P(0), P(0), P(0), P(0)}; }
  template <std::size_t Lanes>
  static void add(std::array<P, 4>& to, const P& factor, const std::array<P, Lanes>& of) {
    repeat<Lanes>([&](std::size_t d) { to[d] += factor * of[d]; });
  }

  /// Whether a group has rows at node i of an axis: the total has only own, along the last axis.
  template <std::size_t Group>
  static constexpr bool has_row(std::size_t axis, std::size_t i) {
    const bool value = axis == last && contributions[Group] != Contribution::by_axis;
    return value || (!is_total(i) && contributions[Group] != Contribution::by_value);
  }

  /// Sums of layer k of the nodes (all of them, in the plane), in the lanes from number `lane` on. `OfTotal`: that of the total.
  template <std::size_t Group, bool OfTotal>
  Layer layer(std::size_t lane, std::size_t k) const {
    const auto row = [&](std::size_t a, std::size_t i, std::size_t p) {
      return load_lanes<L>(row_[Group][a][i][p].data() + lane, static_cast<int>(at_once));
    };
    // `to` plus what lies at node i of an axis, whose function is `n`: 1 for the total.
    const auto add = [](const L& to, const L& of, std::size_t i, const L& n) {
      return is_total(i) ? L(to + of) : L(to + of * n);
    };
    constexpr bool has_layer = D == 3 && has_row<Group>(2, OfTotal ? middle : 0);
    Layer sum;
    repeat<N * N>([&](std::size_t n) { sum[n] = L(0); });
    for (std::size_t p = 0; p < count_; ++p) {
      const auto in_layer = [&](const L& of) {
        if constexpr (D == 2 || OfTotal)
          return of;
        else
          return L(of * L(value_[2][k][p]));
      };
      std::array<L, N> n_x, e_x;
      repeat<N>([&](std::size_t i) {
        if (!is_total(i)) n_x[i] = L(value_[0][i][p]);
        if (has_row<Group>(0, i)) e_x[i] = in_layer(row(0, i, p));
      });
      repeat<N>([&](std::size_t j) {
        const bool has_line = has_row<Group>(1, j);
        L n_y(1), line(0);
        if (!is_total(j)) n_y = L(value_[1][j][p]);
        if (has_line) line = in_layer(row(1, j, p));
        if constexpr (has_layer) {
          const L own = row(2, k, p);
          line = has_line ? L(line + own * n_y) : is_total(j) ? own : L(own * n_y);
        }
        repeat<N>([&](std::size_t i) {
          L& to = sum[N * j + i];
          if (has_line || has_layer) to = add(to, line, i, n_x[i]);
          if (has_row<Group>(0, i)) to = add(to, e_x[i], j, n_y);
        });
      });
    }
    if constexpr (Cell::is_inner) {
      repeat<N>([&](std::size_t j) { take_rest(sum, N * j, 1); });
      repeat<N>([&](std::size_t i) { take_rest(sum, i, N); });
    }
    return sum;
  }
  /// The middle one of the nodes first, first + stride, .. is the rest of their total.
  static void take_rest(Layer& sum, std::size_t first, std::size_t stride) {
    L& rest = sum[first + middle * stride];
    repeat<N>([&](std::size_t i) {
      if (i != middle) rest = rest - sum[first + i * stride];
    });
  }

  std::size_t count_ = 0;
  alignas(64) std::array<std::array<std::array<std::array<std::array<T, 4>, capacity>, N>, D>,
                         sizeof...(Groups)> row_;
  std::array<std::array<std::array<T, capacity>, N>, D> value_;
};

ARENITE_INLINE_END
}  // namespace product
}  // namespace arenite::inline ARENITE_INSTRUCTION_SET
