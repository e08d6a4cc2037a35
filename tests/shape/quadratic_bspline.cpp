// Quadratic B-splines on a grid, at its faces and corners, and in grids of one and two cells.
#include "catch.hpp"
#include "shapes.hpp"

#include <set>

using namespace arenite;
using namespace arenite::test;

namespace {

template <int D, class T = double>
CartesianGrid<D, T> grid(std::array<int, D> n, double cell = 0.25, double lower = 0) {
  typename CartesianGrid<D, T>::Parameters p;
  for (std::size_t k = 0; k < D; ++k) {
    p.lower[k] = lower;
    p.upper[k] = lower + n[k] * cell;
  }
  p.cell = cell;
  return CartesianGrid<D, T>(p);
}

}  // namespace

TEMPLATE_TEST_CASE("B-spline in two dimensions: unity, linear fields and gradients", "", double, float) {
  for (const auto& n : {std::array<int, 2>{1, 1}, {2, 2}, {1, 2}, {3, 1}, {5, 4}}) {
    for (const double cell : {0.25, 0.1}) {
      const auto v = violations<QuadraticBSpline>(grid<2, TestType>(n, cell, -0.2));
      const double scale = sizeof(TestType) == 8 ? 1 : 2e8;
      REQUIRE(v.worst() < 1e-14 * scale);
      REQUIRE(v.difference < 2e-11 * scale);
    }
  }
}

TEMPLATE_TEST_CASE("B-spline in three dimensions: unity, linear fields and gradients", "", double, float) {
  for (const auto& n : {std::array<int, 3>{1, 1, 1}, {2, 2, 2}, {1, 2, 3}, {4, 3, 4}}) {
    const auto v = violations<QuadraticBSpline>(grid<3, TestType>(n, 0.1, -0.2));
    const double scale = sizeof(TestType) == 8 ? 1 : 2e8;
    REQUIRE(v.worst() < 1e-14 * scale);
    REQUIRE(v.difference < 2e-11 * scale);
  }
}

TEST_CASE("B-spline: in the inner cells the values are the textbook's") {
  const auto g = grid<2>({5, 5}, 1);
  const QuadraticBSpline::Cell<CartesianGrid<2>> cell(g, 12);
  // N(u) = 3/4 - u^2 for |u| <= 1/2, (3/2 - |u|)^2 / 2 up to 3/2; u from the cell centres.
  const auto n = [](double u) {
    return std::abs(u) <= 0.5 ? 0.75 - u * u : std::abs(u) < 1.5 ? square(1.5 - std::abs(u)) / 2 : 0;
  };
  const Vec<double, 2> x(2.3, 2.9);
  const auto w = cell.weights(x);
  for (int i = 0; i < 9; ++i) {
    const auto at = QuadraticBSpline::node_position(g, cell.nodes[static_cast<std::size_t>(i)]);
    REQUIRE(std::abs(w[i] - n(x[0] - at[0]) * n(x[1] - at[1])) < 1e-15);
  }
}

TEST_CASE("B-spline: nodes at the faces, then half a cell inwards") {
  const auto g = grid<2>({3, 1}, 1);
  REQUIRE(QuadraticBSpline::node_count(g) == 5 * 3);
  const std::array<double, 5> along{0, 0.5, 1.5, 2.5, 3};
  for (Index i = 0; i < 5; ++i) REQUIRE(QuadraticBSpline::node_position(g, i)[0] == along[i]);
  const std::array<double, 3> across{0, 0.5, 1};
  for (Index j = 0; j < 3; ++j) REQUIRE(QuadraticBSpline::node_position(g, 5 * j)[1] == across[j]);
}

TEST_CASE("B-spline: on a face only the nodes of the face have a value, at a corner only one") {
  for (const auto& n : {std::array<int, 2>{1, 1}, {2, 2}, {4, 3}}) {
    const auto g = grid<2>(n, 1);
    std::mt19937 random(1);
    for (Index c = 0; c < g.cell_count(); ++c) {
      const QuadraticBSpline::Cell<CartesianGrid<2>> cell(g, c);
      for (const double end : {0.0, static_cast<double>(n[0])}) {
        if (g.walk({end, g.corner(c)[1] + 0.4}) != c) continue;
        const auto w = cell.weights({end, g.corner(c)[1] + 0.4});
        for (int i = 0; i < 9; ++i)
          if (QuadraticBSpline::node_position(g, cell.nodes[static_cast<std::size_t>(i)])[0] != end)
            REQUIRE(w[i] == 0);
      }
    }
    const QuadraticBSpline::Cell<CartesianGrid<2>> first(g, 0);
    REQUIRE(first.weights({0, 0}) == decltype(first)::Weights::Unit(0));
  }
}

TEST_CASE("B-spline: values and slopes go on without a jump from cell to cell") {
  const auto g = grid<2>({4, 4}, 1);
  double jump = 0;
  for (const double x : {1.0, 2.0, 3.0})
    for (const double y : {0.3, 1.7, 3.9}) {
      const Index right = g.walk({x + 1e-9, y}), left = right - 1;
      const QuadraticBSpline::Cell<CartesianGrid<2>> a(g, left), b(g, right);
      Eigen::VectorXd w = Eigen::VectorXd::Zero(QuadraticBSpline::node_count(g));
      Eigen::MatrixXd slope = Eigen::MatrixXd::Zero(2, w.size());
      for (int i = 0; i < 9; ++i) {
        const auto in_a = a.nodes[static_cast<std::size_t>(i)], in_b = b.nodes[static_cast<std::size_t>(i)];
        w[in_a] += a.weights({x, y})[i];
        w[in_b] -= b.weights({x, y})[i];
        slope.col(in_a) += a.gradients({x, y}).col(i);
        slope.col(in_b) -= b.gradients({x, y}).col(i);
      }
      jump = std::max({jump, w.norm(), slope.norm()});
    }
  REQUIRE(jump < 1e-14);
}

static_assert(shape_function<QuadraticBSpline, CartesianGrid<2>> &&
              shape_function<QuadraticBSpline, CartesianGrid<3, float>>);
static_assert(!shape_function<QuadraticBSpline, SimplexMesh<2>>);
