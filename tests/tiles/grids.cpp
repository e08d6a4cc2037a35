// Grids cut into windows: functions, nodes and cells with the bits of the whole, and scenes over tiles that go the way of the whole.
#include <arenite/arenite.hpp>
#include <arenite/tiles.hpp>

#include <map>

#include "catch.hpp"
#include "message.hpp"

using namespace arenite;

namespace {

/// All windows of a grid say what the whole says of what they have.
template <class Shape, class Grid>
void check_windows(const Grid& whole, int tiles) {
  constexpr int D = Grid::dimension;
  const auto boxes = split_cells(whole, tiles);
  std::vector<int> owned(whole.cell_count());
  for (int t = 0; t < tiles; ++t) {
    const auto [window, portion] = split_grid<Shape>(whole, boxes, t);
    for (Index i = 0; i < Shape::node_count(window); ++i)
      REQUIRE(Shape::node_position(window, i) ==
              Shape::node_position(whole, static_cast<Index>(portion.whole_node[i])));
    for (Index c = 0; c < window.cell_count(); ++c) {
      const Index w = window.whole_cell(c);
      REQUIRE(w == portion.whole_cell[c]);
      REQUIRE(window.cell_here(w) == c);
      if (portion.owns_cell(c)) ++owned[w];
      REQUIRE(window.corner(c) == whole.corner(w));
      REQUIRE(window.extent(c) == whole.extent(w));
      REQUIRE(window.size(c) == whole.size(w));
      const typename Shape::template Cell<WindowGrid<Grid>> here(window, c);
      const typename Shape::template Cell<Grid> there(whole, w);
      for (int k = 0; k < here.size; ++k) {
        const auto node = here.nodes[static_cast<std::size_t>(k)];
        REQUIRE(portion.whole_node[node] == there.nodes[static_cast<std::size_t>(k)]);
      }
      for (const double s : {0.0, 0.3, 0.99}) {
        const Vec<double, D> x = whole.corner(w) + s * whole.extent(w);
        REQUIRE(here.weights(x) == there.weights(x));
        REQUIRE(here.gradients(x) == there.gradients(x));
        REQUIRE(window.walk(x) == window.cell_here(whole.walk(x)));
        std::array<double, static_cast<std::size_t>(D)> place;
        for (int k = 0; k < D; ++k) place[static_cast<std::size_t>(k)] = x[k];
        REQUIRE(window.holder(c).holds(place) == whole.holder(w).holds(place));
      }
    }
  }
  CHECK(std::ranges::count(owned, 1) == static_cast<std::ptrdiff_t>(owned.size()));
}

/// Numbers of all points by id.
using Numbers = std::map<std::uint64_t, std::vector<double>>;
template <class S>
void collect(const S& scene, Numbers& all) {
  scene.for_each_body([&](const auto& body, const auto&) {
    for (std::size_t p = 0; p < body.points.size(); ++p)
      body.points.for_each_column([&](const auto& column) {
        if constexpr (std::same_as<std::remove_cvref_t<decltype(column[0])>, double>)
          all[body.points.id[p]].push_back(column[p]);
      });
  });
}
/// Gives points of one place one id.
template <class S>
void number(S& scene, std::map<std::vector<double>, std::uint64_t>& ids) {
  std::size_t b = 0;
  scene.for_each_body([&](auto& body, auto&) {
    for (std::size_t p = 0; p < body.points.size(); ++p) {
      std::vector<double> place{static_cast<double>(b)};
      for (int k = 0; k < S::D; ++k) place.push_back(body.points.position[p][k]);
      body.points.id[p] = ids.try_emplace(place, ids.size()).first->second;
    }
    ++b;
  });
}

/// Checks that tiles agree with the whole after `steps`: within `near` of each number's scale.
template <class Grid, class Make>
void check(const Grid& grid, int tiles, int steps, Make&& make, double near = 1e-11) {
  CAPTURE(tiles);
  const int before = threads();
  set_threads(1);
  OneRank here;
  auto whole = make(Grid(grid));
  auto tiled = distribute(here, grid, {.tiles = tiles}, make);
  std::map<std::vector<double>, std::uint64_t> ids;
  number(whole, ids);
  const std::size_t points = ids.size();
  tiled.for_each_tile([&](auto& scene) { number(scene, ids); });
  REQUIRE(ids.size() == points);
  std::vector<double> dt;
  for (int k = 0; k < steps; ++k) {
    dt.push_back(0.4 * stable_step(whole));
    step(whole, dt.back());
  }
  tiled.together([&](auto& scene) {
    for (const double of_step : dt) {
      CHECK(0.4 * scene.communicator().least(stable_step(scene)) == Approx(of_step).epsilon(1e-11));
      step(scene, of_step);
    }
  });
  CHECK((tiled.shared().migrated_bytes() > 0) == (tiles > 1));
  Numbers expected, found;
  collect(whole, expected);
  tiled.for_each_tile([&](const auto& scene) { collect(scene, found); });
  REQUIRE(found.size() == expected.size());
  std::vector<double> scale, worst;
  for (const auto& [id, numbers] : expected) {
    scale.resize(numbers.size());
    worst.resize(numbers.size());
    REQUIRE(found.at(id).size() == numbers.size());
    for (std::size_t k = 0; k < numbers.size(); ++k) {
      scale[k] = std::max(scale[k], std::abs(numbers[k]));
      worst[k] = std::max(worst[k], std::abs(numbers[k] - found.at(id)[k]));
    }
  }
  for (std::size_t k = 0; k < worst.size(); ++k) {
    CAPTURE(k, worst[k], scale[k]);
    CHECK(worst[k] <= near * scale[k]);
  }
  if constexpr (tracks_energy<decltype(whole)>) {
    const auto e = energies(whole);
    tiled.together([&](auto& scene) {
      const auto f = energies(scene);
      if (!scene.communicator().first()) return;
      const double all = e.kinetic + e.strain;
      CHECK(std::abs(f.kinetic - e.kinetic) <= 1e-10 * all);
      CHECK(std::abs(f.strain - e.strain) <= 1e-10 * all);
      CHECK(std::abs(f.residual - e.residual) <= 1e-9 * all);
    });
  }
  set_threads(before);
}

}  // namespace

TEST_CASE("Windows of grids have the functions, nodes and cells of the whole, bit for bit") {
  const CartesianGrid<2> plane({.lower = {-0.3, 0.1}, .upper = {0.7, 0.8}, .cell = 0.1});
  const CartesianGrid<3> space({.lower = {0.1, -0.2, 0}, .upper = {0.9, 0.4, 0.6}, .cell = 0.2});
  const RectilinearGrid<2> lines(
      {.x = {-0.3, -0.25, -0.1, 0.15, 0.2, 0.3, 0.7, 0.72}, .y = {0.1, 0.3, 0.4, 0.6, 0.65}});
  const RectilinearGrid<3> boxes({.x = {0.1, 0.2, 0.4, 0.9}, .y = {-0.2, 0, 0.4}, .z = {0, 0.1, 0.15, 0.6}});
  for (const int tiles : {2, 4}) {
    check_windows<LinearGrid>(lines, tiles);
    check_windows<QuadraticBSpline>(lines, tiles);
    check_windows<CubicBSpline>(lines, tiles);
    check_windows<QuadraticBSpline>(boxes, tiles);
  }
  for (const int tiles : {1, 2, 4, 7}) {
    check_windows<LinearGrid>(plane, tiles);
    check_windows<QuadraticBSpline>(plane, tiles);
    check_windows<CubicBSpline>(plane, tiles);
    check_windows<UGimp<2>>(plane, tiles);
  }
  for (const int tiles : {2, 8}) {
    check_windows<QuadraticBSpline>(space, tiles);
    check_windows<CubicBSpline>(space, tiles);
  }
}

TEST_CASE("Tiles of a grid: B-splines, APIC, elastic block that flies across all cuts and hits a wall") {
  const CartesianGrid<2> grid({.lower = {0, 0}, .upper = {1, 1}, .cell = 0.05});
  for (const int tiles : {1, 2, 4})
    check(grid, tiles, 300, [](auto mesh, auto... portion) {
      return Scene{PlaneStrain{},
                   mesh,
                   Numerics<QuadraticBSpline, Apic, Usl>{},
                   bodies(fill(Box{{0.4, 0.35}, {0.75, 0.8}},
                               LinearElastic{{.density = 1000, .young = 1e6, .poisson = 0.3}},
                               {.per_cell = 4, .velocity = {8, -6, 0}})),
                   walls(bottom(fixed), right(roller)),
                   gravity({0, -9.81}),
                   TrackEnergy{},
                   PointIds{},
                   portion...};
    });
}

TEST_CASE(
    "Tiles of a grid: cubic splines, FLIP, MUSL, sand under its weight, a nodal average, a body pushed into "
    "it") {
  const CartesianGrid<2> grid({.lower = {0, 0}, .upper = {1, 1}, .cell = 0.1});
  for (const int tiles : {2, 3})
    check(
        grid, tiles, 100,
        [](auto mesh, auto... portion) {
          return Scene{
              PlaneStrain{},
              mesh,
              Numerics<CubicBSpline, Flip, Musl>{},
              bodies(fill<"sand">(
                  Box{{0., 0.}, {0.7, 0.6}},
                  MohrCoulomb{{.density = 1500, .young = 1e6, .poisson = 0.3, .friction = 35_deg}},
                  {.per_cell = 9, .velocity = {1.5, 0, 0}, .stress = Geostatic{.surface = 0.6, .k0 = 0.5}})),
              walls(bottom(fixed), left(roller), right(roller)),
              gravity({0, -9.81}),
              rigid(DistanceSurface{placed(Box{{-0.2, -0.1}, {0.2, 0.1}}, {.at = {0.48, 0.72}})},
                    Guided{.mass = 200, .velocity = -0.5}, Friction(20_deg)),
              TrackEnergy{},
              PointIds{},
              portion...};
        },
        1e-9);
}

TEST_CASE("Tiles of a grid in space: an elastic block slides, a ball lands on it") {
  const CartesianGrid<3> grid({.lower = {0, 0, 0}, .upper = {1, 1, 1}, .cell = 0.125});
  check(
      grid, 8, 100,
      [](auto mesh, auto... portion) {
        return Scene{ThreeDimensional{},
                     mesh,
                     Numerics<QuadraticBSpline, Apic, Usl>{},
                     bodies(fill(Box{{0., 0., 0.}, {0.75, 0.5, 0.75}},
                                 LinearElastic{{.density = 1000, .young = 1e6, .poisson = 0.3}},
                                 {.per_cell = 8, .velocity = {3, 0, 2}})),
                     walls(bottom(fixed), left(roller)),
                     gravity({0, -9.81, 0}),
                     rigid(DistanceSurface{Ball{{0.45, 0.7, 0.45}, 0.18}}, Guided{.mass = 50, .velocity = -2},
                           Friction(20_deg)),
                     TrackEnergy{},
                     PointIds{},
                     portion...};
      },
      1e-9);
}

TEST_CASE("Grids that cannot be cut are refused") {
  OneRank here;
  const CartesianGrid<2> grid({.lower = {0, 0}, .upper = {1, 1}, .cell = 0.5});
  CHECK(test::message<error>([&] { split_cells(grid, 5); }) ==
        "split_cells.tiles = 5: must be between 1 and the number of cells, 4");
  CHECK(test::message<error>([&] {
          split_cells(grid, 2, {1, -1, 1, 1});
        }) == "split_cells.weights = -1: must not be negative");
  const CartesianGrid<2> strip({.lower = {0, 0}, .upper = {1.5, 0.5}, .cell = 0.5});
  CHECK(split_cells(strip, 3).size() == 3);
}

TEST_CASE("Tiles of a grid between lines that move: a cone goes into sand, axisymmetric") {
  const RectilinearGrid<2> grid({.x = GrowingLines{.lower = 0, .upper = 0.3, .to = 0.1, .cell = 0.02},
                                 .y = GrowingLines{.lower = -0.3, .upper = 0.1, .from = -0.1, .cell = 0.02}});
  for (const int tiles : {2, 4})
    check(
        grid, tiles, 300,
        [](auto mesh, auto... portion) {
          return Scene{
              Axisymmetric{},
              mesh,
              Numerics<QuadraticBSpline, Flip, Usl>{Flip{.time = 0.01}},
              bodies(fill<"sand">(
                  Box{{0., -0.3}, {0.3, 0.}},
                  MohrCoulomb{{.density = 1500, .young = 1e6, .poisson = 0.3, .friction = 35_deg}},
                  {.per_cell = 4, .velocity = {2, 0, 0}, .stress = Geostatic{.surface = 0, .k0 = 0.5}})),
              walls(bottom(fixed), right(free_along(1))),
              gravity({0, -9.81}),
              rigids(rigid<"cone">(
                  DistanceSurface{ConeCylinder({.radius = 0.04, .apex = 60_deg, .length = 0.2})},
                  Guided{.mass = 2, .velocity = -4}, Friction(15_deg))),
              MovingMesh<LedByRigid<"cone">>{.leader = {}, .fixed_below = -0.3, .moving_from = -0.2},
              TrackEnergy{},
              PointIds{},
              portion...};
        },
        1e-9);
}
