// Rectilinear grids: functions, search, and the same physics as on equal cells; grids that move.
#include <arenite/arenite.hpp>
#include <random>

#include "../shape/functions_at.hpp"
#include "catch.hpp"
#include "message.hpp"
#include "state_buffer.hpp"
#include "validation.hpp"

using namespace arenite;

namespace {

const LinearElastic soil{{.density = 2000, .young = 1e7, .poisson = 0.25}};
const double speed = std::sqrt(soil.wave_modulus() / soil.density());

std::vector<double> uneven(double lower, std::initializer_list<double> edges) {
  std::vector<double> lines{lower};
  for (const double edge : edges) lines.push_back(lines.back() + edge);
  return lines;
}

template <class Shape, class Grid>
void check_functions(const Grid& grid) {
  using T = typename Grid::scalar;
  constexpr int D = Grid::dimension;
  const T eps = 100 * std::numeric_limits<T>::epsilon();
  std::mt19937 random(1);
  std::uniform_real_distribution<double> any(0, 1);
  for (Index c = 0; c < grid.cell_count(); ++c) {
    const typename Shape::template Cell<Grid> cell(grid, c);
    for (int k = 0; k < 8; ++k) {
      Vec<T, D> x = grid.corner(c);
      for (int d = 0; d < D; ++d) x[d] += static_cast<T>(k < 2 ? k : any(random)) * grid.extent(c)[d];
      const test::FunctionsAt at(cell, x);
      CHECK(at.off_unity() <= eps);
      CHECK(at.off_linear() <= eps * grid.upper(0));
      CHECK(at.gradient_sum() <= eps / grid.size(c));
      CHECK(at.off_identity() <= 10 * eps * grid.upper(0) / grid.size(c));
      CHECK(at.least() >= -eps);
      CHECK(at.template off_nodes<Shape>(grid, cell) <= eps * grid.upper(0));
    }
  }
}

/// Largest sum of slope^2 / value in cells away from the faces, times the square of the size of the cell.
template <class Shape>
double steepest(const std::vector<double>& lines) {
  const RectilinearGrid<2> grid({lines, {0, 100, 200}});
  double most = 0;
  for (Index c = 3; c + 3 < grid.cells(0); ++c) {
    const typename Shape::template Cell<RectilinearGrid<2>> cell(grid, c);
    for (int k = 1; k < 200; ++k) {
      const std::array<double, 2> x{grid.corner(c)[0] + k / 200.0 * grid.extent(c)[0], 50};
      const auto w = cell.line_values(x)[0], slope = cell.line_slopes(x)[0];
      double sum = 0;
      for (std::size_t i = 0; i < w.size(); ++i)
        if (w[i] > 0) sum += square(slope[i]) / w[i];
      most = std::max(most, sum * square(grid.size(c)));
    }
  }
  return most;
}

template <class Grid>
void check_search(const Grid& grid) {
  using T = typename Grid::scalar;
  std::mt19937 random(2);
  std::uniform_real_distribution<double> any(-0.1, 1.1);
  for (int n = 0; n < 4000; ++n) {
    typename Grid::Point x;
    std::array<T, 2> place;
    bool inside = true;
    for (int k = 0; k < 2; ++k) {
      x[k] = grid.lower()[k] + static_cast<T>(any(random)) * (grid.upper(k) - grid.lower()[k]);
      if (n % 4 == 0) x[k] = grid.line(k, static_cast<Index>(n) % (grid.cells(k) + 1));  // on a line
      place[static_cast<std::size_t>(k)] = x[k];
      inside = inside && x[k] >= grid.lower()[k] && x[k] <= grid.upper(k);
    }
    const Index cell = grid.search(x), hint = static_cast<Index>(n) % grid.cell_count();
    CHECK((cell != none) == inside);
    CHECK(grid.walk(x, hint) == cell);
    if (cell != none) CHECK(grid.holder(cell).holds(place));
    if (hint != cell) CHECK(!grid.holder(hint).holds(place));
  }
}

}  // namespace

TEST_CASE(
    "Functions between lines at any distances: unity, linear fields, gradients, as stable as on equal "
    "cells") {
  const auto x = uneven(-1, {0.5, 0.2, 0.3, 1, 2, 1.5}), y = uneven(0, {1, 3, 0.7}),
             z = uneven(2, {0.4, 0.2});
  check_functions<LinearGrid>(RectilinearGrid<2>({x, y}));
  check_functions<QuadraticBSpline>(RectilinearGrid<2>({x, y}));
  check_functions<CubicBSpline>(RectilinearGrid<2>({x, y}));
  check_functions<QuadraticBSpline>(RectilinearGrid<3>({x, y, z}));
  check_functions<CubicBSpline>(RectilinearGrid<3>({z, y, x}));
  check_functions<QuadraticBSpline>(RectilinearGrid<2, float>({x, y}));
  const auto grows = uneven(0, {1, 1, 1, 1.5, 2.2, 3, 3, 1, 0.5, 0.5, 0.5, 2, 0.7, 0.7, 0.7, 0.7});
  CHECK(steepest<QuadraticBSpline>(grows) <= 1.0001 * QuadraticBSpline::steepness);
  CHECK(steepest<CubicBSpline>(grows) <= CubicBSpline::steepness);
}

TEST_CASE("Search between lines; lines that grow; refused ones") {
  check_search(RectilinearGrid<2>({uneven(-1, {0.5, 0.2, 0.3, 1, 2, 1.5}), uneven(0, {1, 3, 0.7})}));
  check_search(RectilinearGrid<2, float>({uneven(-1, {0.5, 0.2, 0.3, 1, 2, 1.5}), uneven(0, {1, 3, 0.7})}));
  const std::vector<double> lines =
      GrowingLines{.lower = -2, .upper = 4, .from = 0, .to = 1, .cell = 0.1, .growth = 1.3};
  CHECK(lines.front() == -2);
  CHECK(lines.back() == 4);
  for (std::size_t i = 2; i < lines.size(); ++i) {
    const double now = lines[i] - lines[i - 1], before = lines[i - 1] - lines[i - 2];
    CHECK(now / before <= 1.3 * 1.2);
    CHECK(before / now <= 1.3 * 1.2);
    if (lines[i - 1] >= 0 && lines[i] <= 1) CHECK(std::abs(now - 0.1) <= 1e-12);
  }
  CHECK(lines.size() < 35);
  CHECK(test::message<std::exception>([] {
          RectilinearGrid<2>{{.x = {0, 1}, .y = {0}}};
        }) == "RectilinearGrid.y = 1: must be at least two lines");
  CHECK(test::message<std::exception>([] {
          RectilinearGrid<2>{{.x = {0, 1, 0.5}, .y = {0, 1}}};
        }).find("RectilinearGrid.x[2]: distance = -0.5: must lie between") == 0);
  CHECK(test::message<std::exception>([] {
          const std::vector<double> l = GrowingLines{.lower = 0, .upper = 1, .cell = 0.1, .growth = 3};
        }) == "GrowingLines.growth = 3: must lie in [1, 2]");
}

namespace {

/// A column of 1 m under its weight between smooth walls, 2 x 2 points a cell, brought to rest.
template <class M, class N>
auto column(M mesh, N numerics) {
  const double width = static_cast<double>(mesh.upper(0));
  return Scene{PlaneStrain{},
               std::move(mesh),
               numerics,
               bodies(fill(Box{{0., 0.}, {width, 1.}}, soil, {.per_cell = 4})),
               walls(left(roller), right(roller), bottom(roller)),
               gravity({0, -10}),
               ViscousDamping{.rate = pi * speed / 2}};
}
/// Worst stress of a point above the bottom cell against rho g (H - y), over that at the bottom, and steps
/// taken.
std::pair<double, std::size_t> settle_column(auto scene) {
  run(scene, {.end = 20 / speed, .courant = 0.5});
  double worst = 0;
  const auto& points = scene.body().points;
  for (std::size_t p = 0; p < points.size(); ++p)
    worst =
        std::max(worst, std::abs(points.stress[p][1] / (10 * soil.density()) + 1 - points.position[p][1]));
  return {worst, scene.steps};
}

/// A bar, free at its ends, in its first mode, that drifts along y.
template <class M, class... Parts>
auto bar(M mesh, double drift, const Parts&... parts) {
  Scene scene{PlaneStrain{},
              std::move(mesh),
              Numerics<QuadraticBSpline, Flip, Usl>{},
              bodies(fill(Box{{0., 0.}, {0.1, 1.}}, soil, {.per_cell = 4})),
              walls(left(roller), right(roller)),
              parts...};
  auto& points = scene.body().points;
  for (std::size_t p = 0; p < points.size(); ++p)
    points.velocity.set(p, {0, drift + 1e-3 * std::cos(pi * points.position[p][1])});
  return scene;
}

}  // namespace

TEST_CASE("A column settles on equal, on growing and on moving cells alike", "[heavy]") {
  test::Validation validation("rectilinear");
  const auto note = [&](const char* name, const std::pair<double, std::size_t>& found) {
    validation.value(name, joined_text({"worst vertical stress; ", found.second, " steps"}),
                     "of the greatest", found.first, 0);
    return found;
  };
  const Numerics<QuadraticBSpline, Flip, Musl> numerics{};
  const auto equal =
      note("equal cells of 0.025 m",
           settle_column(
               column(CartesianGrid<2>{{.lower = {0, 0}, .upper = {0.05, 1}, .cell = 0.025}}, numerics)));
  std::vector<double> same;
  for (int k = 0; k <= 40; ++k) same.push_back(0.025 * k);
  const auto lines = note("lines at equal distances",
                          settle_column(column(RectilinearGrid<2>({{0, 0.025, 0.05}, same}), numerics)));
  const std::vector<double> grows =
      GrowingLines{.lower = 0, .upper = 1, .from = 0.5, .to = 1, .cell = 0.025, .growth = 1.2};
  const auto growing = note("cells that grow by 1.2 downwards",
                            settle_column(column(RectilinearGrid<2>({{0, 0.025, 0.05}, grows}), numerics)));
  CHECK(grows.size() < 31);
  CHECK(equal.first <= 0.02);
  CHECK(std::abs(lines.first - equal.first) <= 1e-6);
  CHECK(growing.first <= 0.03);
}

TEST_CASE("A grid moves with a body: what drifts is as what rests, and no point leaves its cell") {
  const std::vector<double> across{0, 0.1},
      along = GrowingLines{.lower = -0.6, .upper = 1.6, .from = 0, .to = 0.4, .cell = 0.05, .growth = 1.1};
  const RectilinearGrid<2> grid({across, along});
  const MovingMesh<LedByBody<0>> follows{.fixed_below = -20, .moving_from = -10};
  auto rests = bar(grid, 0, follows), drifts = bar(grid, 5, follows);
  const double dt = 0.1 * 0.05 / speed;
  for (int k = 0; k < 900; ++k) step(rests, dt), step(drifts, dt);  // two and a quarter periods
  const double travel = drifts.template part<MovingMesh>().travel(),
               own = rests.template part<MovingMesh>().travel();
  CHECK(std::abs(travel - own - 5 * drifts.time) <= 1e-11 * travel);
  CHECK(travel > 0.15);
  double worst = 0, most = 0;
  const auto &a = rests.body().points, &b = drifts.body().points;
  for (std::size_t p = 0; p < a.size(); ++p) {
    CHECK(a.cell[p] == b.cell[p]);
    worst = std::max(worst, std::abs(a.stress[p][1] - b.stress[p][1]));
    most = std::max(most, std::abs(a.stress[p][1]));
  }
  CHECK(most > 100);
  CHECK(worst <= 1e-6 * most);
  // Saved and restored: the lines go where they were.
  const test::StateBuffer saved(drifts);
  auto again = bar(grid, 5, follows);
  saved.restore(again);
  CHECK(std::ranges::equal(again.mesh.lines(1), drifts.mesh.lines(1)));
  for (int k = 0; k < 5; ++k) step(again, dt), step(drifts, dt);
  CHECK(test::StateBuffer::first_difference(test::StateBuffer(again), test::StateBuffer(drifts)) == "");
  // A part of the grid that is squeezed until nothing is left of it.
  auto stops = bar(grid, -100, MovingMesh<LedByBody<0>>{.fixed_below = -0.6, .moving_from = -0.2});
  CHECK(test::message<std::exception>([&] {
          run(stops, {.end = 1, .courant = 0.5});
        }).find("the compressing zone below -0.2 m is used up") != std::string::npos);
}

TEST_CASE("Rectilinear grids: the same bits on any number of threads") {
  const int before = threads();
  const auto state = [](int n) {
    set_threads(n);
    auto scene = bar(
        RectilinearGrid<2>({{0, 0.02, 0.05, 0.1},
                            GrowingLines{.lower = -0.6, .upper = 1.6, .from = 0, .to = 0.4, .cell = 0.05}}),
        20, MovingMesh<LedByBody<0>>{.fixed_below = 1.5, .moving_from = 1.55});
    for (int k = 0; k < 60; ++k) step(scene, 5e-5);
    return test::StateBuffer(scene);
  };
  const auto one = state(1);
  for (const int n : {2, 3}) CHECK(test::StateBuffer::first_difference(state(n), one) == "");
  set_threads(before);
}
