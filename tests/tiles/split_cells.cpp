// Cells cut into tiles that weigh the same, and tiles dealt out to ranks.
#include <arenite/arenite.hpp>
#include <arenite/tiles.hpp>

#include "catch.hpp"
#include "meshes.hpp"
#include "message.hpp"

using namespace arenite;

TEST_CASE("Tiles weigh the same, whatever their number, and lie in one piece each") {
  const auto mesh = test::triangles({0, 0}, {4, 1}, 40, 10);
  for (const int tiles : {1, 2, 3, 7, 16}) {
    CAPTURE(tiles);
    const auto tile = split_cells(mesh, tiles);
    std::vector<int> count(static_cast<std::size_t>(tiles));
    for (const int t : tile) ++count.at(static_cast<std::size_t>(t));
    const auto [least, most] = std::ranges::minmax(count);
    CHECK(most - least <= 2);
  }
  // The first cut goes across the longest side.
  const auto halves = split_cells(mesh, 2);
  for (std::size_t c = 0; c < mesh.cells.size(); ++c) {
    double x = 0;
    for (const Index i : mesh.cells[c]) x += mesh.nodes[i][0] / 3;
    if (std::abs(x - 2) > 0.1) CHECK(halves[c] == (x < 2 ? 0 : 1));
  }
}

TEST_CASE("Weights shift the cuts: of four tiles none weighs more than 1.1 times the mean") {
  const auto mesh = test::triangles({0, 0}, {1, 1}, 30, 30);
  std::vector<double> weights;
  for (const auto& cell : mesh.cells) weights.push_back(mesh.nodes[cell[0]][1] < 0.3 ? 3 : 0.01);
  const auto tile = split_cells(mesh, 4, weights);
  std::vector<double> sum(4);
  double all = 0;
  for (std::size_t c = 0; c < tile.size(); ++c) {
    sum[static_cast<std::size_t>(tile[c])] += weights[c];
    all += weights[c];
  }
  for (const double s : sum) CHECK(s <= 1.1 * all / 4);
}

TEST_CASE("Each tile has a cell at least, even where cells weigh nothing") {
  const auto mesh = test::triangles({0, 0}, {1, 1}, 2, 2);
  const auto tile = split_cells(mesh, 8, std::vector<double>(8, 0.0));
  CHECK(std::set<int>(tile.begin(), tile.end()).size() == 8);
}

TEST_CASE("A grid gives as many tiles as it has cells, wherever they weigh something") {
  const CartesianGrid<2> grid({.lower = {0, 0}, .upper = {0.2, 1.0}, .cell = 0.05});
  REQUIRE(grid.cell_count() == 80);
  std::vector<double> heavy(80, 0.0);
  heavy[0] = 1;
  for (const auto& weights : {std::vector<double>{}, heavy})
    for (const int tiles : {80, 79, 41}) {
      std::vector<int> of_cell(80);
      const auto boxes = split_cells(grid, tiles, weights);
      REQUIRE(boxes.size() == static_cast<std::size_t>(tiles));
      for (const auto& box : boxes) {
        CHECK(box.first[0] < box.end[0]);
        CHECK(box.first[1] < box.end[1]);
        for (Index y = box.first[1]; y < box.end[1]; ++y)
          for (Index x = box.first[0]; x < box.end[0]; ++x) ++of_cell[4 * y + x];
      }
      CHECK(of_cell == std::vector<int>(80, 1));
    }
}

TEST_CASE("Meshes that cannot be cut are refused") {
  const auto mesh = test::triangles({0, 0}, {1, 1}, 2, 2);
  const auto said = [](auto&& f) { return test::message<error>(f); };
  CHECK(said([&] { split_cells(mesh, 9); }) ==
        "split_cells.tiles = 9: must be between 1 and the number of cells, 8");
  CHECK(said([&] { split_cells(mesh, 0); }) ==
        "split_cells.tiles = 0: must be between 1 and the number of cells, 8");
  CHECK(said([&] { split_cells(mesh, 2, {1, 2}); }) == "split_cells.weights = 2: must have one entry a cell");
  CHECK(said([&] { split_cells(mesh, 2, std::vector<double>(8, -1.0)); }) ==
        "split_cells.weights = -1: must not be negative");
  CHECK(said([&] { assign_tiles(2, 3); }) == "tiles = 2: must not be less than the number of ranks, 3");
  CHECK(assign_tiles(5, 2) == std::vector<int>{0, 0, 0, 1, 1});
}

TEST_CASE(
    "Tiles are dealt out again by weight: few move, none of the ranks is left without one, tile 0 stays") {
  CHECK(reassign_tiles({0, 0, 1, 1}, {1, 1, 1, 1}, 2, 1.05) == std::vector<int>{0, 0, 1, 1});
  CHECK(reassign_tiles({0, 0, 1, 1}, {3, 3, 1, 1}, 2, 1.05) == std::vector<int>{0, 1, 0, 1});
  CHECK(reassign_tiles({0, 1, 2}, {9, 1, 1}, 3, 1) == std::vector<int>{0, 1, 2});
  CHECK(reassign_tiles({0, 0, 1, 1}, {0, 0, 0, 0}, 2, 1) == std::vector<int>{0, 0, 1, 1});
  // Sand that has gathered on one side: 64 tiles of 8 ranks.
  std::vector<double> weight;
  for (int t = 0; t < 64; ++t) weight.push_back(1000 * std::exp(-t / 20.0));
  const auto before = assign_tiles(64, 8), after = reassign_tiles(before, weight, 8, 1.05);
  CHECK(imbalance(before, weight, 8) > 2);
  CHECK(imbalance(after, weight, 8) <= 1.08);
  CHECK(after[0] == 0);
}
