// Nodes near a box: none is missed, hardly any other is named, wherever the box goes.
#include <arenite/shape/nodes_near.hpp>

#include "../mesh/sample_meshes.hpp"
#include "catch.hpp"

using namespace arenite;
using namespace arenite::test;

namespace {

/// Sends boxes of sides up to `size` about and beyond a mesh [0, 1]^D; returns the largest share of the nodes
/// that was named.
template <class Shape, class M>
double largest_share(const M& mesh, double size) {
  using T = typename M::scalar;
  constexpr int D = M::dimension;
  std::mt19937 random(4);
  std::uniform_real_distribution<double> uniform(0, 1);
  NodesNear<T, D> near;
  Box<std::size_t{D}> box{};
  auto& [lower, upper] = box;
  double share = 0;
  for (int n = 0; n < 300; ++n) {
    for (std::size_t k = 0; k < D; ++k) {
      // Now and then far away, mostly a little further.
      lower[k] = n % 30 == 0 ? 1.4 * uniform(random) - 0.2 : lower[k] + 0.02 * (uniform(random) - 0.4);
      upper[k] = lower[k] + (n % 7 == 0 ? 0.5 : 1) * size;
    }
    const double reach = n % 2 == 0 ? 0 : 0.5;
    near.template find<Shape>(mesh, box, reach);
    std::set<Index> named;
    for (std::size_t k = 0; k < near.size(); ++k) {
      if (k > 0) REQUIRE(near[k - 1] < near[k]);
      named.insert(near[k]);
    }
    const Index nodes = Shape::node_count(mesh);
    for (Index i = 0; i < nodes; ++i) {
      const auto x = Shape::node_position(mesh, i);
      const double far = reach * static_cast<double>(mesh.node_size(i));
      bool inside = true;
      for (std::size_t k = 0; k < D; ++k) {
        const auto at = static_cast<double>(x[static_cast<int>(k)]);
        inside = inside && at >= lower[k] - far && at <= upper[k] + far;
      }
      if (inside) REQUIRE(named.contains(i));
    }
    share = std::max(share, static_cast<double>(near.size()) / nodes);
  }
  const double infinite = std::numeric_limits<double>::infinity();
  lower.fill(-infinite);
  upper.fill(infinite);
  near.template find<Shape>(mesh, box, 0.5);
  REQUIRE(near.size() == Shape::node_count(mesh));
  lower.fill(2);
  upper.fill(3);
  near.template find<Shape>(mesh, box, 0.5);
  REQUIRE(near.size() == 0);
  return share;
}

template <int D>
SimplexMesh<D> simplices(int n) {
  SampleMesh<D> o{};
  o.cells.fill(n);
  return SimplexMesh<D>(sample_data(o));
}

}  // namespace

TEST_CASE("Nodes near a box: none is missed, most others are left out") {
  const CartesianGrid<2> plane({.lower = {0, 0}, .upper = {1, 1}, .cell = 0.02});
  CHECK(largest_share<LinearGrid>(plane, 0.2) < 0.15);
  CHECK(largest_share<QuadraticBSpline>(plane, 0.2) < 0.15);
  CHECK(largest_share<CubicBSpline>(plane, 0.2) < 0.15);
  const CartesianGrid<3, float> space({.lower = {0, 0, 0}, .upper = {1, 1, 1}, .cell = 0.05});
  CHECK(largest_share<QuadraticBSpline>(space, 0.2) < 0.15);
  CHECK(largest_share<LinearSimplex>(simplices<2>(40), 0.2) < 0.15);
  CHECK(largest_share<LinearSimplex>(simplices<3>(12), 0.2) < 0.35);
}

TEST_CASE("Nodes near a box: a mesh that moves is followed") {
  auto mesh = simplices<2>(20);
  NodesNear<double, 2> near;
  const auto found = [&] {
    near.find<LinearSimplex>(mesh, Box<2>{{0.4, 0.4}, {0.6, 0.6}}, 0);
    return near.size();
  };
  const auto few = found();
  CHECK(few < mesh.node_count() / 4);
  std::vector<Index> nodes(mesh.node_count()), cells(mesh.cell_count());
  std::iota(nodes.begin(), nodes.end(), Index{0});
  std::iota(cells.begin(), cells.end(), Index{0});
  mesh.move(nodes, cells, [&](Index i) { return Vec<double, 2>(2 * mesh.position(i)); });
  CHECK(found() == mesh.node_count());  // in motion: all
  CHECK(found() < few);                 // at rest again
}
