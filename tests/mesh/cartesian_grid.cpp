// The Cartesian grid: places, faces, refusals.
#include "catch.hpp"
#include "sample_meshes.hpp"

using namespace arenite;
using namespace arenite::test;

TEST_CASE("cells are numbered with x running fastest") {
  const CartesianGrid<3> grid({.lower = {0, 1, 2}, .upper = {2, 4, 3}, .cell = 0.5});
  REQUIRE(grid.cell_count() == 4 * 6 * 2);
  REQUIRE(grid.volume(0) == 0.125);
  REQUIRE(grid.size(0) == 0.5);
  REQUIRE(grid.node_size(0) == 0.5);
  REQUIRE(grid.place(1) == std::array<Index, 3>{1, 0, 0});
  REQUIRE(grid.place(4) == std::array<Index, 3>{0, 1, 0});
  REQUIRE(grid.place(24) == std::array<Index, 3>{0, 0, 1});
  REQUIRE((grid.corner(29) - Vec<double, 3>(0.5, 1.5, 2.5)).norm() == 0);
  for (Index c = 0; c < grid.cell_count(); ++c)
    REQUIRE(grid.walk(grid.corner(c) + Vec<double, 3>(0.2, 0.3, 0.4)) == c);
}

TEST_CASE("faces and corners of the box belong to it, and nothing beyond") {
  // Edges and extents that are no binary fractions.
  for (const double cell : {0.1, 0.01, 1.0 / 3, 0.7}) {
    for (const double lower : {0.0, -0.3, 0.1, 1e3}) {
      const double upper = lower + 21 * cell;
      const CartesianGrid<2> grid({.lower = {lower, lower}, .upper = {upper, upper}, .cell = cell});
      REQUIRE(grid.cells(0) == 21);
      REQUIRE(grid.walk({lower, lower}) == 0);
      REQUIRE(grid.walk({upper, upper}) == grid.cell_count() - 1);
      REQUIRE(grid.walk({grid.upper(0), grid.upper(1)}) == grid.cell_count() - 1);
      REQUIRE(grid.walk({grid.upper(0), lower}) == 20);
      REQUIRE(grid.walk({upper + 1e-6 * cell, lower}) == none);
      REQUIRE(grid.walk({lower - 1e-6 * cell, lower}) == none);
    }
  }
  const CartesianGrid<3, float> single({.lower = {0, 0, 0}, .upper = {0.3, 0.3, 0.3}, .cell = 0.1});
  REQUIRE(single.walk({single.upper(0), single.upper(1), single.upper(2)}) == 26);
}

TEST_CASE("a position that is none has no cell") {
  const CartesianGrid<2> grid({.lower = {0, 0}, .upper = {1, 1}, .cell = 0.25});
  const double nan = std::numeric_limits<double>::quiet_NaN(), inf = std::numeric_limits<double>::infinity();
  REQUIRE(grid.walk({nan, 0.5}) == none);
  REQUIRE(grid.search({0.5, nan}) == none);
  REQUIRE(grid.walk({inf, 0.5}) == none);
  REQUIRE(grid.walk({0.5, -inf}) == none);
  REQUIRE(grid.walk({1e30, 0.5}) == none);
}

TEST_CASE("cells whose volume is not a number in the scalar are refused") {
  const auto make = [](auto scalar, double size) {
    CartesianGrid<3, decltype(scalar)>({.lower = {0, 0, 0}, .upper = {size, size, size}, .cell = size});
  };
  const std::string rule = "m in the scalar of the mesh, or the cell's volume or size is not a number";
  for (const double size : {1e-30, 1e-13, 1e13, 1e30, 1e300}) {
    REQUIRE(throws([&] { make(0.0f, size); }, "CartesianGrid.cell = "));
    REQUIRE(throws([&] { make(0.0f, size); }, rule));
  }
  for (const double size : {1e-110, 1e110}) REQUIRE(throws([&] { make(0.0, size); }, rule));
  for (const double size : {1e-11, 1e-6, 1e3, 1e12}) REQUIRE_NOTHROW(make(0.0f, size));
  for (const double size : {1e-90, 1e90}) REQUIRE_NOTHROW(make(0.0, size));
}

TEST_CASE("bad grids are refused") {
  using Grid = CartesianGrid<2>;
  REQUIRE(throws([] { Grid g({}); }, "CartesianGrid.cell = nan: must be positive"));
  REQUIRE(throws(
      [] {
        Grid g({.lower = {0, 0}, .upper = {1, 1}});
      },
      "CartesianGrid.cell = nan: must be positive"));
  REQUIRE(throws(
      [] {
        Grid g({.lower = {0, 0}, .upper = {1, 1}, .cell = -0.1});
      },
      "CartesianGrid.cell = -0.1: must be positive"));
  REQUIRE(throws(
      [] {
        Grid g({.lower = {0, 0}, .upper = {1, 1}, .cell = 0.3});
      },
      "CartesianGrid.cell = 0.3: must divide the extent 1 along axis 0"));
  REQUIRE(throws([] { Grid g({.lower = {0, 0}, .upper = {1, 1}, .cell = 3}); }, "must divide the extent"));
  REQUIRE(throws(
      [] {
        Grid g({.lower = {0, 0}, .upper = {1, 0}, .cell = 0.1});
      },
      "CartesianGrid.upper[1] = 0: must be finite and exceed lower = 0"));
  REQUIRE(throws([] { Grid g({.upper = {1, 1}, .cell = 0.1}); }, "must be finite and exceed lower = nan"));
  REQUIRE(throws(
      [] {
        Grid g({.lower = {0, 0}, .upper = {1e5, 1e5}, .cell = 1});
      },
      "gives more than 2^31 cells"));
}
