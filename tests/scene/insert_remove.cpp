// Points inserted and removed between steps: what they carry is accounted for, and lists of cells are right.
#include <arenite/arenite.hpp>
#include <numeric>
#include <set>

#include "catch.hpp"
#include "meshes.hpp"
#include "state_buffer.hpp"

using namespace arenite;
using test::StateBuffer;

namespace {

LinearElastic rubber() { return LinearElastic{{.density = 1000, .young = 1e6, .poisson = 0.3}}; }
CartesianGrid<2> grid() { return CartesianGrid<2>{{.lower = {0, 0}, .upper = {2, 1}, .cell = 0.05}}; }
SimplexMesh<2> triangles() { return SimplexMesh<2>(test::triangles({0, 0}, {1, 1}, 16, 16)); }
using Apic2 = Numerics<QuadraticBSpline, Apic>;
const Box left_block{{0.2, 0.2}, {0.6, 0.6}};
const FillOptions flies{.per_cell = 4, .velocity = {3, 1, 0}};

/// Whether each point is listed once, in its cell.
template <class Scene, class Body>
bool lists_are_right(const Scene& scene, const Body& body) {
  std::vector<int> listed(body.points.size(), 0);
  bool right = true;
  for (Index c = 0; c < scene.mesh.cell_count(); ++c)
    for (const Index p : body.cells[c]) {
      right = right && p < listed.size() && body.points.cell[p] == c;
      if (!right) return false;
      ++listed[p];
    }
  return right && std::ranges::all_of(listed, [](int n) { return n == 1; });
}

}  // namespace

TEST_CASE("A body that begins empty and gets the points of a filled one goes the same way, bit for bit") {
  const auto make = [](const FillOptions& options, auto region) {
    return Scene{
        PlaneStrain{},        grid(),     Apic2{},      bodies(fill<"block">(region, rubber(), options)),
        walls(right(roller)), PointIds{}, TrackEnergy{}};
  };
  auto filled = make(flies, left_block);
  auto empty = make({.may_be_empty = true}, Inside{[](const auto&) { return 1.0; }});
  CHECK(empty.body().points.size() == 0);
  step(empty, 1e-3);  // nothing to do
  empty.time = 0;
  empty.time_step = 0;
  empty.steps = 0;
  std::vector<decltype(filled.body().points)::Point> points;
  for (std::size_t p = 0; p < filled.body().points.size(); ++p) {
    points.push_back(filled.body().points[p]);
    points.back().id = no_id;
    points.back().mass = std::numeric_limits<double>::quiet_NaN();
  }
  const auto brought = insert_points<"block">(empty, points);
  CHECK(brought.count == points.size());
  CHECK(brought.mass == Approx(mass(filled.body())).epsilon(1e-13));
  for (int k = 0; k < 60; ++k) {
    const double dt = 0.5 * stable_step(filled);
    REQUIRE(stable_step(empty) == 2 * dt);
    step(filled, dt);
    step(empty, dt);
  }
  StateBuffer a(filled), b(empty);
  for (const char* name : {"points/position/x", "points/velocity/y", "points/stress/xy",
                           "points/velocity_gradient/xx", "points/id", "points/cell", "cells/unsorted"}) {
    CAPTURE(name);
    CHECK(a.of(std::string("bodies/block/") + name) == b.of(std::string("bodies/block/") + name));
  }
  CHECK(energies(empty).residual == Approx(energies(filled).residual).margin(1e-11));
  CHECK(energies(empty).plastic == Approx(0).margin(1e-11));
}

TEST_CASE("Inserted and removed points leave the energy balance as it was, momentum and mass exact") {
  Scene scene{PlaneStrain{},
              triangles(),
              Numerics<LinearSimplex, Flip, Musl>{},
              bodies(fill<"sand">(Box{{0., 0.}, {1., 0.5}}, rubber(), {.per_cell = 3}),
                     fill<"other">(Box{{0., 0.5}, {1., 0.6}}, rubber(), {.per_cell = 3})),
              walls(on("bottom", fixed)),
              gravity({0, -9.81}),
              TrackEnergy{}};
  for (int k = 0; k < 50; ++k) step(scene, 0.5 * stable_step(scene));
  auto& sand = scene.body<"sand">();
  const auto before = energies(scene);
  const auto momentum_before = momentum(sand);
  const double mass_before = mass(sand), ratio_before = mean_volume_ratio(sand);
  decltype(sand.points[0]) point{.position = {0.51, 0.77}, .velocity = {2, -1}, .volume = 1e-3};
  point.stress = {{-2e4, -3e4, -1e4, 4e3}};
  const auto in = insert_points<"sand">(scene, {point, point});
  CHECK(lists_are_right(scene, sand));
  for (std::size_t p = 0; p < sand.points.size(); ++p)
    if (sand.points.mass[p] == 1)
      CHECK(scene.mesh.walk(sand.points.position[p], sand.points.cell[p]) == sand.points.cell[p]);
  CHECK(in.mass == 2.0);
  CHECK(in.kinetic_energy == 5.0);
  CHECK(in.strain_energy > 0.1);
  const auto after = energies(scene);
  CHECK(after.inserted == Approx(in.kinetic_energy + in.strain_energy).epsilon(1e-14));
  CHECK(after.kinetic == Approx(before.kinetic + 5).epsilon(1e-14));
  CHECK(after.plastic == Approx(before.plastic).margin(1e-12));
  CHECK(after.residual == Approx(before.residual).margin(1e-12));
  CHECK((momentum(sand) - momentum_before - in.momentum).norm() < 1e-12);
  CHECK(mean_volume_ratio(sand) ==
        Approx((ratio_before * (mass_before / 1000) + 2e-3) / (mass_before / 1000 + 2e-3)));

  const auto out = remove_points<"sand">(scene, [](const auto& p) { return p.position[0] > 0.5; });
  CHECK(lists_are_right(scene, sand));
  CHECK(out.count > 100);
  CHECK(std::ranges::none_of(sand.points.position, [](const auto& x) { return x[0] > 0.5; }));
  CHECK(energies(scene).residual == Approx(before.residual).margin(1e-12));
  CHECK(energies(scene).plastic == Approx(before.plastic).margin(1e-12));
  CHECK(mass(sand) == Approx(mass_before + in.mass - out.mass).epsilon(1e-13));
  CHECK((momentum(sand) + out.momentum - momentum_before - in.momentum).norm() < 1e-12);
  const double volume = std::accumulate(sand.points.volume.begin(), sand.points.volume.end(), 0.0);
  CHECK(mean_volume_ratio(sand) == Approx(volume / (mass(sand) / 1000)).epsilon(1e-13));
  for (int k = 0; k < 50; ++k) step(scene, 0.5 * stable_step(scene));
  CHECK(lists_are_right(scene, sand));
  CHECK(sand.lost == 0);
  remove_points<"sand">(scene, [](const auto&) { return true; });
  CHECK(sand.points.size() == 0);
  step(scene, 0.5 * stable_step(scene));
}

TEST_CASE("Bad points are refused by name, and the scene stays as it was") {
  Scene scene{PlaneStrain{},
              triangles(),
              Numerics<LinearSimplex, Flip, Musl>{},
              bodies(fill<"sand">(Box{{0., 0.}, {1., 0.5}}, rubber(), {.per_cell = 3})),
              walls(on("bottom", fixed)),
              PointIds{}};
  for (int k = 0; k < 5; ++k) step(scene, 0.5 * stable_step(scene));
  using Point = decltype(scene.body().points)::Point;
  const StateBuffer before(scene);
  const Point good{.position = {0.5, 0.7}, .volume = 1e-3};
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const auto refused = [&](auto&& spoil, const char* name) {
    Point bad = good;
    spoil(bad);
    CHECK_THROWS_WITH(insert_points(scene, {good, bad}),
                      Catch::Matchers::StartsWith("point 1 to be added: " + std::string(name)));
    CHECK(StateBuffer::first_difference(StateBuffer(scene), before) == "");
  };
  refused([](Point& p) { p.position = {0.5, 1.2}; }, "position = (0.5, 1.2): must lie in the mesh");
  refused([&](Point& p) { p.position[1] = nan; }, "position");
  refused([&](Point& p) { p.velocity[0] = nan; }, "velocity");
  refused([&](Point& p) { p.volume = nan; }, "volume");
  refused([](Point& p) { p.volume = -1; }, "volume");
  refused([](Point& p) { p.mass = 0; }, "mass");
  refused([&](Point& p) { p.stress[2] = nan; }, "stress");
  step(scene, 0.5 * stable_step(scene));
}

TEST_CASE("Ids stay with their points as these change places, and are stored only where asked for") {
  const auto run_with = [](auto... part) {
    Scene scene{PlaneStrain{}, grid(), Apic2{},
                bodies(fill(left_block, rubber(), flies), fill(Box{{1., 0.2}, {1.4, 0.6}}, rubber())),
                part...};
    scene.for_each_body([](auto& body, auto&) {
      for (std::size_t p = 0; p < body.points.id.size(); ++p)
        body.points.mass[p] = 0.1 * (1 + 1e-5 * static_cast<double>(body.points.id[p]));
    });
    for (int k = 0; k < 200; ++k) step(scene, 0.5 * stable_step(scene));
    return scene;
  };
  auto scene = run_with(PointIds{.first = std::uint64_t{1} << 40});
  std::set<std::uint64_t> ids;
  bool kept = true, moved = false;
  scene.for_each_body([&](auto& body, auto&) {
    std::uint64_t last = 0;
    for (std::size_t p = 0; p < body.points.size(); ++p) {
      const auto id = body.points.id[p];
      ids.insert(id);
      kept = kept && body.points.mass[p] == 0.1 * (1 + 1e-5 * static_cast<double>(id));
      moved = moved || id < last;
      last = id;
    }
  });
  CHECK(kept);
  CHECK(moved);
  const std::size_t count = scene.point_count();
  CHECK(ids.size() == count);
  CHECK(*ids.begin() == std::uint64_t{1} << 40);
  CHECK(*ids.rbegin() == (std::uint64_t{1} << 40) + count - 1);
  insert_points<0>(scene, {{.position = {0.1, 0.9}, .volume = 1e-3}});
  CHECK(std::ranges::count(scene.body<0>().points.id, (std::uint64_t{1} << 40) + count) == 1);
  const auto without = run_with();
  CHECK(without.body<0>().points.id.capacity() == 0);
  CHECK(without.body<0>().points.bytes_per_point() + 8 == scene.body<0>().points.bytes_per_point());
}

TEST_CASE("A state with points inserted and removed is restored in a scene made again") {
  const auto make = [] {
    return Scene{
        PlaneStrain{},
        triangles(),
        Numerics<LinearSimplex, Flip, Musl, NodalAndElementAverage>{},
        bodies(fill<"sand">(Box{{0., 0.}, {1., 0.5}}, rubber(), {.per_cell = 3, .velocity = {1, 0, 0}})),
        walls(on("bottom", fixed), on("right", fixed)),
        PointIds{},
        TrackEnergy{}};
  };
  auto whole = make(), restored = make();
  for (int k = 0; k < 20; ++k) step(whole, 0.5 * stable_step(whole));
  insert_points(whole, {{.position = {0.5, 0.7}, .volume = 1e-3}, {.position = {0.51, 0.7}, .volume = 1e-3}});
  remove_points(whole, [](const auto& p) { return p.position[0] < 0.3; });
  insert_points(whole, {{.position = {0.5, 0.8}, .volume = 1e-3}});
  StateBuffer(whole).restore(restored);
  CHECK(lists_are_right(restored, restored.body()));
  for (int k = 0; k < 20; ++k) {
    step(whole, 0.5 * stable_step(whole));
    step(restored, 0.5 * stable_step(restored));
  }
  CHECK(StateBuffer::first_difference(StateBuffer(whole), StateBuffer(restored)) == "");
}

TEST_CASE("Watch takes no points that join for a gain of energy") {
  const auto run_with = [](auto... part) {
    Scene scene{
        PlaneStrain{},        grid(), Apic2{}, bodies(fill(left_block, rubber(), flies)), gravity({0, -1}),
        walls(bottom(fixed)), part...};
    run(
        scene, {.end = 0.02},
        [&, given = false](const auto& s) mutable {
          if (s.steps < 6 || given) return;
          given = true;
          insert_points(scene, {{.position = {0.1, 0.9}, .velocity = {30, 0}, .volume = 0.2}});
        },
        Watch({.every = 1}));
    CHECK(scene.body().inserted.count == 1);
  };
  run_with();
  run_with(TrackEnergy{});
}
