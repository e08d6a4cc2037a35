// Damping: decay of a free flight in closed form; columns come to rest at the elastic settlement, and what
// damping took closes the balance of energy.
#include <arenite/arenite.hpp>
#include <arenite/load/damping.hpp>
#include <arenite/run/settle.hpp>

#include "catch.hpp"
#include "meshes.hpp"
#include "state_buffer.hpp"
#include "validation.hpp"

using namespace arenite;

namespace {

constexpr double height = 1, g = 9.81, density = 2000;
LinearElastic soil() { return LinearElastic{{.density = density, .young = 1e7, .poisson = 0.25}}; }

template <class Numerics, class Mesh, class Damping>
auto column(const Mesh& mesh, const Damping& damping) {
  return Scene{PlaneStrain{},
               Mesh(mesh),
               Numerics{},
               bodies(fill(Box{{0., 0.}, {0.1, height}}, soil(), {.per_cell = 4})),
               walls(left(roller), right(roller), bottom(roller)),
               gravity({0, -g}),
               damping,
               TrackEnergy{}};
}

/// Runs a column to rest (no point changes its cell: they keep their order) and compares with rho g H^2 / (2
/// M), M the constrained modulus.
template <class Scene>
void check_rest(const std::string& name, Scene scene, double end, test::Validation& validation) {
  const auto& points = scene.body().points;
  const auto start = points.position;
  run(scene, {.end = end});
  const double settlement = density * g * height * height / (2 * soil().wave_modulus());
  std::size_t top = 0;
  for (std::size_t p = 0; p < points.size(); ++p)
    if (start[p][1] > start[top][1]) top = p;
  const double at = start[top][1], exact = density * g * (height * at - at * at / 2) / soil().wave_modulus();
  const double settled = start[top][1] - points.position[top][1];
  CHECK(std::abs(settled - exact) < 0.02 * settlement);
  validation.value(name, "settlement of the highest points", "mm", 1e3 * settled, 1e3 * exact);
  const Energies e = energies(scene);
  CHECK(e.kinetic < 1e-6 * e.external);
  CHECK(e.contact > 0);
  CHECK(std::abs(e.residual) < 0.001 * e.external);
  validation.value(name, "energy out of balance over the work of gravity", "-", e.residual / e.external, 0);
  double worst = 0;
  for (std::size_t p = 0; p < points.size(); ++p) {
    const double weight = density * g * (height - start[p][1]);
    worst = std::max(worst, std::abs(points.stress[p][1] + weight));
    validation.point(name, "y (m)", start[p][1], "vertical stress (kPa)", points.stress[p][1] / 1e3,
                     -weight / 1e3);
  }
  CHECK(worst < 0.06 * density * g * height);
}

}  // namespace

TEST_CASE("Viscous damping: a free flight decays as exp(-rate t), on any steps") {
  for (const double dt : {1e-4, 1e-3}) {
    Scene scene{PlaneStrain{},
                CartesianGrid<2>{{.lower = {0, 0}, .upper = {1, 1}, .cell = 0.1}},
                Numerics<QuadraticBSpline, Apic, Usl>{},
                bodies(fill(Box{{0.3, 0.3}, {0.6, 0.6}}, soil(), {.velocity = {1, -2, 0}})),
                ViscousDamping{.rate = 40},
                TrackEnergy{}};
    const double before = kinetic_energy(scene.body());
    for (int k = 0; k < 20; ++k) step(scene, dt);
    const double left = std::exp(-40 * scene.time);
    const auto v = Vec<double, 2>(momentum(scene.body()) / mass(scene.body()));
    CHECK((v - left * Vec<double, 2>(1, -2)).norm() < 1e-12);
    const Energies e = energies(scene);
    CHECK(std::abs(e.contact - before * (1 - left * left)) < 1e-12 * before);
    CHECK(std::abs(e.residual) < 1e-11 * before);
  }
}

TEST_CASE("Local damping does not slow steady motion down") {
  Scene scene{PlaneStrain{}, CartesianGrid<2>{{.lower = {0, 0}, .upper = {1, 1}, .cell = 0.1}},
              Numerics<QuadraticBSpline, Apic, Usl>{},
              bodies(fill(Box{{0.3, 0.3}, {0.6, 0.6}}, soil(), {.velocity = {1, -2, 0}})), LocalDamping{}};
  for (int k = 0; k < 20; ++k) step(scene, 1e-3);
  CHECK((momentum(scene.body()) / mass(scene.body()) - Vec<double, 2>(1, -2)).norm() < 1e-12);
}

TEST_CASE("Local damping takes 4 f / (1 + f)^2 of the energy of a mode in a cycle") {
  // Away from rest a node is slowed down with (1 + f) times its force, k u, towards rest driven with (1 - f)
  // times: half a cycle leaves (1 - f) / (1 + f) of the energy and takes pi / 2 (1 / sqrt(1 + f) + 1 / sqrt(1 - f)) / w.
  const CartesianGrid<2> grid{{.lower = {0, 0}, .upper = {0.1, height}, .cell = 0.05}};
  const double omega = pi / 2 * std::sqrt(soil().wave_modulus() / density) / height;
  const FillOptions lowest_mode{.velocity = [](const auto& x) {
    return std::array{0., 1e-3 * std::sin(pi / 2 * x[1] / height), 0.};
  }};
  for (const double f : {0.1, 0.3}) {
    Scene scene{PlaneStrain{},
                grid,
                Numerics<QuadraticBSpline, Flip, Musl>{},
                bodies(fill(Box{{0., 0.}, {0.1, height}}, soil(), lowest_mode)),
                walls(left(roller), right(roller), bottom(roller)),
                LocalDamping{.factor = f},
                TrackEnergy{}};
    const double before = kinetic_energy(scene.body());
    run(scene, {.end = pi / omega * (1 / std::sqrt(1 + f) + 1 / std::sqrt(1 - f))});
    const double lost = 1 - (kinetic_energy(scene.body()) + strain_energy(scene.body())) / before;
    CHECK(lost == Approx(4 * f / ((1 + f) * (1 + f))).epsilon(0.01));
    CHECK(energies(scene).contact == Approx(lost * before).epsilon(0.01));
  }
}

TEST_CASE("A damped column comes to rest at its elastic settlement") {
  const CartesianGrid<2> grid{{.lower = {0, 0}, .upper = {0.1, 1.2}, .cell = 0.05}};
  const SimplexMesh<2> mesh(test::triangles({0, 0}, {0.1, 1.2}, 2, 24));
  using Splines = Numerics<QuadraticBSpline, Flip, Musl>;
  using Triangles = Numerics<LinearSimplex, Flip, Musl>;
  const double omega = pi / 2 * std::sqrt(soil().wave_modulus() / density) / height;  // lowest mode
  test::Validation validation("settled_column");
  check_rest("B-splines; local damping", column<Splines>(grid, LocalDamping{}), 0.5, validation);
  check_rest("B-splines; viscous damping", column<Splines>(grid, ViscousDamping{.rate = 2 * omega}), 0.5,
             validation);
  check_rest("triangles; local damping", column<Triangles>(mesh, LocalDamping{}), 0.5, validation);
}

TEST_CASE("Local damping does not act on forces that a wall balances: a slow press feels the stiffness") {
  Scene scene{PlaneStrain{},
              CartesianGrid<2>{{.lower = {0, 0}, .upper = {0.1, height}, .cell = 0.05}},
              Numerics<QuadraticBSpline, Flip, Musl>{},
              bodies(fill(Box{{0., 0.}, {0.1, height}}, soil())),
              walls(left(roller), right(roller), bottom(roller)),
              driven(top(roller), {0, -0.05, 0}, Ramp{.over = 0.05}),
              LocalDamping{},
              Reactions{}};
  run(scene, {.end = 0.2});
  const double strain = 0.05 * (0.2 - 0.025) / height, exact = soil().wave_modulus() * strain * 0.1;
  CHECK(reaction(scene, "top").force[1] == Approx(-exact).epsilon(0.03));
  CHECK(reaction(scene, "bottom").force[1] == Approx(exact).epsilon(0.03));
}

TEST_CASE("Settled: forces in balance; without damping the column would continue for ever") {
  const CartesianGrid<2> grid{{.lower = {0, 0}, .upper = {0.1, 1.2}, .cell = 0.05}};
  auto scene = column<Numerics<QuadraticBSpline, Flip, Musl>>(grid, LocalDamping{});
  int shown = 3;
  const auto stops_at = [](std::size_t steps) {
    return [steps](const auto& s) { return s.steps == steps ? RunFlow::stop : RunFlow::go_on; };
  };
  for (const std::size_t steps : {0u, 3u}) {  // it is no failure that an observer ends it
    CHECK_FALSE(settle(scene, {.ratio = 1e-3, .end = 2}, stops_at(steps)));
    CHECK(scene.steps == steps);
  }
  CHECK(settle(scene, {.ratio = 1e-3, .end = 2}, [&](const auto&) { ++shown; }));
  CHECK(scene.time < 0.5);
  CHECK(shown == static_cast<int>(scene.steps) + 1);
  CHECK(out_of_balance(scene) <= 1e-3);
  const double weight = density * g * 0.1 * height;
  CHECK(std::abs(strain_energy(scene.body()) /
                     (weight * density * g * height * height / (6 * soil().wave_modulus())) -
                 1) < 0.02);
  // The second stage: nothing damps, and nothing moves.
  scene.part<LocalDamping>().switch_off();
  const double contact = energies(scene).contact, kinetic = kinetic_energy(scene.body());
  run(scene, {.end = scene.time + 0.1});
  CHECK(energies(scene).contact == contact);
  CHECK(kinetic_energy(scene.body()) < 10 * kinetic + 1e-6);
  auto free = column<Numerics<QuadraticBSpline, Flip, Musl>>(grid, LocalDamping{.factor = 0});
  CHECK_THROWS_WITH(settle(free, {.ratio = 1e-3, .end = 0.3}),
                    Catch::Matchers::Contains("forces are out of balance by"));
  CHECK_THROWS_WITH(settle(free, {.ratio = 0, .end = 1}),
                    Catch::Matchers::Contains("SettleOptions.ratio = 0"));
  CHECK_THROWS_WITH(settle(free, {}), Catch::Matchers::Contains("SettleOptions.end"));
}

TEST_CASE("Damping: the same bits on any number of threads and after a restored state; refused values") {
  const CartesianGrid<2> grid{{.lower = {0, 0}, .upper = {0.1, 1.2}, .cell = 0.05}};
  using Splines = Numerics<QuadraticBSpline, Flip, Musl>;
  const auto make = [&] { return column<Splines>(grid, LocalDamping{}); };
  const int threads_before = threads();
  set_threads(1);
  auto whole = make();
  for (int k = 0; k < 20; ++k) step(whole, 1e-4);
  const test::StateBuffer middle(whole);
  for (int k = 0; k < 20; ++k) step(whole, 1e-4);
  for (const int n : {1, 3}) {
    set_threads(n);
    auto scene = make();
    middle.restore(scene);
    for (int k = 0; k < 20; ++k) step(scene, 1e-4);
    CHECK(test::StateBuffer::first_difference(test::StateBuffer(scene), test::StateBuffer(whole)) == "");
  }
  set_threads(threads_before);
  CHECK_THROWS_WITH((LocalDamping{.factor = 1}),
                    Catch::Matchers::Contains("LocalDamping.factor = 1: must lie in [0, 1)"));
  CHECK_THROWS_WITH((ViscousDamping{.rate = -1}), Catch::Matchers::Contains("ViscousDamping.rate = -1"));
}
