// Rows of points: what the points of a cell hand to its nodes where the functions are products along the
// axes. A point is a row whose lanes are the channels, so that sums over points need no sums across lanes.
#pragma once
// SPDX-License-Identifier: BSD-3-Clause

#include <arenite/transfer/channels.hpp>
#include <arenite/transfer/product/lines.hpp>

namespace arenite::inline ARENITE_INSTRUCTION_SET {
namespace product {

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
    transpose_lanes(column);  // row r holds points r, r + 4, ..
    repeat<4>([&](std::size_t r) {
      std::array<T, width> rows;
      column[r].store(rows.data());
      repeat<width / 4>(
          [&](std::size_t k) { Pack<T, 4>::load(rows.data() + 4 * k).store(to + 4 * (4 * k + r)); });
    });
  }
}

/// Writes columns of neighbouring points, four or eights of them, as rows, one a point. `P`: packs as wide as
/// those of the rows, or of four lanes.
template <std::size_t Width, class T, class P, std::size_t Lanes>
void store_rows(const std::array<P, Lanes>& column, T* to) {
  static_assert(Lanes == 4 || Lanes % 8 == 0);
  constexpr std::size_t width = static_cast<std::size_t>(lane_count<P>);
  if constexpr (Lanes == 4) {
    store_quads(column, to);
  } else if constexpr (width == 1) {
    for (std::size_t k = 0; k < Lanes; ++k) to[k] = column[k];
  } else if constexpr (width < Width) {
    static_assert(width == 4);
    repeat<Lanes / 8>([&](std::size_t eight) {
      std::array<Pack<T, 8>, 4> row;
      repeat<4>(
          [&](std::size_t k) { row[k] = join_packs(column[8 * eight + k], column[8 * eight + k + 4]); });
      transpose_lanes(row);
      repeat<4>([&](std::size_t r) { row[r].store(to + r * Lanes + 8 * eight); });
    });
  } else {
    repeat<Lanes / Width>([&](std::size_t k) {
      std::array<P, width> row;
      repeat<width>([&](std::size_t r) { row[r] = column[k * width + r]; });
      transpose_lanes(row);
      repeat<width>([&](std::size_t r) { row[r].store(to + r * Lanes + k * width); });
    });
  }
}

/// Rows of up to `capacity` points with the channels of `Lanes`. A node at (i, j, k) of the cell collects,
/// with line functions N and a second kind G along each axis,
///   N_i N_j N_k own + G_i N_j N_k along[x] + N_i G_j N_k along[y] + N_i N_j G_k along[z]
/// where G is the moment, N times the offset of the node, in lanes by value (for an affine velocity) and the
/// slope of N in those by slope (for a force).
template <class Cell, class Lanes, int Width>
class Rows {
  using T = typename Cell::T;
  static constexpr std::size_t D = Cell::D, N = Cell::nodes_per_axis, lanes = Lanes::size;
  // Lanes computed at once, a register's.
  static constexpr std::size_t at_once = std::min<std::size_t>({static_cast<std::size_t>(Width), 8, lanes});
  using L = lanes_of<T, static_cast<int>(at_once)>;

 public:
  static constexpr int width = cell_width<Cell::D, Width>;  ///< points that come at once
  using P = lanes_of<T, width>;

  /// What a pack of points hands over, by channel; 0 where nothing is set.
  struct Handed {
    std::array<P, lanes> own_;
    std::array<std::array<P, lanes>, D> along_;

    Handed() {
      repeat<lanes>([&](std::size_t k) {
        own_[k] = P(0);
        repeat<D>([&](std::size_t a) { along_[a][k] = P(0); });
      });
    }
    template <class Name>
    P& own(Name name, std::size_t k = 0) {
      return own_[Lanes::first(name) + k];
    }
    template <class Name>
    P& slope(std::size_t axis, Name name, std::size_t k) {
      return along_[axis][Lanes::first(name) + k];
    }
    /// Momentum of a velocity field.
    template <class Field>
    void momentum(const P& m, const Field& v) {
      repeat<D>([&](std::size_t d) { own(node_channel::momentum, d) = m * v.value[d]; });
      repeat<Field::linear ? D * D : 0>(
          [&](std::size_t k) { slope(k / D, node_channel::momentum, k % D) = m * v.gradient[k]; });
    }
  };

  Rows() {}  // a row is written before it is read: nothing to clear for each cell

  bool full() const { return count_ + width > capacity; }

  /// Takes the first `count` points of a pack.
  void push(int count, const Handed& handed, const Lines<P, Cell>& line) {
    store_rows<at_once>(handed.own_, own_[count_].data());
    repeat<D>([&](std::size_t a) {
      store_rows<at_once>(handed.along_[a], along_[a][count_].data());
      repeat<N>([&](std::size_t i) {
        store_lanes(&value_[a][i][count_], width, line.value[a][i]);
        store_lanes(&moment_[a][i][count_], width, line.moment[a][i]);
        store_lanes(&slope_[a][i][count_], width, line.slope[a][i]);
      });
    });
    count_ += static_cast<std::size_t>(count);
  }

  /// Calls `add(node, lane, pack)` with what each local node collects in the lanes from number `lane` on, and
  /// forgets the points. A pack of lanes after the other, so that the sums of a layer of nodes stay in
  /// registers.
  template <class Add>
  void spread(Add&& add) {
    repeat<lanes / at_once>([&](std::size_t part) {
      if (!Lanes::uses(part * at_once, at_once)) return;
      repeat_all<D == 2 ? 1 : N>([&](std::size_t k) { spread_layer(part * at_once, k, add); });
    });
    count_ = 0;
  }

 private:
  static constexpr std::size_t capacity = 32;
  using Row = std::array<T, lanes>;
  using LineColumns = std::array<std::array<std::array<T, capacity>, N>, D>;

  /// `moment` in lanes by value, `slope` in lanes by slope, of those from number `lane` on.
  static L by_kind(std::size_t lane, T moment, T slope) {
    constexpr std::size_t split = Lanes::slopes % at_once;
    if (split == 0 || lane + at_once <= Lanes::slopes || lane >= Lanes::slopes)
      return L(lane < Lanes::slopes ? moment : slope);
    if constexpr (split != 0) return blend<split>(L(moment), L(slope), std::make_index_sequence<at_once>{});
    return L(moment);
  }
  template <std::size_t Split, std::size_t... At>
  static L blend(const L& moment, const L& slope, std::index_sequence<At...>) {
    return L::from(
        __builtin_shufflevector(moment.lanes(), slope.lanes(), (At < Split ? At : At + at_once)...));
  }

  /// Sums of layer k of the nodes (all of them, in the plane), in the lanes from number `lane` on.
  template <class Add>
  void spread_layer(std::size_t lane, std::size_t k, Add& add) const {
    const auto row = [&](const Row& of) {
      return load_lanes<L>(of.data() + lane, static_cast<int>(at_once));
    };
    const auto second = [&](std::size_t a, std::size_t i, std::size_t p) {
      return by_kind(lane, moment_[a][i][p], slope_[a][i][p]);
    };
    const bool has_slopes = Lanes::has_slopes(lane, at_once);
    std::array<L, N * N> sum;
    repeat<N * N>([&](std::size_t n) { sum[n] = L(0); });
    for (std::size_t p = 0; p < count_; ++p) {
      L rest = row(own_[p]), x = row(along_[0][p]), y = row(along_[1][p]);
      if constexpr (D == 3) {
        const L n(value_[2][k][p]);
        rest = rest * n;
        if (has_slopes) rest += row(along_[2][p]) * second(2, k, p);
        x = x * n;
        y = y * n;
      }
      std::array<L, N> n_x, g_x;
      repeat<N>([&](std::size_t i) {
        n_x[i] = L(value_[0][i][p]);
        g_x[i] = second(0, i, p);
      });
      repeat<N>([&](std::size_t j) {
        const L n(value_[1][j][p]), along_x = x * n;
        L line = rest * n;
        if (has_slopes) line += y * second(1, j, p);
        repeat<N>([&](std::size_t i) {
          sum[N * j + i] += line * n_x[i];
          if (has_slopes) sum[N * j + i] += along_x * g_x[i];
        });
      });
    }
    repeat<N * N>([&](std::size_t n) { add(N * N * k + n, lane, sum[n]); });
  }

  std::size_t count_ = 0;
  alignas(64) std::array<Row, capacity> own_;
  std::array<std::array<Row, capacity>, D> along_;
  LineColumns value_, moment_, slope_;
};

}  // namespace product
}  // namespace arenite::inline ARENITE_INSTRUCTION_SET
