// Channels of a user's own beside momentum, mass and force: more than eight scalars a node, in rows of any
// length.
#include <arenite/transfer/product/rows.hpp>

#include "catch.hpp"
#include "setup.hpp"

using namespace arenite;
using namespace arenite::test;

namespace {

struct Heat {};      // sum m c T w, J: handed over by value
struct Moisture {};  // several scalars by value
struct HeatFlow {};  // sum V q . grad w, W: by slope

/// Sums by rows against sums point by point, of random points in each cell. `Moistures`: so many scalars of
/// that name, which move the lanes by slope.
template <class Shape, int D, std::size_t Moistures, int Width>
double off(const CartesianGrid<D>& grid) {
  using Cell = typename Shape::template Cell<CartesianGrid<D>>;
  using Lanes = NodeLanes<ChannelList<Channel<node_channel::Momentum, D>, Channel<node_channel::Mass, 1>,
                                      Channel<Heat, 1>, Channel<Moisture, Moistures>>,
                          ChannelList<Channel<node_channel::Force, D>, Channel<HeatFlow, 1>>>;
  static_assert(Lanes::size > 8 && Lanes::size % 8 == 0);
  using Rows = product::Rows<Cell, Lanes, Width>;
  using P = typename Rows::P;
  constexpr int width = Rows::width;
  std::mt19937 random(5);
  std::uniform_real_distribution<double> number(-1, 1);
  double worst = 0;
  for (Index c = 0; c < grid.cell_count(); ++c) {
    const Cell cell(grid, c);
    Eigen::MatrixXd sum = Eigen::MatrixXd::Zero(Lanes::size, Cell::size), expected = sum;
    Rows rows;
    const auto spread = [&] {
      rows.spread([&](std::size_t i, std::size_t lane, const auto& lanes) {
        using L = std::remove_cvref_t<decltype(lanes)>;
        std::array<double, Lanes::size> all{};
        store_lanes(all.data() + lane, lane_count<L>, lanes);
        for (std::size_t k = 0; k < Lanes::size; ++k) sum(static_cast<int>(k), static_cast<int>(i)) += all[k];
      });
    };
    for (int pack = 0; pack < 12; ++pack) {
      if (rows.full()) spread();
      const int count = 1 + pack % width;
      std::array<std::array<double, 8>, D> x{};
      typename Rows::Handed handed;
      std::array<std::array<double, 8>, Lanes::size> own{};
      std::array<std::array<std::array<double, 8>, Lanes::size>, D> along{};
      for (std::size_t p = 0; p < width; ++p) {
        const auto place = random_point(grid, c, random);
        for (std::size_t a = 0; a < D; ++a) x[a][p] = place[static_cast<int>(a)];
        const bool is_there = static_cast<int>(p) < count;
        for (std::size_t k = 0; k < Lanes::slopes && is_there; ++k) {
          if (k >= D + 2 + Moistures) continue;
          own[k][p] = number(random);
          for (std::size_t a = 0; a < D; ++a)
            if (k < D) along[a][k][p] = number(random);  // an affine velocity
        }
        for (std::size_t k = Lanes::slopes; k < Lanes::slopes + D + 1 && is_there; ++k)
          for (std::size_t a = 0; a < D; ++a) along[a][k][p] = number(random);
        const auto w = cell.weights(place);
        const auto g = cell.gradients(place);
        const auto nodes = cell.node_positions();
        for (int i = 0; i < Cell::size; ++i)
          for (std::size_t k = 0; k < Lanes::size; ++k) {
            double& to = expected(static_cast<int>(k), i);
            to += own[k][p] * w[i];
            for (int a = 0; a < D; ++a)
              to += along[static_cast<std::size_t>(a)][k][p] *
                    (k < Lanes::slopes ? w[i] * (nodes(a, i) - place[a]) : g(a, i));
          }
      }
      std::array<P, D> at;
      for (std::size_t a = 0; a < D; ++a) at[a] = load_lanes<P>(x[a].data(), width);
      for (std::size_t k = 0; k < Lanes::size; ++k) {
        handed.own_[k] = load_lanes<P>(own[k].data(), width);
        for (std::size_t a = 0; a < D; ++a) handed.along_[a][k] = load_lanes<P>(along[a][k].data(), width);
      }
      rows.push(count, handed, product::Lines<P, Cell>(cell, at));
    }
    spread();
    for (std::size_t k = 0; k < Lanes::size; ++k)
      if (Lanes::uses(k, 1))
        worst = std::max(worst, (sum - expected).row(static_cast<int>(k)).template lpNorm<Eigen::Infinity>());
  }
  return worst;
}

template <class Shape, int D, std::size_t Moistures>
void check(const CartesianGrid<D>& grid) {
  CHECK(off<Shape, D, Moistures, 1>(grid) < 1e-12);
  CHECK(off<Shape, D, Moistures, 2>(grid) < 1e-12);
  CHECK(off<Shape, D, Moistures, 4>(grid) < 1e-12);
  CHECK(off<Shape, D, Moistures, 8>(grid) < 1e-12);
}

}  // namespace

TEST_CASE("channels of a user's own: rows of 16 and 24 lanes hold what nodes collect") {
  check<QuadraticBSpline, 2, 1>(flat_grid());   // 8 lanes by value, 3 by slope
  check<QuadraticBSpline, 2, 6>(flat_grid());   // 12 by value: one group of eight mixes both
  check<QuadraticBSpline, 2, 13>(flat_grid());  // 20 by value: the third
  check<LinearGrid, 2, 6>(flat_grid());
  check<CubicBSpline, 2, 1>(flat_grid());
  check<LinearGrid, 3, 5>(solid_grid());
}
