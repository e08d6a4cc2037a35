// Channels of a user's own beside momentum, mass and force: rows of several groups of lanes.
#include <arenite/transfer/product/rows.hpp>

#include "catch.hpp"
#include "setup.hpp"

using namespace arenite;
using namespace arenite::test;

namespace {

using product::Contribution;

/// Sums of one cell by rows against sums point by point, of random points. Groups: momentum (by value and with moments) and mass; heat
/// and moisture (by value); a force and a flow of heat (by slope).
template <int Width, class Cell, class Grid>
double off(const Grid& grid, Index c, const Cell& cell, std::mt19937& random) {
  constexpr std::size_t D = Cell::D, lanes = D + 1, groups = 3;
  using Rows = product::Rows<Cell, Width, Contribution::both, Contribution::by_value, Contribution::by_axis>;
  using P = typename Rows::P;
  constexpr int width = Rows::width;
  std::uniform_real_distribution<double> number(-1, 1);
  Eigen::MatrixXd sum = Eigen::MatrixXd::Zero(4 * groups, Cell::size), expected = sum;
  Rows rows;
  const auto spread = [&] {
    const auto add_to = [&](int group) {
      return [&, group](std::size_t i, std::size_t lane, const auto& of) {
        using L = std::remove_cvref_t<decltype(of)>;
        std::array<double, 8> all{};
        store_lanes(all.data() + lane, lane_count<L>, of);
        for (int k = 0; k < 4; ++k)
          sum(4 * group + k, static_cast<int>(i)) += all[static_cast<std::size_t>(k)];
      };
    };
    rows.template spread<0>(add_to(0));
    rows.template spread<1>(add_to(1));
    rows.template spread<2>(add_to(2));
    rows.forget();
  };
  for (int pack = 0; pack < 12; ++pack) {
    if (rows.full()) spread();
    const int count = 1 + pack % width;
    std::array<std::array<double, 8>, D> x{};
    // Of each group by value, and along each axis.
    std::array<std::array<std::array<double, 8>, lanes>, groups> own{};
    std::array<std::array<std::array<std::array<double, 8>, lanes>, D>, groups> along{};
    for (std::size_t p = 0; p < width; ++p) {
      const auto place = random_point(grid, c, random);
      for (std::size_t a = 0; a < D; ++a) x[a][p] = place[static_cast<int>(a)];
      if (static_cast<int>(p) >= count) continue;
      const auto w = cell.weights(place);
      const auto g = cell.gradients(place);
      const auto nodes = cell.node_positions();
      for (std::size_t group = 0; group < groups; ++group)
        for (std::size_t k = 0; k < lanes; ++k) {
          if (group < 2) own[group][k][p] = number(random);
          for (std::size_t a = 0; a < D; ++a)
            if (group == 2 || (group == 0 && k < D)) along[group][a][k][p] = number(random);
          for (int i = 0; i < Cell::size; ++i) {
            double& to = expected(static_cast<int>(4 * group + k), i);
            to += own[group][k][p] * w[i];
            for (int a = 0; a < static_cast<int>(D); ++a)
              to += along[group][static_cast<std::size_t>(a)][k][p] *
                    (group == 0 ? w[i] * (nodes(a, i) - place[a]) : g(a, i));
          }
        }
    }
    const auto packs = [](const auto& of) {
      std::array<P, lanes> all;
      for (std::size_t k = 0; k < lanes; ++k) all[k] = load_lanes<P>(of[k].data(), width);
      return all;
    };
    std::array<P, D> at;
    for (std::size_t a = 0; a < D; ++a) at[a] = load_lanes<P>(x[a].data(), width);
    const product::Lines<P, Cell> line(cell, at);
    rows.template hand<0>(
        line, packs(own[0]), [&](std::size_t a) { return packs(along[0][a]); }, Nothing{});
    rows.template hand<1>(line, packs(own[1]), Nothing{}, Nothing{});
    rows.template hand<2>(line, Nothing{}, Nothing{}, [&](std::size_t a) { return packs(along[2][a]); });
    rows.take(count, line);
  }
  spread();
  return (sum - expected).template lpNorm<Eigen::Infinity>();
}

template <class Shape, class Grid>
void check(const Grid& grid, int inner_cells) {
  std::mt19937 random(5);
  int inner = 0;
  for (Index c = 0; c < grid.cell_count(); ++c)
    Shape::visit_cell(grid, c, [&](const auto& cell) {
      inner += cell.is_inner;
      CHECK(off<1>(grid, c, cell, random) < 1e-12);
      CHECK(off<2>(grid, c, cell, random) < 1e-12);
      CHECK(off<4>(grid, c, cell, random) < 1e-12);
      CHECK(off<8>(grid, c, cell, random) < 1e-12);
    });
  CHECK(inner == inner_cells);
}

}  // namespace

TEST_CASE("channels of a user's own: rows of several groups have the sums of the nodes") {
  const CartesianGrid<2> flat{{.lower = {0, 0}, .upper = {1.25, 1.25}, .cell = 0.25}};
  const CartesianGrid<3> solid{{.lower = {0, 0, 0}, .upper = {1.25, 1.25, 1.25}, .cell = 0.25}};
  check<QuadraticBSpline>(flat, 9);
  check<CubicBSpline>(flat, 1);
  check<LinearGrid>(flat, 0);
  check<QuadraticBSpline>(solid, 27);
  check<CubicBSpline>(solid, 1);
  check<LinearGrid>(solid, 0);
}
