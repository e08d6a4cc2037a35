// Linear functions on a grid.
#include "grids.hpp"

using namespace arenite;
using namespace arenite::test;

TEMPLATE_TEST_CASE("linear functions on a grid: unity, linear fields and gradients", "", double, float) {
  check_completeness<LinearGrid, TestType>();
}

TEST_CASE(
    "linear functions on a grid: on a face only its nodes have a value; values have no jumps, slopes have") {
  check_faces<LinearGrid>();
  CHECK(greatest_jump<LinearGrid>(false) < 1e-14);
  CHECK(greatest_jump<LinearGrid>(true) > 1);
}

TEST_CASE("linear functions on a grid: bilinear interpolation") {
  const auto g = grid<2>({3, 2}, 0.5);
  REQUIRE(LinearGrid::node_count(g) == 4 * 3);
  CHECK((LinearGrid::node_position(g, 6) - Vec<double, 2>(1, 0.5)).norm() == 0);
  const LinearGrid::Cell<CartesianGrid<2>> cell(g, 4);  // from (0.5, 0.5) to (1, 1)
  CHECK(cell.nodes == std::array<Index, 4>{5, 6, 9, 10});
  const auto w = cell.weights({0.6, 0.9});  // 0.2 and 0.8 of the cell
  CHECK((w - Vec<double, 4>(0.8 * 0.2, 0.2 * 0.2, 0.8 * 0.8, 0.2 * 0.8)).norm() < 1e-15);
}

TEST_CASE("nodes around a node: once for each cell that they share") {
  const auto g = grid<2>({3, 2}, 1);
  const auto around = [&](Index node) {
    std::vector<int> times(LinearGrid::node_count(g));
    LinearGrid::for_each_neighbour(g, node, [&](Index j) { ++times[j]; });
    return times;
  };
  CHECK(around(0) == std::vector<int>{0, 1, 0, 0, 1, 1, 0, 0, 0, 0, 0, 0});
  CHECK(around(5) == std::vector<int>{1, 2, 1, 0, 2, 0, 2, 0, 1, 2, 1, 0});
  CHECK(around(11) == std::vector<int>{0, 0, 0, 0, 0, 0, 1, 1, 0, 0, 1, 0});
}

static_assert(shape_function<LinearGrid, CartesianGrid<2>> &&
              shape_function<LinearGrid, CartesianGrid<3, float>>);
static_assert(!shape_function<LinearGrid, SimplexMesh<2>>);
