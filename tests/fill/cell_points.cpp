// Initial points of a cell: how many, where, and what equal weights integrate exactly.
#include "catch.hpp"

#include <arenite/fill/cell_points.hpp>
#include <arenite/fill/jitter.hpp>
#include <arenite/mesh/rectilinear_grid.hpp>

#include "../mesh/sample_meshes.hpp"

using namespace arenite;
using namespace arenite::test;

namespace {

/// Mean of b_i b_j over a simplex of D + 1 corners: (1 + delta_ij) / ((D + 1)(D + 2)).
template <int D>
double quadratic_error(int n) {
  const auto points = simplex_points<D>(n);
  Eigen::Matrix<double, D + 1, D + 1> mean = decltype(mean)::Zero();
  for (const auto& b : points) mean += b * b.transpose() / n;
  const Eigen::Matrix<double, D + 1, D + 1> exact =
      (decltype(mean)::Ones() + decltype(mean)::Identity()) / ((D + 1) * (D + 2));
  return (mean - exact).norm();
}

template <int D>
void check_points(int n) {
  const auto points = simplex_points<D>(n);
  CAPTURE(n);
  REQUIRE(points.size() == static_cast<std::size_t>(n));
  Eigen::Matrix<double, D + 1, 1> mean = decltype(mean)::Zero();
  double least = 1, nearest = 1;
  for (std::size_t i = 0; i < points.size(); ++i) {
    REQUIRE(std::abs(points[i].sum() - 1) < 1e-15);
    mean += points[i] / n;
    least = std::min(least, points[i].minCoeff());
    for (std::size_t j = 0; j < i; ++j) nearest = std::min(nearest, (points[i] - points[j]).norm());
  }
  REQUIRE((mean - decltype(mean)::Constant(1.0 / (D + 1))).norm() < 1e-14);  // linear fields are exact
  REQUIRE(least > 0.01);                                                     // inside, not on a face
  REQUIRE(nearest > 0.05);
}

}  // namespace

TEST_CASE("lattices of a simplex integrate quadratics exactly with equal weights") {
  for (const int n : {3, 6, 10, 15, 21, 28}) {
    check_points<2>(n);
    REQUIRE(quadratic_error<2>(n) < 1e-14);
  }
  for (const int n : {4, 10, 20, 35, 56, 84}) {
    check_points<3>(n);
    REQUIRE(quadratic_error<3>(n) < 1e-14);
  }
}

TEST_CASE("one point, and the centroids of equal parts, integrate linear fields exactly") {
  for (const int n : {1, 4, 9, 16, 25, 36, 49}) check_points<2>(n);
  check_points<3>(1);
}

TEST_CASE("three points of a triangle and four of a tetrahedron are the classic ones") {
  // Strang and Fix 1973: coordinates 2/3, 1/6, 1/6; Keast 1986: 0.5854.., 0.1381..
  for (const auto& b : simplex_points<2>(3))
    REQUIRE((std::abs(b.maxCoeff() - 2.0 / 3) < 1e-15 && std::abs(b.minCoeff() - 1.0 / 6) < 1e-15));
  for (const auto& b : simplex_points<3>(4))
    REQUIRE((std::abs(b.maxCoeff() - (5 + 3 * std::sqrt(5.0)) / 20) < 1e-15 &&
             std::abs(b.minCoeff() - (5 - std::sqrt(5.0)) / 20) < 1e-15));
}

TEST_CASE("lattices of a square and a cube") {
  REQUIRE(lattice_points<2>(4)[0] == Vec<double, 2>(0.25, 0.25));
  REQUIRE(lattice_points<2>(4)[1] == Vec<double, 2>(0.75, 0.25));
  REQUIRE(lattice_points<3>(27).size() == 27);
  REQUIRE((lattice_points<3>(27)[26] - Vec<double, 3>::Constant(2.5 / 3)).norm() < 1e-15);
  REQUIRE(lattice_points<2>(1)[0] == Vec<double, 2>(0.5, 0.5));
}

TEST_CASE("points as far apart along all axes of a cell of a grid") {
  using Counts = std::array<int, 2>;
  REQUIRE(even_counts<double, 2>(9, {1, 1}) == Counts{3, 3});
  REQUIRE(even_counts<double, 2>(9, {0.25, 1}) == Counts{2, 6});
  REQUIRE(even_counts<double, 2>(9, {100, 1}) == Counts{30, 2});
  REQUIRE(even_counts<double, 2>(1, {100, 1}) == Counts{10, 1});
  REQUIRE(even_counts<float, 3>(8, {1, 1, 8}) == std::array<int, 3>{2, 2, 8});
  REQUIRE(throws([] { even_counts<double, 2>(8, {1, 1}); }, "per_cell = 8: must be a square (1, 4, 9, ..)"));
  const RectilinearGrid<2> grid{{.x = {0, 0.25, 1.25}, .y = {0, 1, 4}}};
  const auto points = initial_points(grid, 0, 9, true);
  REQUIRE(points.size() == 12);
  REQUIRE((points[0] - Vec<double, 2>(0.0625, 1. / 12)).norm() < 1e-15);
  for (Index c = 0; c < grid.cell_count(); ++c) {
    auto moved = initial_points(grid, c, 9, true);
    jitter_points(grid, c, c, 1, 7, moved, 9, true);
    for (const auto& x : moved) REQUIRE(grid.walk(x) == c);
  }
}

TEST_CASE("other numbers are refused, and the message says which are not") {
  for (const int n : {-3, 0, 2, 5, 7, 64})
    REQUIRE(
        throws([&] { simplex_points<2>(n); },
               joined_text({"per_cell = ", n, ": must be 1, 3, 6, 10, 15, 21, 28 or the square of 1 to 7"})));
  for (const int n : {-1, 0, 2, 5, 8, 9})
    REQUIRE(throws([&] { simplex_points<3>(n); }, "must be 1, 4, 10, 20, 35, 56 or 84"));
  for (const int n : {-4, 0, 2, 3, 8})
    REQUIRE(throws([&] { lattice_points<2>(n); },
                   joined_text({"per_cell = ", n, ": must be a square (1, 4, 9, ..)"})));
  for (const int n : {-8, 0, 2, 4, 9})
    REQUIRE(throws([&] { lattice_points<3>(n); }, "must be a cube (1, 8, 27, ..)"));
}

TEST_CASE("points of a cell lie in it") {
  const auto flat = sample_mesh<2>(3);
  const auto solid = sample_mesh<3, float>(2);
  const CartesianGrid<3> grid({.lower = {1, 2, 3}, .upper = {3, 4, 5}, .cell = 1});
  for (Index c = 0; c < flat.cell_count(); ++c)
    for (const auto& x : initial_points(flat, c, 10)) REQUIRE(flat.walk(x, c) == c);
  for (Index c = 0; c < solid.cell_count(); ++c)
    for (const auto& x : initial_points(solid, c, 10)) REQUIRE(solid.walk(x, c) == c);
  for (Index c = 0; c < grid.cell_count(); ++c)
    for (const auto& x : initial_points(grid, c, 27)) REQUIRE(grid.walk(x) == c);
}
