// Cubic B-splines on a grid, at its faces and corners, and in grids of one, two and three cells.
#include "grids.hpp"

using namespace arenite;
using namespace arenite::test;

TEMPLATE_TEST_CASE("cubic B-spline: unity, linear fields and gradients", "", double, float) {
  check_completeness<CubicBSpline, TestType>();
}

TEST_CASE("cubic B-spline: on a face only the nodes of the face have a value; no jumps from cell to cell") {
  check_faces<CubicBSpline>();
  CHECK(greatest_jump<CubicBSpline>(false) < 1e-14);
  CHECK(greatest_jump<CubicBSpline>(true) < 1e-13);
}

TEST_CASE("cubic B-spline: in the inner cells the values are the textbook's") {
  const auto g = grid<2>({9, 9}, 1);
  const CubicBSpline::Cell<CartesianGrid<2>> cell(g, 40);
  const auto n = [](double u) {
    u = std::abs(u);
    return u <= 1 ? 2.0 / 3 - u * u + u * u * u / 2 : u < 2 ? (2 - u) * (2 - u) * (2 - u) / 6 : 0;
  };
  const Vec<double, 2> x(4.3, 4.9);
  const auto w = cell.weights(x);
  for (int i = 0; i < 16; ++i) {
    const auto at = CubicBSpline::node_position(g, cell.nodes[static_cast<std::size_t>(i)]);
    CHECK(std::abs(w[i] - n(x[0] - at[0]) * n(x[1] - at[1])) < 1e-15);
  }
}

TEST_CASE("cubic B-spline: at a face the values are those of four knots in one place") {
  const auto g = grid<2>({9, 9}, 1);
  const CubicBSpline::Cell<CartesianGrid<2>> cell(g, 0);
  for (const double s : {0.0, 0.2, 0.5, 0.9, 1.0}) {
    const auto w = cell.line_values(std::array<double, 2>{s, 0.5})[0];
    CHECK(std::abs(w[0] - (1 - s) * (1 - s) * (1 - s)) < 1e-15);
    CHECK(std::abs(w[1] - (3 * s - 4.5 * s * s + 1.75 * s * s * s)) < 1e-15);
    CHECK(std::abs(w[2] - (1.5 * s * s - 11 * s * s * s / 12)) < 1e-15);
    CHECK(std::abs(w[3] - s * s * s / 6) < 1e-15);
  }
}

TEST_CASE("cubic B-spline: nodes at the faces, then a third of a cell inwards, then at the cells' corners") {
  const auto g = grid<2>({4, 1}, 1);
  REQUIRE(CubicBSpline::node_count(g) == 7 * 4);
  const std::array<double, 7> along{0, 1.0 / 3, 1, 2, 3, 11.0 / 3, 4};
  for (Index i = 0; i < 7; ++i) CHECK(std::abs(CubicBSpline::node_position(g, i)[0] - along[i]) < 1e-15);
  const std::array<double, 4> across{0, 1.0 / 3, 2.0 / 3, 1};
  for (Index j = 0; j < 4; ++j) CHECK(std::abs(CubicBSpline::node_position(g, 7 * j)[1] - across[j]) < 1e-15);
}

TEST_CASE("the stated steepness is not exceeded away from the faces") {
  CHECK(steepest<CubicBSpline>() <= CubicBSpline::steepness);
  CHECK(steepest<QuadraticBSpline>() <= QuadraticBSpline::steepness);
  CHECK(steepest<QuadraticBSpline>() >= 0.99 * QuadraticBSpline::steepness);
}

static_assert(shape_function<CubicBSpline, CartesianGrid<2>> &&
              shape_function<CubicBSpline, CartesianGrid<3, float>>);
static_assert(!shape_function<CubicBSpline, SimplexMesh<2>>);
