// Queries of a scene cut into tiles: the same results as of the whole, on cuts and beside them.
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
void check_probes(const auto& cut, const Mesh& mesh, const Make& make) {
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

/// Calls `f` with what is cut, the mesh of the whole, and the scene over it.
template <class F>
void on_triangles_and_grid(F&& f) {
  SECTION("triangles") {
    const auto data = test::triangles({0, 0}, {1, 1}, 20, 20);
    f(data, SimplexMesh<2>(data), column(Numerics<LinearSimplex, Flip, Musl>{}));
  }
  SECTION("a grid, quadratic splines") {
    const CartesianGrid<2> grid({.lower = {0, 0}, .upper = {1, 1}, .cell = 0.05});
    f(grid, grid, column(Numerics<QuadraticBSpline, Apic, Usl>{}));
  }
}

}  // namespace

TEST_CASE("Probes of tiles") {
  on_triangles_and_grid([](const auto&... scene) { check_probes(scene...); });
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
  CHECK(expected[7] > 100);  // N: the bed supports the block
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

namespace {

/// Points that all tiles are given come into the scene once, on faces of cells and nodes, too.
template <class Mesh, class Make>
void check_insertion(const auto& cut, const Mesh& mesh, const Make& make) {
  OneRank here;
  auto whole = make(mesh);
  using Point = typename std::remove_cvref_t<decltype(whole.body())>::Point;
  std::vector<Point> points;
  for (int a = 0; a < 20; ++a)
    for (int b = 0; b < 6; ++b) {
      Point point;
      point.position = {0.025 + 0.05 * a, 0.7 + 0.025 * b};
      point.velocity = {a, 0};
      point.volume = 1e-4;
      points.push_back(point);
    }
  const auto put_in = [&](auto& scene) {
    auto totals = insert_points(scene, points);
    auto count = static_cast<double>(totals.count);
    sum_over(scene.communicator(), count, totals.mass, totals.kinetic_energy);
    return std::array{count, totals.mass, totals.kinetic_energy};
  };
  const auto expected = put_in(whole);
  CHECK(expected[0] == 120);
  run(whole, {.end = 0.01, .max_step = 2e-4});
  const double energy = kinetic_energy(whole.body());
  auto refused = distribute(here, cut, {.tiles = 3}, make);
  auto far = points;
  far.back().position[0] = 1.5;
  CHECK_THROWS_WITH(
      refused.together([&](auto& scene) { insert_points(scene, far); }),
      Catch::Matchers::Contains("point 119 to be added: position = (1.5, 0.825): must lie in the mesh"));
  for (const int tiles : {1, 3, 5}) {
    CAPTURE(tiles);
    auto tiled = distribute(here, cut, {.tiles = tiles}, make);
    const auto found = tiled.of_all(put_in);
    for (std::size_t k = 0; k < found.size(); ++k) CHECK(found[k] == Approx(expected[k]).epsilon(1e-12));
    run(tiled, {.end = 0.01, .max_step = 2e-4});
    CHECK(tiled.sum([](const auto& scene) { return kinetic_energy(scene.body()); }) ==
          Approx(energy).epsilon(1e-9));
    CHECK(tiled.sum([](const auto& scene) { return scene.point_count(); }) ==
          static_cast<double>(whole.point_count()));
  }
}

}  // namespace

TEST_CASE("Points that all tiles are given") {
  on_triangles_and_grid([](const auto&... scene) { check_insertion(scene...); });
}
