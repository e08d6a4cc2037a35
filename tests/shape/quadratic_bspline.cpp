// Quadratic B-splines on a grid, at its faces and corners, and in grids of one and two cells.
#include "grids.hpp"

using namespace arenite;
using namespace arenite::test;

TEMPLATE_TEST_CASE("quadratic B-spline: unity, linear fields and gradients", "", double, float) {
  check_completeness<QuadraticBSpline, TestType>();
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

TEST_CASE("B-spline: on a face only the nodes of the face have a value; no jumps from cell to cell") {
  check_faces<QuadraticBSpline>();
  CHECK(greatest_jump<QuadraticBSpline>(false) < 1e-14);
  CHECK(greatest_jump<QuadraticBSpline>(true) < 1e-14);
}

static_assert(shape_function<QuadraticBSpline, CartesianGrid<2>> &&
              shape_function<QuadraticBSpline, CartesianGrid<3, float>>);
static_assert(!shape_function<QuadraticBSpline, SimplexMesh<2>>);
