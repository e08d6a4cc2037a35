// Linear shape functions on triangles and tetrahedra.
#include "catch.hpp"
#include "shapes.hpp"

using namespace arenite;
using namespace arenite::test;

TEST_CASE("linear simplex: unity, linear fields and gradients") {
  for (const int n : {1, 2, 5}) {
    const auto flat = violations<LinearSimplex>(sample_mesh<2>(n));
    REQUIRE(flat.worst() < 1e-14);
    REQUIRE(flat.difference < 1e-10);
    const auto solid = violations<LinearSimplex>(sample_mesh<3>(n));
    REQUIRE(solid.worst() < 1e-14);
    REQUIRE(solid.difference < 1e-10);
    const auto single = violations<LinearSimplex>(sample_mesh<3, float>(n));
    REQUIRE(single.worst() < 5e-6);
    REQUIRE(single.difference < 1e-3);
  }
}

TEST_CASE("linear simplex: one at its own node, none at the others") {
  const auto mesh = sample_mesh<3>(2);
  double off = 0;
  for (Index c = 0; c < mesh.cell_count(); ++c) {
    const LinearSimplex::Cell<SimplexMesh<3>> cell(mesh, c);
    for (int k = 0; k < 4; ++k) {
      const auto w = cell.weights(mesh.position(cell.nodes[static_cast<std::size_t>(k)]));
      off = std::max(off, (w - decltype(w)::Unit(k)).norm());
    }
  }
  REQUIRE(off < 1e-14);
}

TEST_CASE("linear simplex: a hand value") {
  const SimplexMesh<2> mesh({{{0, 0}, {2, 0}, {0, 4}}, {{{0, 1, 2}}}, {}, {}, {}});
  const LinearSimplex::Cell<SimplexMesh<2>> cell(mesh, 0);
  REQUIRE((cell.weights({0.5, 1}) - Eigen::Vector3d(0.5, 0.25, 0.25)).norm() < 1e-16);
  REQUIRE(
      (cell.gradients({0.5, 1}) - (Eigen::Matrix<double, 2, 3>() << -0.5, 0.5, 0, -0.25, 0, 0.25).finished())
          .norm() < 1e-16);
}

static_assert(shape_function<LinearSimplex, SimplexMesh<2>> &&
              shape_function<LinearSimplex, SimplexMesh<3, float>>);
static_assert(!shape_function<LinearSimplex, CartesianGrid<2>>);
