// Boxes of triangles and tetrahedra: they fill the box, fit together, and their faces have names.
#include <arenite/mesh/box_mesh.hpp>
#include <arenite/mesh/simplex_mesh.hpp>
#include "catch.hpp"
#include "sample_meshes.hpp"

namespace {

using namespace arenite;

/// Volume, number of cells and of faces on the hull against those of the box.
template <int D>
void check(const BoxMesh<D>& box, std::size_t cells, std::size_t hull, double volume) {
  const auto data = box_mesh(box);
  REQUIRE(data.cells.size() == cells);
  REQUIRE(data.region == std::vector<int>(cells, data.region_names.at("all")));
  const SimplexMesh<D> mesh(data);
  double sum = 0;
  std::size_t faces = 0;
  for (Index c = 0; c < mesh.cell_count(); ++c) {
    sum += mesh.volume(c);
    for (int k = 0; k <= D; ++k) faces += mesh.neighbour(c, k) == none;
  }
  REQUIRE(std::abs(sum / volume - 1) < 1e-14);
  REQUIRE(faces == hull);
  const std::array<const char*, 6> names{"left", "right", "bottom", "top", "front", "back"};
  REQUIRE(data.node_sets.size() == 2 * D);
  for (std::size_t k = 0; k < 2 * D; ++k) {
    const int axis = static_cast<int>(k / 2);
    const auto& set = data.node_sets.at(names[k]);
    std::size_t others = 1;
    for (std::size_t a = 0; a < D; ++a)
      if (a != k / 2) others *= box.bricks[a] + 1;
    REQUIRE(set.size() == others);
    REQUIRE(std::is_sorted(set.begin(), set.end()));
    for (const Index i : set) REQUIRE(data.nodes[i][axis] == (k % 2 == 0 ? box.lower : box.upper)[k / 2]);
  }
}

}  // namespace

TEST_CASE("A box of triangles, a box of tetrahedra") {
  check<2>({{-1, 2}, {2, 2.5}, {5, 3}}, 30, 16, 1.5);
  check<2>({{0, 0}, {1e-3, 1e-3}, {1, 1}}, 2, 4, 1e-6);
  check<3>({{0, -1, 2}, {1, 1, 2.5}, {2, 3, 4}}, 6 * 24, 2 * 2 * (6 + 8 + 12), 1);
}

TEST_CASE("Boxes that are none are refused") {
  REQUIRE(arenite::test::throws(
      [] {
        box_mesh<2>({{0, 0}, {1, 1}, {1, 0}});
      },
      "BoxMesh.bricks = 0: must be at least 1"));
  REQUIRE(arenite::test::throws(
      [] {
        box_mesh<2>({{0, 1}, {1, 1}, {1, 1}});
      },
      "BoxMesh.upper = 1: must lie above lower = 1"));
  REQUIRE(arenite::test::throws(
      [] {
        arenite::box_mesh<2>({{0, 0}, {1, 1}, {70000, 70000}});
      },
      "nodes: must be fewer than 2^32"));
}
