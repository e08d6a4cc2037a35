// The stable step in closed form, and what it is for: no composition gains energy at a Courant number of 1.
#include <arenite/arenite.hpp>
#include <random>

#include "catch.hpp"
#include "meshes.hpp"

using namespace arenite;

namespace {

using Splines = Numerics<QuadraticBSpline, Apic, Usl>;
using Triangles = Numerics<LinearSimplex, Tpic, Usl>;

LinearElastic rubber(double density = 1000) {
  return LinearElastic{{.density = density, .young = 1e6, .poisson = 0.25}};
}
double wave(const LinearElastic& law) { return std::sqrt(law.wave_modulus() / law.density()); }
CartesianGrid<2> grid(double cell = 0.1) { return CartesianGrid<2>{{{0, 0}, {1, 1}, cell}}; }

}  // namespace

TEST_CASE("Stable step: cell size over wave speed, times what the numerics carry") {
  const Box lower{{0., 0.}, {1., 0.5}};
  const double c = wave(rubber());
  Scene splines{PlaneStrain{}, grid(), Splines{}, bodies(fill(lower, rubber()))};
  CHECK(stable_step(splines) == Approx(0.1 / c / std::sqrt(6)));
  Scene musl{PlaneStrain{}, grid(0.05), Numerics<QuadraticBSpline, Flip, Musl>{},
             bodies(fill(lower, rubber()))};
  CHECK(stable_step(musl) == Approx(0.05 / c / std::sqrt(3)));
  CHECK(Splines::courant_limit<3>() == Approx(1.0 / 3));
  // The altitude of right-angled triangles with legs of 0.1 m, and of flat ones where only those have points.
  const auto mesh = test::triangles({0, 0}, {1, 1}, 10, 10);
  Scene triangles{PlaneStrain{}, SimplexMesh<2>(mesh), Triangles{}, bodies(fill(lower, rubber()))};
  CHECK(stable_step(triangles) == Approx(0.35 * 0.1 / std::sqrt(2) / c));
  auto graded = mesh;
  for (auto& x : graded.nodes)
    if (x[1] > 0.55) x[1] = 0.5 + 0.1 * (x[1] - 0.5);
  Scene below{PlaneStrain{}, SimplexMesh<2>(graded), Triangles{},
              bodies(fill(Box{{0., 0.}, {1., 0.45}}, rubber()))};
  CHECK(stable_step(below) == Approx(stable_step(triangles)));
  Scene above{PlaneStrain{}, SimplexMesh<2>(graded), Triangles{},
              bodies(fill(Box{{0., 0.51}, {1., 1.}}, rubber()))};
  CHECK(stable_step(above) == Approx(0.35 * 0.1 * 0.01 / std::hypot(0.1, 0.01) / c));
}

TEST_CASE("Stable step: the fastest point counts, in whatever cell, lane and direction", "[limit]") {
  Scene scene{PlaneStrain{}, grid(), Splines{}, bodies(fill(Box{{0., 0.}, {1., 0.5}}, rubber()))};
  auto& points = scene.body().points;
  const double c = wave(rubber());
  for (const std::size_t p : {0u, 1u, 58u, 199u}) {
    points.velocity.set(p, Vec<double, 2>(-30, 40));
    CHECK(stable_step(scene) == Approx(0.1 / (c + 50) / std::sqrt(6)));
    points.velocity.set(p, Vec<double, 2>(0, 0));
  }
}

TEST_CASE("Stable step: the least of all bodies") {
  const auto step_of = [](double first, double second) {
    Scene scene{PlaneStrain{}, grid(), Splines{},
                bodies(fill(Box{{0., 0.}, {1., 0.3}}, rubber(first)),
                       fill(Box{{0., 0.5}, {1., 0.8}}, rubber(second), {.velocity = {0, 7, 0}}))};
    return stable_step(scene) * std::sqrt(6) / 0.1;
  };
  CHECK(step_of(100, 1000) == Approx(1 / wave(rubber(100))));
  CHECK(step_of(1000, 100) == Approx(1 / (wave(rubber(100)) + 7)));
  CHECK(step_of(1000, 1000) == Approx(1 / (wave(rubber()) + 7)));
}

namespace {

/// The warnings that `f()` gives.
template <class F>
std::vector<std::string> told(F&& f) {
  std::vector<std::string> texts;
  const WarningHook old = on_warning([&](const std::string& text) { texts.push_back(text); });
  f();
  on_warning(old);
  return texts;
}
bool has(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

/// A part that counts how often the stable step is asked for.
struct Asked {
  int* count;
  template <class Scene>
  double stable_step(const Scene&) const {
    ++*count;
    return 1;
  }
};

}  // namespace

TEST_CASE("step: a length that is none is refused, one above the stable step is reported once a scene") {
  const Scene fresh{PlaneStrain{}, grid(), Splines{}, bodies(fill(Box{{0., 0.}, {1., 0.5}}, rubber()))};
  const double bears = stable_step(fresh);
  Scene scene = fresh;
  for (const double dt : {0.0, -1.0, std::nan(""), double{INFINITY}, -double{INFINITY}})
    CHECK_THROWS_WITH(step(scene, dt), joined_text({"step: dt = ", dt, ": must be positive and finite (s)"}));
  CHECK(scene.steps == 0);
  for (const double times : {1.01, 3.0, 100.0}) {
    Scene other = fresh;
    const auto texts = told([&] {
      for (int k = 0; k < 3; ++k) step(other, times * bears);
    });
    REQUIRE(texts.size() == 1);
    CHECK(has(texts[0], joined_text({"t = 0 s, step 1: dt = ", times * bears, " s is ", times,
                                     " times the stable step of ", bears, " s"})));
    CHECK_THROWS_AS(step(other, 0), error);
  }
  // At any step: a longer one at once, a stable step that has fallen within 64.
  auto texts = told([&] {
    for (int k = 0; k < 5; ++k) step(scene, stable_step(scene));
    step(scene, 3 * bears);
    step(scene, 3 * bears);
  });
  REQUIRE(texts.size() == 1);
  CHECK(has(texts[0], "step 6"));
  Scene stretched = fresh;
  texts = told([&] {
    for (int k = 0; k < 10; ++k) step(stretched, 0.9 * bears);
    stretched.body().points.velocity.set(0, Vec<double, 2>(100, 0));
    for (int k = 0; k < 60; ++k) {
      step(stretched, 0.9 * bears);
      stretched.body().points.velocity.set(0, Vec<double, 2>(100, 0));
    }
  });
  CHECK(texts.size() == 1);
  // run chooses its steps, and none of them asks again.
  Scene runs = fresh;
  CHECK(told([&] { run(runs, {.end = 20.5 * bears, .courant = 1}); }).empty());
}

TEST_CASE("step: the stable step is asked for once in 64 steps") {
  int count = 0;
  Scene scene{PlaneStrain{}, grid(), Splines{}, bodies(fill(Box{{0., 0.}, {1., 0.5}}, rubber())),
              Asked{&count}};
  const double dt = 0.5 * stable_step(scene);
  count = 0;
  for (int k = 0; k < 128; ++k) step(scene, dt);
  CHECK(count == 2);
  run(scene, {.end = scene.time + 10 * dt, .courant = 0.5});
  CHECK(count == 12);
}

TEST_CASE("Stable step: follows a mesh that moved") {
  const auto push = [](double) { return std::array<double, 3>{0, -10, 0}; };
  auto data = test::triangles({0, 0}, {0.4, 1}, 4, 10);
  test::name_region(data, "platen", [](const auto& x) { return x[1] > 0.8; });
  Scene scene{PlaneStrain{},
              SimplexMesh<2>(data),
              Numerics<LinearSimplex, Flip>{},
              bodies(fill(Box{{0., 0.}, {0.4, 0.2}}, rubber(), {.per_cell = 3})),
              rigids(rigid(MeshSurface{"platen"}, Prescribed{push}, Friction::frictionless())),
              MovingMesh<>{.fixed_below = 0, .moving_from = 0.8}};
  const double c = wave(rubber()), before = stable_step(scene);
  CHECK(before == Approx(0.1 / std::sqrt(2) / c));
  for (int k = 0; k < 40; ++k) step(scene, 1e-3);  // 0.8 m become 0.4 m: cells of 0.1 m by 0.05 m
  const double altitude = 0.1 * 0.05 / std::hypot(0.1, 0.05);
  CHECK(stable_step(scene) == Approx(altitude / c));
}

namespace {

/// Greatest energy of a free body at random places in its cells, over that of its random motion (`speed`:
/// scatter, in wave speeds), in steps of Courant number 1.
template <class Scene>
double growth(Scene scene, unsigned seed, double speed = 1e-4) {
  auto& body = scene.body();
  std::mt19937 random(seed);
  std::normal_distribution<double> normal(0, speed);
  const double c = wave(rubber());
  for (std::size_t p = 0; p < body.points.size(); ++p) {
    auto v = body.points.velocity[p];
    for (int k = 0; k < Scene::D; ++k) v[k] = c * normal(random);
    body.points.velocity.set(p, v);
  }
  const auto energy = [&] { return kinetic_energy(body) + strain_energy(body); };
  const double start = energy();
  double most = start;
  for (int k = 0; k < 150 && most < 10 * start; ++k) {
    step(scene, stable_step(scene));
    most = std::max(most, energy());
  }
  return most / start;
}

template <class N>
double worst_on_splines() {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> some(0, 1);
  double worst = 0;
  for (unsigned k = 0; k < 12; ++k) {
    const double x = 0.2 + 0.2 * some(random), y = 0.2 + 0.2 * some(random);
    const Box box{{x, y}, {x + 0.12 + 0.3 * some(random), y + 0.12 + 0.3 * some(random)}};
    worst = std::max(worst, growth(Scene{PlaneStrain{}, grid(), N{},
                                         bodies(fill(box, rubber(), {.per_cell = k % 2 ? 1 : 4}))},
                                   k));
  }
  return worst;
}

}  // namespace

// The sum of two energies half a step apart oscillates by at most a tenth.
TEST_CASE("Courant number 1: no elastic block on splines gains energy", "[limit]") {
  CHECK(worst_on_splines<Numerics<QuadraticBSpline, Apic, Usl>>() <= 1.1);
  CHECK(worst_on_splines<Numerics<QuadraticBSpline, Flip, Usl>>() <= 1.1);
  CHECK(worst_on_splines<Numerics<QuadraticBSpline, Apic, Musl>>() <= 1.1);
  CHECK(worst_on_splines<Numerics<CubicBSpline, Flip, Usl>>() <= 1.1);
  CHECK(worst_on_splines<Numerics<CubicBSpline, Apic, Musl>>() <= 1.1);
}
TEST_CASE("Courant number 1: no elastic block on linear functions gains energy", "[limit]") {
  CHECK(worst_on_splines<Numerics<LinearGrid, Apic, Usl>>() <= 1.1);
  CHECK(worst_on_splines<Numerics<LinearGrid, Flip, Usl>>() <= 1.1);
  CHECK(worst_on_splines<Numerics<LinearGrid, Apic, Musl>>() <= 1.1);
}

namespace {

template <class K>
double worst_on_simplices(double speed, unsigned count) {
  constexpr std::size_t D = K::dimension;
  std::mt19937 random(3);
  std::uniform_real_distribution<double> some(0, 1);
  double worst = 0;
  for (unsigned k = 0; k < count; ++k) {
    std::array<double, D> lower, upper, origin{}, end;
    end.fill(1);
    for (std::size_t d = 0; d < D; ++d) {
      lower[d] = 0.2 + 0.2 * some(random);
      upper[d] = lower[d] + (D == 2 ? 0.12 : 0.2) + 0.3 * some(random);
    }
    const auto data = [&] {
      if constexpr (D == 2)
        return test::triangles(origin, end, 10, 10);
      else
        return test::tetrahedra(origin, end, {6, 6, 6});
    }();
    const auto inside = [&](const Vec<double, D>& x) {
      double beyond = -1;
      for (std::size_t d = 0; d < D; ++d)
        beyond = std::max({beyond, lower[d] - x[static_cast<int>(d)], x[static_cast<int>(d)] - upper[d]});
      return beyond;
    };
    const int per_cell = D == 2 ? (k % 2 ? 6 : 3) : 4;
    worst = std::max(worst, growth(Scene{K{}, SimplexMesh<D>(data), Numerics<LinearSimplex, Flip, Musl>{},
                                         bodies(fill(Inside{inside}, rubber(), {.per_cell = per_cell}))},
                                   k, speed));
  }
  return worst;
}

}  // namespace

// Of points that hardly move in their cells the two energies belong to one time, and their sum does not even
// sway (with a hoop strain it does, which differs from point to point: its half step is the cell's mean).
// Where points cross cells the gradient that they give to the grid changes.
TEST_CASE("Courant number 1: no free elastic block on simplices gains energy in FLIP with MUSL", "[limit]") {
  CHECK(worst_on_simplices<PlaneStrain>(1e-4, 20) <= 1.01);
  CHECK(worst_on_simplices<Axisymmetric>(1e-4, 20) <= 1.1);
  CHECK(worst_on_simplices<ThreeDimensional>(1e-4, 2) <= 1.01);
  CHECK(worst_on_simplices<PlaneStrain>(1e-2, 20) <= 1.1);
  CHECK(worst_on_simplices<Axisymmetric>(1e-2, 20) <= 1.1);
}

namespace {

struct Spun {
  double most, turn,
      momentum;  // greatest energy and last angular momentum over the first; momentum, relative
  std::size_t lost;
};

/// An elastic disc (2D) or ball that spins freely on simplices, through `turns`.
template <class N, int D>
Spun spin(double turns, double courant, int per_cell = D == 2 ? 3 : 4) {
  constexpr double rate = 20;
  std::array<double, D> lower, upper;
  lower.fill(-0.5), upper.fill(0.5);
  const auto data = [&] {
    if constexpr (D == 2)
      return test::triangles(lower, upper, 20, 20);
    else
      return test::tetrahedra(lower, upper, {8, 8, 8});
  }();
  const auto inside = [](const Vec<double, D>& x) { return x.norm() - 0.3; };
  using K = std::conditional_t<D == 2, PlaneStrain, ThreeDimensional>;
  Scene scene{K{}, SimplexMesh<D>(data), N{}, bodies(fill(Inside{inside}, rubber(), {.per_cell = per_cell}))};
  auto& body = scene.body();
  auto& points = body.points;
  Mat<double, D> whirl = Mat<double, D>::Zero();
  whirl(0, 1) = -rate, whirl(1, 0) = rate;
  for (std::size_t p = 0; p < points.size(); ++p) {
    points.velocity.set(p, whirl * points.position[p]);
    if constexpr (N::Transfer::affine) points.velocity_gradient.set(p, whirl);
  }
  const auto energy = [&] { return kinetic_energy(body) + strain_energy(body); };
  const auto angular = [&] {
    double sum = 0;
    for (std::size_t p = 0; p < points.size(); ++p) {
      const auto x = points.position[p], v = points.velocity[p];
      sum += points.mass[p] * (x[0] * v[1] - x[1] * v[0]);
    }
    return sum;
  };
  const auto push = momentum(body);
  const double start = energy(), whole = angular();
  Spun r{1, 0, 0, 0};
  run(scene, {.end = turns * 2 * pi / rate, .courant = courant}, [&](const auto& s) {
    if (s.steps % 10 == 0) r.most = std::max(r.most, energy() / start);
    if (r.most > 100) throw run_error("the energy has grown a hundred times");
  });
  r.turn = angular() / whole;
  r.momentum = (momentum(body) - push).norm() / std::sqrt(2 * mass(body) * start);
  r.lost = scene.lost_points();
  return r;
}

template <class N, int D>
void check_spin(double turns, double courant, double turn) {
  const Spun r = spin<N, D>(turns, courant);
  CAPTURE(r.most, r.turn, r.momentum);
  CHECK(r.lost == 0);
  CHECK(r.most <= 1.01);
  CHECK(std::abs(r.turn - 1) <= turn);
  CHECK(r.momentum <= 1e-12);
}

}  // namespace

TEST_CASE("A free elastic body that spins on simplices gains no energy and loses no point") {
  check_spin<Numerics<LinearSimplex, Tpic, Usl>, 2>(2, 1, 0.05);
  check_spin<Numerics<LinearSimplex, Tpic, Usl>, 2>(1, 0.2, 0.05);
  check_spin<Numerics<LinearSimplex, Flip, Usl>, 2>(2, 1, 0.2);  // FLIP does not conserve angular momentum
  check_spin<Numerics<LinearSimplex, Tpic, Usl>, 3>(0.5, 1, 0.05);
  check_spin<Numerics<LinearSimplex, Flip, Usl>, 3>(0.5, 1, 0.2);
}

// FLIP loses angular momentum, but keeps the energy of the rotation, as disordered motion.
TEST_CASE("A free elastic disc that spins ten times on triangles in FLIP with MUSL keeps its energy") {
  const Spun r = spin<Numerics<LinearSimplex, Flip, Musl>, 2>(10, 0.5, 6);
  CAPTURE(r.most, r.turn, r.momentum);
  CHECK(r.lost == 0);
  CHECK(r.most <= 1.05);
  CHECK(r.momentum <= 1e-12);
}
