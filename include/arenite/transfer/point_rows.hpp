// Point rows: what the points of a cell hand to its nodes where the shape functions are products along the
// axes. Each point is a row of eight lanes, its momentum, mass and force at once, so that no sum over points
// has to be taken apart.
#pragma once

#include <arenite/transfer/node_sums.hpp>
#include <arenite/transfer/tensor_product.hpp>

namespace arenite::inline ARENITE_INSTRUCTION_SET {

/// Rows of up to `capacity` points. A node at (i, j, k) of the cell's 3^D collects, with line functions N and
/// a second kind G along each axis: N_i N_j N_k own + G_i N_j N_k along[0] + N_i G_j N_k along[1] + .., where
/// G is N times the way to the node in the lower four lanes (for an affine velocity) and the slope of N in
/// the upper four (for a force).
template <class T, std::size_t D, int Width>
class PointRows {
 public:
  using Lanes = EightLanes<T, Width>;
  using Sums = NodeSums<T, static_cast<int>(D)>;
  static constexpr int width = cell_width<static_cast<int>(D), Width>;
  using P = lanes_of<T, width>;
  using Lines = LineFunctions<P, D>;

  /// Columns of a pack of points that become rows.
  struct Handed {
    std::array<P, 8> own;
    std::array<std::array<P, 8>, D> along;

    Handed() {
      repeat<8>([&](std::size_t k) {
        own[k] = P(0);
        repeat<D>([&](std::size_t a) { along[a][k] = P(0); });
      });
    }
  };

  PointRows() {}  // a row is written before it is read: nothing to clear for each cell

  bool full() const { return count_ + width > capacity; }

  /// Takes the first `count` points of a pack.
  void push(int count, const Handed& handed, const Lines& value, const Lines& lower, const Lines& upper) {
    store_rows<Lanes>(handed.own, own_[count_].data());
    repeat<D>([&](std::size_t a) {
      store_rows<Lanes>(handed.along[a], along_[a][count_].data());
      repeat<3>([&](std::size_t i) {
        store_lanes(&value_[a][i][count_], width, value[a][i]);
        store_lanes(&lower_[a][i][count_], width, lower[a][i]);
        store_lanes(&upper_[a][i][count_], width, upper[a][i]);
      });
    });
    count_ += static_cast<std::size_t>(count);
  }

  /// Calls `add(node, lane, pack)` with what each local node collects in the lanes from number `lane` on, and
  /// forgets the points. A pack of lanes after the other, so that the sums of a layer of nodes stay in
  /// registers.
  template <class Add>
  void spread(Add&& add) {
    repeat<Lanes::parts>([&](std::size_t part) {
      if (!Sums::uses(part * Lanes::width, Lanes::width)) return;
      repeat<D == 2 ? 1 : 3>([&](std::size_t k) { spread_layer(part, k, add); });
    });
    count_ = 0;
  }

 private:
  static constexpr std::size_t capacity = 32;
  using L = typename Lanes::P;
  using Row = std::array<T, 8>;
  using LineColumns = std::array<std::array<std::array<T, capacity>, 3>, D>;

  template <class Add>
  void spread_layer(std::size_t part, std::size_t k, Add& add) const {
    const auto lanes = [&](const Row& row) {
      return load_lanes<L>(row.data() + part * Lanes::width, static_cast<int>(Lanes::width));
    };
    const auto second = [&](std::size_t a, std::size_t i, std::size_t p) {
      return Lanes::half_part(part, lower_[a][i][p], upper_[a][i][p]);
    };
    const bool has_gradient = Sums::has_gradient(part * Lanes::width, Lanes::width);
    std::array<L, 9> sum;
    repeat<9>([&](std::size_t n) { sum[n] = L(0); });
    for (std::size_t p = 0; p < count_; ++p) {
      L rest = lanes(own_[p]), x = lanes(along_[0][p]), y = lanes(along_[1][p]);
      if constexpr (D == 3) {
        const L n(value_[2][k][p]);
        rest = rest * n;
        if (has_gradient) rest += lanes(along_[2][p]) * second(2, k, p);
        x = x * n;
        y = y * n;
      }
      std::array<L, 3> n_x, g_x;
      repeat<3>([&](std::size_t i) {
        n_x[i] = L(value_[0][i][p]);
        g_x[i] = second(0, i, p);
      });
      repeat<3>([&](std::size_t j) {
        const L n(value_[1][j][p]), along_x = x * n;
        L line = rest * n;
        if (has_gradient) line += y * second(1, j, p);
        repeat<3>([&](std::size_t i) {
          sum[3 * j + i] += line * n_x[i];
          if (has_gradient) sum[3 * j + i] += along_x * g_x[i];
        });
      });
    }
    repeat<9>([&](std::size_t n) { add(9 * k + n, part * Lanes::width, sum[n]); });
  }

  std::size_t count_ = 0;
  alignas(64) std::array<Row, capacity> own_;
  std::array<std::array<Row, capacity>, D> along_;
  LineColumns value_, lower_, upper_;
};

}  // namespace arenite::inline ARENITE_INSTRUCTION_SET
