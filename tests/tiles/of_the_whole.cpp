// What is asked of a scene cut into tiles: what the whole says, on cuts and beside them.
#include <arenite/arenite.hpp>
#include <arenite/tiles.hpp>

#include <random>

#include "catch.hpp"
#include "meshes.hpp"

using namespace arenite;

namespace {

/// All tiles find at each place what the scene of the whole finds there, in a run that moves points across the
/// cuts.
template <class Mesh, class Make>
void check(const auto& cut, const Mesh& mesh, const Make& make) {
  OneRank here;
  auto whole = make(mesh);
  run(whole, {.end = 0.02, .max_step = 2e-4});
  std::mt19937 random(7);
  std::vector<std::array<double, 3>> places;
  for (int k = 0; k < 40; ++k)
    places.push_back({std::uniform_real_distribution(0.0, 1.1)(random),
                      std::uniform_real_distribution(0.0, 1.1)(random), 0});
  for (int a = 0; a <= 10; ++a)  // nodes, and faces of cells
    for (int b = 0; b <= 10; ++b) places.push_back({0.1 * a, 0.05 * b, 0});
  for (const int tiles : {1, 3, 5}) {
    auto tiled = distribute(here, cut, {.tiles = tiles}, make);
    run(tiled, {.end = 0.02, .max_step = 2e-4});
    std::size_t found = 0;
    for (const auto& place : places) {
      CAPTURE(tiles, place);
      const auto expected = probe(whole, place);
      const auto seen = tiled.of_all([&](const auto& tile) { return probe(tile, place); });
      REQUIRE(seen.has_value() == expected.has_value());
      if (!seen) continue;
      ++found;
      for (int k = 0; k < 2; ++k)
        CHECK(seen->velocity[k] == Approx(expected->velocity[k]).epsilon(1e-8).margin(1e-9));
      for (std::size_t s = 0; s < seen->stress.c.size(); ++s)
        CHECK(seen->stress[s] == Approx(expected->stress[s]).epsilon(1e-8).margin(1e-5));
    }
    CHECK(found > 60);
    CHECK(found < places.size());
  }
}

template <class Numerics>
auto column(const Numerics& numerics) {
  return [=](auto mesh, auto... portion) {
    return Scene{PlaneStrain{},
                 mesh,
                 numerics,
                 bodies(fill(Box{{0., 0.}, {0.4, 0.6}},
                             MohrCoulomb{{.density = 1500, .young = 1e6, .poisson = 0.3, .friction = 35_deg}},
                             {.per_cell = 4, .velocity = {3, 0, 0}})),
                 walls(bottom(fixed), left(roller), right(roller)),
                 gravity({0, -9.81}),
                 portion...};
  };
}

}  // namespace

TEST_CASE("Probes of tiles: triangles") {
  const auto data = test::triangles({0, 0}, {1, 1}, 20, 20);
  check(data, SimplexMesh<2>(data), column(Numerics<LinearSimplex, Flip, Musl>{}));
}

TEST_CASE("Probes of tiles: a grid, quadratic splines") {
  const CartesianGrid<2> grid({.lower = {0, 0}, .upper = {1, 1}, .cell = 0.05});
  check(grid, grid, column(Numerics<QuadraticBSpline, Apic, Usl>{}));
}

TEST_CASE("Forces through sections and between bodies that lie across the cuts") {
  OneRank here;
  const CartesianGrid<2> grid({.lower = {0, 0}, .upper = {1, 0.6}, .cell = 0.05});
  const auto make = [](auto mesh, auto... portion) {
    const LinearElastic rubber{{.density = 1000, .young = 1e6, .poisson = 0.3}};
    return Scene{
        PlaneStrain{},
        mesh,
        Numerics<QuadraticBSpline, Flip, Musl>{},
        bodies(fill<"bed">(Box{{0., 0.}, {1., 0.25}}, rubber, {.per_cell = 4}),
               fill<"block">(Box{{0.3, 0.25}, {0.7, 0.45}}, rubber, {.per_cell = 4, .velocity = {1, -2, 0}})),
        Coulomb{Friction(0.3)},
        walls(bottom(fixed), left(roller), right(roller)),
        gravity({0, -9.81}),
        portion...};
  };
  const auto forces = [](const auto& scene) {
    const Section level{.through = {0, 0.12, 0}, .normal = {0, 1, 0}, .thickness = 0.1};
    const auto cut = nodal_section_force<"bed">(scene, level);
    const auto of_points = section_force<"bed">(scene, level);
    const auto on_bed = contact_force<"bed">(scene), on_block = contact_force<"block">(scene);
    return std::vector{cut[0],    cut[1],    of_points[0], of_points[1],
                       on_bed[0], on_bed[1], on_block[0],  on_block[1]};
  };
  auto whole = make(grid);
  run(whole, {.end = 0.01, .max_step = 1e-4});
  const auto expected = forces(whole);
  CHECK(expected[7] > 100);  // N: the bed holds the block
  CHECK(expected[1] < -100);
  for (const int tiles : {1, 3, 5}) {
    auto tiled = distribute(here, grid, {.tiles = tiles}, make);
    run(tiled, {.end = 0.01, .max_step = 1e-4});
    const auto found = tiled.of_all(forces);
    for (std::size_t k = 0; k < found.size(); ++k) {
      CAPTURE(tiles, k);
      CHECK(found[k] == Approx(expected[k]).epsilon(1e-9).margin(1e-6));
    }
  }
}
