// Periodic axes: functions round the axis, waves that run round the box, simple shear without ends.
#include <arenite/arenite.hpp>
#include <random>

#include "../shape/functions_at.hpp"
#include "catch.hpp"
#include "message.hpp"
#include "state_buffer.hpp"
#include "validation.hpp"

using namespace arenite;

namespace {

const LinearElastic steel{{.density = 1000, .young = 1e7, .poisson = 0.25}};
const double speed = std::sqrt(steel.wave_modulus() / steel.density());

template <class Shape, class Grid>
void check_functions(const Grid& grid) {
  using Cell = typename Shape::template Cell<Grid>;
  constexpr int D = Grid::dimension;
  std::mt19937 random(1);
  std::uniform_real_distribution<double> any(0, 1);
  double unity = 0, linear = 0, jump = 0;
  std::vector<int> cells_at(Shape::node_count(grid), 0);
  for (Index c = 0; c < grid.cell_count(); ++c) {
    const Cell cell(grid, c);
    for (const Index i : cell.nodes) ++cells_at.at(i);
    Vec<double, D> x = grid.corner(c);
    for (int k = 0; k < D; ++k) x[k] += any(random) * grid.edge();
    const test::FunctionsAt functions(cell, x);
    unity = std::max(unity, functions.off_unity());
    linear = std::max(linear, functions.off_linear());
    // The upper x face of a cell and the lower one of the next, round the axis: the same functions.
    Vec<double, D> above = x, below = x;
    above[0] = grid.corner(c)[0] + grid.edge();
    below[0] = above[0] < grid.upper(0) - 1e-9 ? above[0] : grid.lower()[0];
    Vec<double, D> inside = below;
    inside[0] += 1e-9;
    const Cell next(grid, grid.search(inside));
    std::vector<double> at(cells_at.size(), 0);
    const auto high = cell.weights(above), low = next.weights(below);
    for (std::size_t i = 0; i < cell.nodes.size(); ++i) {
      at[cell.nodes[i]] += high[static_cast<int>(i)];
      at[next.nodes[i]] -= low[static_cast<int>(i)];
    }
    for (const double a : at) jump = std::max(jump, std::abs(a));
    // As many neighbours, counted cell by cell, as in the middle of a grid.
    if (is_periodic<Grid>(0) && is_periodic<Grid>(1) && (D == 2 || is_periodic<Grid>(2))) {
      int neighbours = 0;
      Shape::for_each_neighbour(grid, cell.nodes[0], [&](Index) { ++neighbours; });
      const int per_cell = static_cast<int>(cell.nodes.size());
      CHECK(neighbours == per_cell * (per_cell - 1));
    }
  }
  CHECK(unity <= 1e-14);
  CHECK(linear <= 1e-14);
  CHECK(jump <= 1e-13);
}

/// A period of 1 m, four cells high, closed along both axes; one smooth swing of a pressure wave begins at a
/// place along it.
template <class N>
auto ring(N numerics, Index cells, double from, bool pulse = true, double drift = 0) {
  const double h = 1.0 / cells;
  Scene scene{PlaneStrain{},
              periodic<0, 1>(CartesianGrid<2>{{.lower = {0, 0}, .upper = {1, 4 * h}, .cell = h}}), numerics,
              bodies(fill(Box{{0., 0.}, {1., 4 * h}}, steel, {.per_cell = 4})), TrackEnergy{}};
  auto& points = scene.body().points;
  for (std::size_t p = 0; p < points.size(); ++p) {
    double s = (points.position[p][0] - from) / 0.25;
    s -= std::floor(s / 4) * 4;
    if (pulse && s > 1) continue;
    const double v = 1e-3 * (pulse ? (1 - std::cos(2 * pi * s)) / 2 : 1 + std::cos(pi * s / 2)),
                 stress = -steel.density() * speed * v;
    points.velocity.set(p, {drift + v, 0});
    points.stress.set(p, Sym<double, 2>{{stress, stress / 3, stress / 3, 0}});
  }
  return scene;
}
/// Mean velocity of the points nearest to x, m/s.
template <class Scene>
double velocity_at(const Scene& scene, double x) {
  double sum = 0, near = 0;
  const auto& points = scene.body().points;
  for (std::size_t p = 0; p < points.size(); ++p) {
    double d = std::abs(points.position[p][0] - x);
    d = std::min(d, 1 - d);
    if (d >= 0.2501 * scene.mesh.edge()) continue;
    sum += points.velocity[p][0];
    ++near;
  }
  return near > 0 ? sum / near : std::nan("");
}

template <class N>
void check_ring(test::Validation& validation, const char* name, N numerics, double error) {
  // Across the seam the wave is the same as in the middle, where it knows of none.
  const Index cells = 64;
  const double h = 1.0 / cells, end = 0.2 / speed;
  auto middle = ring(numerics, cells, 0.25), seam = ring(numerics, cells, 0.75);
  const double dt = 0.2 * h / speed;
  for (double t = 0; t < end; t += dt) step(middle, dt), step(seam, dt);
  double worst = 0, most = 0;
  for (Index k = 0; k < 2 * cells; ++k) {
    const double x = (k + 0.5) * h / 2, y = x < 0.5 ? x + 0.5 : x - 0.5;
    worst = std::max(worst, std::abs(velocity_at(middle, x) - velocity_at(seam, y)));
    most = std::max(most, std::abs(velocity_at(middle, x)));
  }
  CHECK(most >= 0.9e-3);
  CHECK(worst <= 1e-11 * most);
  // Momentum is kept to round-off, and after a whole turn the wave is where it was.
  for (const Index n : {32u, 64u, 128u}) {
    auto turn = ring(numerics, n, 0.5, false);
    const auto start = turn;
    const double before = momentum(turn.body())[0];
    const int steps = static_cast<int>(5 * n);
    for (int k = 0; k < steps; ++k) step(turn, 1 / speed / steps);
    CHECK(std::abs(momentum(turn.body())[0] - before) <= 1e-13 * before);
    CHECK(std::abs(momentum(turn.body())[1]) <= 1e-13 * before);
    CHECK(turn.lost_points() == 0);
    double sum = 0, all = 0;
    for (Index k = 0; k < 2 * n; ++k) {
      const double x = (k + 0.5) / (2 * n), exact = velocity_at(start, x);
      sum += square(velocity_at(turn, x) - exact);
      all += square(exact);
    }
    const double off = std::sqrt(sum / all);
    CHECK(off <= error * square(32.0 / n));  // second order
    validation.value(name, joined_text({"error after one turn with ", n, " cells"}), "-", off, 0);
  }
}

/// Error of the stress after one turn of the wave, while all moves once round the ring and crosses n cells.
template <class N>
double crossing_error(test::Validation& validation, const std::string& name, N numerics, Index n) {
  auto scene = ring(numerics, n, 0.5, false, speed);
  auto& points = scene.body().points;
  for (std::size_t p = 0; p < points.size(); ++p) {  // as after a stretch, whose stresses were left out
    auto x = points.position[p];
    const double stretch = 1 + 0.3 * std::cos(2 * pi * x[0]);
    x[0] += 0.3 / (2 * pi) * std::sin(2 * pi * x[0]);
    points.position.set(p, x);
    points.volume[p] *= stretch;
    points.mass[p] *= stretch;
    const double s = x[0] * 4 - 2, v = 1e-3 * (1 + std::cos(pi * s / 2)),
                 stress = -steel.density() * speed * v;
    points.velocity.set(p, {speed + v, 0});
    points.stress.set(p, Sym<double, 2>{{stress, stress / 3, stress / 3, 0}});
  }
  const int steps = static_cast<int>(8 * n);
  for (int k = 0; k < steps; ++k) step(scene, 1 / speed / steps);
  double sum = 0, all = 0;
  for (std::size_t p = 0; p < points.size(); ++p) {
    const double x = points.position[p][0], exact = 1 + std::cos(pi * (4 * x - 2) / 2);
    const double found = -points.stress[p][0] / (steel.density() * speed * 1e-3);
    sum += square(found - exact);
    all += square(exact);
    if (n == 64 && points.position[p][1] < 1.0 / n)
      validation.point(name, "x (m)", x, "pressure / rho c (mm/s)", found, exact);
  }
  const double error = std::sqrt(sum / all);
  validation.value(name, joined_text({"error of the stress with ", n, " cells"}), "-", error, 0);
  return error;
}

using Linear = Numerics<LinearGrid, Flip, Musl>;
using Gimp = Numerics<UGimp<>, Flip, Musl>;
using Quadratic = Numerics<QuadraticBSpline, Flip, Musl>;
using Cubic = Numerics<CubicBSpline, Flip, Musl>;

}  // namespace

TEST_CASE(
    "Points that cross cells: with smoother functions the error falls with the cells, with hats it grows",
    "[heavy]") {
  test::Validation validation("cell_crossing");
  const auto errors = [&](const char* name, auto numerics) {
    std::array<double, 3> error{};
    for (std::size_t k = 0; k < 3; ++k) error[k] = crossing_error(validation, name, numerics, Index(32) << k);
    return error;
  };
  const auto linear = errors("linear", Linear{}), gimp = errors("uGIMP", Gimp{}),
             quadratic = errors("quadratic", Quadratic{}), cubic = errors("cubic", Cubic{});
  CHECK(linear[2] > linear[0]);
  CHECK(linear[2] > 0.1);
  for (const double error : gimp) CHECK(error <= 0.03);  // down to what sums over points leave of integrals
  CHECK(quadratic[1] <= 0.4 * quadratic[0]);
  CHECK(quadratic[2] <= 0.01);
  CHECK(cubic[1] <= 0.26 * cubic[0]);
  CHECK(cubic[2] <= 0.26 * cubic[1]);
}

TEST_CASE("Functions on periodic axes: unity, linear fields, no jump at the seam") {
  const CartesianGrid<2> flat{{.lower = {-1, 2}, .upper = {1, 5}, .cell = 0.5}};
  const CartesianGrid<3> space{{.lower = {0, 0, 0}, .upper = {4, 5, 6}, .cell = 1}};
  check_functions<LinearGrid>(periodic<0>(flat));
  check_functions<QuadraticBSpline>(periodic<0, 1>(flat));
  check_functions<CubicBSpline>(periodic<0>(flat));
  check_functions<QuadraticBSpline>(periodic<0, 2>(space));
  check_functions<CubicBSpline>(periodic<0, 1, 2>(space));
  const auto ring = periodic<0>(flat);
  CHECK((ring.wrapped({-1.25, 3}) - Vec<double, 2>(0.75, 3)).norm() <= 1e-15);
  CHECK((ring.wrapped({7.5, 1}) - Vec<double, 2>(-0.5, 1)).norm() <= 1e-15);
  CHECK(ring.period(0) == 2);
}

TEST_CASE("A wave runs round a ring as in a bar without end", "[heavy]") {
  test::Validation validation("ring");
  check_ring(validation, "linear; FLIP; MUSL", Linear{}, 0.04);
  check_ring(validation, "quadratic; FLIP; MUSL", Quadratic{}, 0.04);
  check_ring(validation, "cubic; FLIP; MUSL", Cubic{}, 0.05);
}

TEST_CASE("Rings: the same bits on any number of threads and after a restored state; refused") {
  const int before = threads();
  const auto state = [](int n) {
    set_threads(n);
    auto scene = ring(Quadratic{}, 64, 0.9);
    for (int k = 0; k < 40; ++k) step(scene, 0.2 / 64 / speed);
    return test::StateBuffer(scene);
  };
  const auto one = state(1);
  for (const int n : {2, 3}) CHECK(test::StateBuffer::first_difference(state(n), one) == "");
  set_threads(before);
  auto a = ring(Quadratic{}, 64, 0.9), b = ring(Quadratic{}, 64, 0.9);
  one.restore(a);
  one.restore(b);
  for (int k = 0; k < 10; ++k) step(a, 1e-5), step(b, 1e-5);
  CHECK(test::StateBuffer::first_difference(test::StateBuffer(a), test::StateBuffer(b)) == "");
  const auto small = periodic<0>(CartesianGrid<2>{{.lower = {0, 0}, .upper = {2, 4}, .cell = 1}});
  CHECK(test::message([&] { QuadraticBSpline::node_count(small); }) ==
        "periodic: cells = 2: must be at least 3 along a periodic axis");
  CHECK(test::message([&] { resolve<LinearGrid>(small, walls(right(fixed))); }) ==
        "Wall.axis = 0: is periodic: the mesh has no face there");
}

TEST_CASE("Simple shear between periodic sides stays homogeneous, by Jaumann tau = G sin gamma") {
  const double rate = 10, h = 0.125;
  Scene scene{PlaneStrain{},
              periodic<0>(CartesianGrid<2>{{.lower = {0, 0}, .upper = {0.5, 1}, .cell = h}}),
              Numerics<QuadraticBSpline, Apic, Usl>{},
              bodies(fill(Box{{0., 0.}, {0.5, 1.}}, steel, {.per_cell = 4})),
              walls(bottom(fixed)),
              driven(top(fixed), {rate, 0}),
              Reactions{}};
  auto& points = scene.body().points;
  for (std::size_t p = 0; p < points.size(); ++p) {
    points.velocity.set(p, {rate * points.position[p][1], 0});
    // As APIC has it: the gradient of the velocity.
    points.velocity_gradient.set(p, (Mat<double, 2>() << 0, rate, 0, 0).finished());
  }
  const double dt = 2.5e-4;
  for (int k = 0; k < 400; ++k) step(scene, dt);  // the top has gone round twice
  const double gamma = rate * scene.time, shear = steel.elasticity().shear();
  double worst = 0;
  for (std::size_t p = 0; p < points.size(); ++p)
    worst = std::max(worst, std::abs(points.stress[p][3] / (shear * std::sin(gamma)) - 1));
  CHECK(worst <= 2e-3);
  CHECK(std::abs(reaction(scene, "bottom").force[0] / (-0.5 * shear * std::sin(gamma)) - 1) <= 0.01);
  CHECK(scene.lost_points() == 0);
}
