// Probes of scenes cut into tiles: what the whole says, on cuts and beside them.
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
