// Bins: each cell is found in the bin of each of its positions, ascending.
#include "catch.hpp"
#include "sample_meshes.hpp"

using namespace arenite;
using namespace arenite::test;

TEST_CASE("the bin of a position names every cell that contains it") {
  // Graded by a power: cells of very different sizes.
  SampleMesh<2> o{};
  o.cells = {12, 12};
  auto data = sample_data(o);
  for (auto& x : data.nodes) x = x.cwiseProduct(x).cwiseProduct(x);
  const SimplexMesh<2> mesh(data);
  std::vector<std::array<Index, 3>> cells;
  for (Index c = 0; c < mesh.cell_count(); ++c) cells.push_back(mesh.nodes(c));
  CellBins<2, double> bins;
  bins.build(mesh.positions(), cells);
  std::mt19937 random(1);
  int missing = 0;
  for (Index c = 0; c < mesh.cell_count(); ++c) {
    std::vector<Vec<double, 2>> places{random_point(mesh, c, random)};
    for (const Index i : mesh.nodes(c)) places.push_back(mesh.position(i));
    for (const auto& x : places) {
      const auto near = bins.at(x);
      missing += std::count(near.begin(), near.end(), c) != 1;
      missing += !std::is_sorted(near.begin(), near.end());
    }
  }
  REQUIRE(missing == 0);
}

TEST_CASE("a position outside gives the nearest bin, not a crash") {
  const auto mesh = sample_mesh<3>(3);
  std::vector<std::array<Index, 4>> cells;
  for (Index c = 0; c < mesh.cell_count(); ++c) cells.push_back(mesh.nodes(c));
  CellBins<3, double> bins;
  bins.build(mesh.positions(), cells);
  REQUIRE_FALSE(bins.at({-100, 0.5, 1e30}).empty());
  REQUIRE_FALSE(bins.at({1e300, -1e300, 0.5}).empty());
}
