// Axisymmetry against three dimensions and against theory: a hollow cylinder, free at its bore and rim and
// between smooth plates, breathes. Plane strain, u = A J1(k r) + B Y1(k r), no radial stress at both radii
// (Love, Mathematical Theory of Elasticity, ch. XII; Graff, Wave Motion in Elastic Solids, sec. 8.2).
#include <arenite/arenite.hpp>
#include <cmath>

#include "catch.hpp"
#include "meshes.hpp"

using namespace arenite;

namespace {

constexpr double bore = 0.5, rim = 1.0, height = 0.1, rate = 0.5;

LinearElastic ring() { return LinearElastic{{.density = 1000, .young = 1e6, .poisson = 0.25}}; }

/// Radial stress at r of J1(k r) (or Y1), over lambda + 2 G, times r.
double radial_stress(double k, double r, bool second) {
  const double z0 = second ? std::cyl_neumann(0, k * r) : std::cyl_bessel_j(0, k * r);
  const double z1 = second ? std::cyl_neumann(1, k * r) : std::cyl_bessel_j(1, k * r);
  const double nu = ring().elasticity().poisson();
  return k * r * z0 - (1 - 2 * nu) / (1 - nu) * z1;
}

/// Lowest root k of f in (from, to), found by halving.
template <class F>
double root(F f, double from, double to) {
  for (int i = 0; i < 60; ++i) {
    const double middle = (from + to) / 2;
    (f(from) * f(middle) <= 0 ? to : from) = middle;
  }
  return from;
}

double hollow_period() {
  const double k = root(
      [](double x) {
        return radial_stress(x, bore, false) * radial_stress(x, rim, true) -
               radial_stress(x, rim, false) * radial_stress(x, bore, true);
      },
      0.5, 3);
  return 2 * pi / (k * std::sqrt(ring().wave_modulus() / ring().density()));
}

double solid_period() {
  const double k = root([](double x) { return radial_stress(x, rim, false); }, 0.5, 3);
  return 2 * pi / (k * std::sqrt(ring().wave_modulus() / ring().density()));
}

/// Mean radial displacement over time, and the time between its first two zeros after the start, twice: the
/// period.
struct Breath {
  std::vector<double> displacement;
  double period;
};

template <class Scene>
Breath breathe(Scene scene, double end, double step) {
  auto& points = scene.body().points;
  constexpr int D = Scene::D;
  const auto radius = [](const Vec<double, D>& x) {
    if constexpr (D == 3) return std::hypot(x[0], x[2]);
    return x[0];
  };
  double mass = 0, start = 0;
  for (std::size_t p = 0; p < points.size(); ++p) {
    points.velocity.set(p, rate * points.position[p]);
    points.velocity.column(1)[p] = 0;
    mass += points.mass[p];
    start += points.mass[p] * radius(points.position[p]);
  }
  Breath breath;
  std::vector<double> zeros;
  double before = 0, then = 0;
  run(scene, {.end = end, .courant = 1, .max_step = step}, [&](const auto& s) {
    double now = -start;
    for (std::size_t p = 0; p < points.size(); ++p) now += points.mass[p] * radius(points.position[p]);
    now /= mass;
    breath.displacement.push_back(now);
    if (s.steps > 1 && now * before < 0) zeros.push_back(then + (s.time - then) * before / (before - now));
    before = now;
    then = s.time;
  });
  REQUIRE(zeros.size() >= 2);
  breath.period = 2 * (zeros[1] - zeros[0]);
  return breath;
}

template <class N>
auto triangles(N numerics) {
  const auto data = test::triangles({bore - 0.125, 0}, {rim + 0.125, height}, 12, 2);
  return Scene{Axisymmetric{}, SimplexMesh<2>(data), numerics,
               bodies(fill(Box{{bore, 0.}, {rim, height}}, ring(), {.per_cell = 6})),
               walls(bottom(roller), top(roller))};
}

template <class N>
auto wedge(N numerics) {
  const double angle = 5 * pi / 180;
  const auto data = test::wedge(bore - 0.125, rim + 0.125, height, angle, {12, 2, 2});
  return Scene{
      ThreeDimensional{}, SimplexMesh<3>(data), numerics,
      bodies(fill(Inside{[](const auto& x) {
                    const double r = std::hypot(x[0], x[2]);
                    return std::max(bore - r, r - rim);
                  }},
                  ring(), {.per_cell = 10})),
      walls(bottom(roller), top(roller), on("front", symmetry({std::sin(angle), 0, std::cos(angle)})),
            on("back", symmetry({-std::sin(angle), 0, std::cos(angle)})))};
}

template <class N>
auto grid(N numerics, double inner) {
  const double h = 0.0625;
  return Scene{Axisymmetric{}, CartesianGrid<2>{{.lower = {0, 0}, .upper = {1.125, 2 * h}, .cell = h}},
               numerics, bodies(fill(Box{{inner, 0.}, {rim, 2 * h}}, ring(), {.per_cell = 4})),
               walls(bottom(roller), top(roller))};
}

}  // namespace

TEST_CASE(
    "Axisymmetry: a hollow cylinder breathes at the frequency of theory, and as a slice in three dimensions "
    "does") {
  const double period = hollow_period(), end = 1.1 * period, step = period / 250;
  const Breath flat = breathe(triangles(Numerics<LinearSimplex, Flip>{}), end, step);
  const Breath solid = breathe(wedge(Numerics<LinearSimplex, Flip>{}), end, step);
  REQUIRE(flat.displacement.size() == solid.displacement.size());
  double largest = 0, apart = 0;
  for (std::size_t k = 0; k < flat.displacement.size(); ++k) {
    largest = std::max(largest, std::abs(flat.displacement[k]));
    apart = std::max(apart, std::abs(flat.displacement[k] - solid.displacement[k]));
  }
  CAPTURE(flat.period / period, solid.period / period, apart / largest);
  CHECK(std::abs(flat.period / period - 1) <= 0.01);
  CHECK(std::abs(solid.period / period - 1) <= 0.02);
  CHECK(apart <= 0.05 * largest);
  const Breath averaged =
      breathe(triangles(Numerics<LinearSimplex, Flip, Musl, NodalAveraging>{}), end, step);
  CHECK(std::abs(averaged.period / period - 1) <= 0.01);
}

TEST_CASE("Axisymmetry: a solid cylinder breathes at the frequency of theory; the axis stays put") {
  const double period = solid_period(), end = 1.1 * period, step = period / 250;
  CHECK(std::abs(breathe(grid(Numerics<QuadraticBSpline, Flip>{}, 0), end, step).period / period - 1) <=
        0.015);
  CHECK(std::abs(breathe(grid(Numerics<QuadraticBSpline, Apic, Usl>{}, 0), end, step).period / period - 1) <=
        0.015);
  const double hollow = hollow_period();
  CHECK(std::abs(breathe(grid(Numerics<QuadraticBSpline, Apic>{}, bore), 1.1 * hollow, hollow / 250).period /
                     hollow -
                 1) <= 0.015);
}
