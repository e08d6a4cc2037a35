// Vibration of an elastic bar, fixed at one end and free at the other, against the Fourier solution: with
// rollers on its sides nothing but the axial strain is left, and u = a sin(k x) sin(k c t) with k = pi / (2
// L), c^2 = M / rho.
#include <arenite/arenite.hpp>

#include "catch.hpp"
#include "courant.hpp"
#include "meshes.hpp"

using namespace arenite;

namespace {

constexpr double length = 1, speed = 0.01;  // of the bar, m; of its free end at the start, m/s
constexpr double wave = pi / (2 * length);  // k, 1/m

LinearElastic steel() { return LinearElastic{{.density = 1000, .young = 1e5, .poisson = 0.25}}; }

struct Result {
  double period;     // relative error of the mean period
  double amplitude;  // amplitude in the last period over that of the Fourier solution
  std::size_t steps;
};

/// Starts the first mode, runs it through two periods, and follows its velocity (the mean over the points,
/// weighted with mass and the mode's shape).
template <class Scene>
Result vibrate(Scene scene, double courant) {
  auto& points = scene.body().points;
  std::vector<double> shape;
  for (std::size_t p = 0; p < points.size(); ++p) {
    shape.push_back(std::sin(wave * points.position[p][0]));
    points.velocity.set(p, Vec<double, 2>(speed * shape[p], 0));
  }
  const auto start = points.position;
  const LinearElastic law = steel();
  const double period = 2 * pi / (wave * std::sqrt(law.wave_modulus() / law.density()));
  std::vector<double> crossings;
  double before = 0, then = 0, largest = 0;
  run(scene, {.end = 1.8 * period, .courant = test::courant(scene, courant)}, [&](const auto& s) {
    double top = 0, travel = 0, bottom = 0;
    for (std::size_t p = 0; p < points.size(); ++p) {
      top += shape[p] * points.velocity[p][0];
      travel += shape[p] * (points.position[p][0] - start[p][0]);
      bottom += shape[p] * shape[p];
    }
    const double now = top / bottom;
    if (s.time > 0 && before * now < 0) crossings.push_back(then + (s.time - then) * before / (before - now));
    if (s.time > period) largest = std::max(largest, std::abs(travel / bottom));
    before = now;
    then = s.time;
  });
  REQUIRE(crossings.size() == 4);
  const double measured = (crossings.back() - crossings.front()) / 1.5;
  return {measured / period - 1, largest / (speed * period / (2 * pi)), scene.steps};
}

template <class N>
Result on_grid(N numerics, int cells, double courant = 0.2, int per_cell = 4) {
  const double h = length / cells;
  return vibrate(
      Scene{PlaneStrain{}, CartesianGrid<2>{{.lower = {0, 0}, .upper = {length + 4 * h, h}, .cell = h}},
            numerics, bodies(fill(Box{{0., 0.}, {length, h}}, steel(), {.per_cell = per_cell})),
            walls(left(roller), bottom(roller), top(roller))},
      courant);
}

template <class N>
Result on_triangles(N numerics, int cells, double courant = 0.2) {
  const double h = length / cells;
  const auto mesh = test::triangles({0, 0}, {length + 2 * h, h}, static_cast<Index>(cells + 2), 1);
  return vibrate(Scene{PlaneStrain{}, SimplexMesh<2>(mesh), numerics,
                       bodies(fill(Box{{0., 0.}, {length, h}}, steel(), {.per_cell = 6})),
                       walls(left(roller), bottom(roller), top(roller))},
                 courant);
}

/// The lumped mass lengthens the period by a relative (k h)^2 / 24 with linear functions and (k h)^2 / 8 with
/// quadratic splines (Taylor series of the mass matrix's symbol); mapping the velocities to and from the
/// points costs up to as much again as the spline's. In all less than 0.3 (k h)^2. (Cubic splines: 1/6 and as
/// much again.)
void check(const Result& r, int cells, double most = 0.3) {
  CAPTURE(r.period, r.amplitude, r.steps);
  CHECK(std::abs(r.period) <= most * square(wave * length / cells));
  CHECK(std::abs(r.amplitude - 1) <= 0.01);
}

}  // namespace

TEST_CASE("Bar on B-splines: period and amplitude of the first mode") {
  check(on_grid(Numerics<QuadraticBSpline, Flip, Usl>{}, 10), 10);
  check(on_grid(Numerics<QuadraticBSpline, Flip, Musl>{}, 10), 10);
  check(on_grid(Numerics<QuadraticBSpline, Apic, Usl>{}, 10), 10);
  check(on_grid(Numerics<QuadraticBSpline, Apic, Musl>{}, 10), 10);
}

TEST_CASE("Bar on cubic B-splines and linear functions: period and amplitude of the first mode") {
  // Two points an axis do not integrate the slopes of cubic splines beside a face.
  check(on_grid(Numerics<CubicBSpline, Flip, Usl>{}, 10, 0.2, 16), 10, 1.0 / 3);
  check(on_grid(Numerics<CubicBSpline, Apic, Musl>{}, 10, 0.2, 16), 10, 1.0 / 3);
  check(on_grid(Numerics<LinearGrid, Flip, Musl>{}, 10), 10);
  check(on_grid(Numerics<LinearGrid, Apic, Usl>{}, 10), 10);
}

TEST_CASE("Bar on triangles: period and amplitude of the first mode") {
  check(on_triangles(Numerics<LinearSimplex, Flip, Usl>{}, 10), 10);
  check(on_triangles(Numerics<LinearSimplex, Flip, Musl>{}, 10), 10);
  check(on_triangles(Numerics<LinearSimplex, Tpic, Usl>{}, 10), 10);
  check(on_triangles(Numerics<LinearSimplex, Flip, Musl, NodalAveraging>{}, 10), 10);
  check(on_triangles(Numerics<LinearSimplex, Flip, Usl, ElementAverage>{}, 10), 10);
}

TEST_CASE("Bar: the error of the period falls with the square of the cell size") {
  const double grid = on_grid(Numerics<QuadraticBSpline, Flip, Usl>{}, 8, 0.1).period /
                      on_grid(Numerics<QuadraticBSpline, Flip, Usl>{}, 16, 0.1).period;
  const double mesh = on_triangles(Numerics<LinearSimplex, Flip, Usl>{}, 8, 0.1).period /
                      on_triangles(Numerics<LinearSimplex, Flip, Usl>{}, 16, 0.1).period;
  CAPTURE(grid, mesh);
  CHECK(std::abs(std::log2(grid) - 2) <= 0.15);
  CHECK(std::abs(std::log2(mesh) - 2) <= 0.15);
}
