// Watch: each quantity warns past a tenth of its limit and stops past it, with time, value and place; a sound
// run says nothing.
#include <arenite/arenite.hpp>
#include <arenite/mesh/box_mesh.hpp>
#include <limits>

#include "catch.hpp"
#include "said.hpp"

using namespace arenite;
using namespace arenite::test;

namespace {

constexpr double inf = std::numeric_limits<double>::infinity();
constexpr WatchLimits no_energy{.energy_gain = inf, .transfer = inf, .residual = inf};

CartesianGrid<2> grid() { return CartesianGrid<2>{{.lower = {0, 0}, .upper = {1, 1}, .cell = 0.1}}; }

/// A block of sand on a floor, at rest or falling.
auto sand_block(double speed = 0) {
  const MohrCoulomb sand{
      {.density = 1500, .young = 1e6, .poisson = 0.3, .friction = 35_deg, .cohesion = 1000}};
  return Scene{
      PlaneStrain{},
      grid(),
      Numerics<QuadraticBSpline, Apic, Usl>{},
      bodies(
          fill(Box{{0., 0.}, {1., 0.5}}, WithDeviatoricStrain(sand),
               {.per_cell = 4, .velocity = {0, speed, 0}, .stress = Geostatic{.surface = 0.5, .k0 = 0.5}})),
      walls(bottom(fixed), left(roller), right(roller)),
      gravity({0, -9.81}),
      TrackEnergy{}};
}

/// Elastic, but its stress grows by a share in each step, without any strain.
struct Pump {
  template <class T>
  using History = NoHistory<T>;
  LinearElastic rubber{{.density = 1000, .young = 1e6, .poisson = 0.3}};
  double share;
  explicit Pump(double s) : share{s} {}
  double density() const { return rubber.density(); }
  double wave_modulus() const { return rubber.wave_modulus(); }
  template <class T, int D>
  T update(Sym<T, D>& stress, const StrainStep<T, D>& strain_step, NoHistory<T>& history) const {
    rubber.update(stress, strain_step, history);
    stress = stress * T(1 + share);
    return T(0);
  }
  template <class T, int D>
  T elastic_energy(const Sym<T, D>& stress) const {
    return rubber.elastic_energy(stress);
  }
};

/// A stretched block that swings.
template <class... Parts>
auto swinging(double share, Parts... parts) {
  Scene scene{PlaneStrain{}, grid(), Numerics<QuadraticBSpline>{},
              bodies(fill(Box{{0.2, 0.2}, {0.8, 0.6}}, Pump(share), {.per_cell = 4})), parts...};
  auto& points = scene.body().points;
  for (std::size_t p = 0; p < points.size(); ++p)
    points.velocity.column(0)[p] = 2 * (points.position[p][0] - 0.5);
  return scene;
}

template <class Scene>
double scene_kinetic(const Scene& scene) {
  return kinetic_energy(scene.body());
}

const Watched& of(const Watch& watch, std::string_view name) {
  for (const Watched& w : watch.seen())
    if (w.name == name) return w;
  throw error("no such quantity");
}

}  // namespace

TEST_CASE("A sound run: nothing is said, and what was seen is small") {
  auto scene = sand_block(-0.2);
  Watch watch;
  const Said s = said([&] { run(scene, {.end = 0.2}, watch); });
  CHECK(s.error == "");
  CHECK(s.warnings.empty());
  CHECK(watch.warnings().empty());
  for (const Watched& w : watch.seen()) {
    CAPTURE(w.name);
    CHECK(w.worst >= 0);
    CHECK(w.worst <= w.limit / 10);
    CHECK(w.time >= 0);
    CHECK(w.time <= 0.2);
  }
  CHECK(of(watch, "strength").worst <= 1e-12);
  CHECK(of(watch, "lost").worst == 0);
}

TEST_CASE("A watch that checks at regular times checks at the end, too") {
  auto scene = swinging(0);
  Watch watch({.energy_gain = inf, .transfer = inf, .residual = inf, .lost = 0.1});
  run(scene, {.end = 0.011}, every(0.01, watch));
  CHECK(of(watch, "lost").worst == 0);
  scene.body().lost = scene.body().points.size() / 5;
  const Said s = said([&] { run(scene, {.end = 0.014}, every(0.01, watch)); });  // no regular check
  CHECK(has(s.error, "lost"));
}

TEST_CASE("A scene at rest is not judged by its round-off") {
  auto scene = sand_block();
  Watch watch{{.energy_gain = 1e-6, .transfer = 1e-2, .every = 1}};
  const Said s = said([&] { run(scene, {.end = 0.05}, watch); });
  CHECK(s.error == "");
  Scene nothing{PlaneStrain{}, grid(), Numerics<QuadraticBSpline>{},
                bodies(fill(Box{{0.2, 0.2}, {0.8, 0.6}}, Pump(0), {.per_cell = 4}))};
  CHECK(said([&] { run(nothing, {.end = 0.05}, watch); }).error == "");
}

TEST_CASE("Energy that a law makes: first a warning, then the end, with and without an energy balance") {
  const auto check = [](auto scene) {
    Watch watch{{.every = 20}};
    const Said s = said([&] { run(scene, {.end = 10}, watch); });
    CAPTURE(s.error);
    REQUIRE(s.warnings.size() == 1);
    REQUIRE(watch.warnings().size() == 1);
    CHECK(watch.warnings()[0] == s.warnings[0]);
    CHECK(s.warnings[0].find("t = ") == 0);
    CHECK(has(s.warnings[0], "s: energy_gain = 0.0"));
    CHECK(has(s.error, joined_text({"t = ", scene.time, " s: energy_gain = 0.1"})));
    CHECK(has(s.error, "the limit is 0.1; the fastest point: body 0 at ("));
    const Watched& w = of(watch, "energy_gain");
    CHECK(w.worst > 0.1);
    CHECK(w.worst < 0.2);
    CHECK(w.time == scene.time);
    CHECK(std::isfinite(w.place[0]));
    CHECK(w.place[2] != w.place[2]);
  };
  check(swinging(1e-3, TrackEnergy{}));
  check(swinging(1e-3));
  check(swinging(1e-3, gravity({2, 0}, Ramp{.over = 1})));  // another acceleration at each step
  auto off = swinging(1e-3);
  Watch watch{{.energy_gain = inf}};
  CHECK(said([&] { run(off, {.end = 0.5}, watch); }).error == "");
  CHECK(of(watch, "energy_gain").worst != of(watch, "energy_gain").worst);
}

TEST_CASE("Energy that sways with the step is no gain: velocities are those of its middle") {
  const auto check = [](auto scene) {
    const double energy = kinetic_energy(scene.body());
    double sways = 0;
    Watch watch{{.every = 1}};
    const Said s = said([&] {
      run(scene, {.end = 0.2, .courant = 0.25}, watch, [&](const auto& now) {
        const auto& body = now.body();
        sways = std::max(sways, std::abs(kinetic_energy(body) + strain_energy(body) - energy) / energy);
      });
    });
    CAPTURE(s.error, sways);
    CHECK(s.error == "");
    CHECK(s.warnings.empty());
    CHECK(sways >= 0.02);
    CHECK(of(watch, "energy_gain").worst <= 0.01);
  };
  check(swinging(0, TrackEnergy{}));
  check(swinging(0));
}

TEST_CASE("At the limit of stability energy sways by more than a tenth, and none is gained") {
  std::uint32_t state = 1;
  const auto noise = [&state](const auto&) {
    std::array<double, 3> v{};
    for (std::size_t k = 0; k < 2; ++k)
      v[k] = 1e-4 * ((state = state * 1664525u + 1013904223u) / 0x1p32 - 0.5);
    return v;
  };
  Scene scene{
      PlaneStrain{}, SimplexMesh<2>{box_mesh<2>({.lower = {0, 0}, .upper = {1, 1}, .bricks = {6, 6}})},
      Numerics<LinearSimplex, Flip, Musl, ElementAverage>{},
      bodies(fill(Box{{0., 0.}, {1., 1.}}, LinearElastic{{.density = 1000, .young = 1e6, .poisson = 0.45}},
                  {.per_cell = 3, .velocity = noise})),
      TrackEnergy{}};
  const double energy = scene.part<TrackEnergy>().initial_kinetic;
  double sways = 0, gained = 0;
  const double dt = stable_step(scene);
  Watch watch{{.every = 1}};
  const Said s = said([&] {
    for (int k = 0; k < 500; ++k) {
      step(scene, dt);
      watch(scene);
      const Energies e = energies(scene);
      sways = std::max(sways, std::abs(e.residual) / energy);
      gained = std::max(gained, std::abs(e.residual - e.lag) / energy);
    }
  });
  CAPTURE(s.error, sways, gained);
  CHECK(s.error == "");
  CHECK(sways >= 0.1);
  CHECK(gained <= 1e-5);
  CHECK(of(watch, "energy_gain").worst <= 1e-5);
}

TEST_CASE("Energy put in from outside of the scene, or taken away") {
  for (const double factor : {1.2, 0.5}) {
    auto scene = swinging(0, TrackEnergy{});
    Watch watch{{.transfer = 0.3}};
    run(scene, {.end = 0.001, .max_step = 1e-4}, watch);
    auto& points = scene.body().points;
    for (auto& v : points.velocity.column(0)) v *= factor;
    const Said s = said([&] { run(scene, {.end = 0.002}, watch); });
    CAPTURE(s.error);
    const Watched& w = of(watch, factor > 1 ? "energy_gain" : "transfer");
    CHECK(has(s.error, joined_text({"t = 0.002 s: ", w.name, " = ", w.worst})));
    CHECK(std::abs(w.worst - std::abs(factor * factor - 1)) <= 0.05);
  }
  // A previous loss hides no gain.
  auto damped = swinging(0, TrackEnergy{});
  Watch both;
  const double given = scene_kinetic(damped);
  const auto scale = [&](double factor) {  // returns the energy given
    const double before = scene_kinetic(damped);
    for (auto& v : damped.body().points.velocity.column(0)) v *= factor;
    return scene_kinetic(damped) - before;
  };
  run(damped, {.end = 0.001, .max_step = 1e-4}, both);
  const double taken = -scale(0.5) / given;
  run(damped, {.end = 0.002, .max_step = 1e-4}, both);
  CHECK(of(both, "energy_gain").worst <= 0.01);
  CHECK(std::abs(of(both, "transfer").worst - taken) <= 0.01);
  const double gained = scale(1.6) / given;
  CHECK(gained > 0.1);
  CHECK(gained < taken);
  CHECK(has(said([&] { run(damped, {.end = 0.003, .max_step = 1e-4}, both); }).error, "energy_gain = 0."));
  CHECK(std::abs(of(both, "energy_gain").worst - gained) <= 0.01);
  // Without an energy balance a gain is the same, and points that are lost are none.
  auto scene = swinging(0);
  Watch watch{{.lost = inf, .every = 1}};
  run(scene, {.end = 0.001, .max_step = 1e-4}, watch);
  auto& body = scene.body();
  for (auto& v : body.points.velocity.column(0)) v *= 1.2;
  CHECK(has(said([&] { run(scene, {.end = 0.002}, watch); }).error, "energy_gain = 0.4"));
  body.lost = 1;
  CHECK(said([&] { Watch(WatchLimits{.lost = inf}).look(scene); }).error == "");
}

TEST_CASE("Energy that points bring is put in, what they take with them is not") {
  const auto check = [&](bool leave, auto... parts) {
    auto scene = swinging(0, parts...);
    Watch watch{{.transfer = inf, .residual = inf, .every = 1}};
    double given = scene_kinetic(scene);
    run(scene, {.end = 0.001, .max_step = 1e-4}, watch);
    if (leave)
      remove_points(scene, Box{{0.2, 0.2}, {0.4, 0.6}});
    else
      given += insert_points(scene, Box{{0.2, 0.7}, {0.8, 0.9}}, {.per_cell = 4, .velocity = {1, 0, 0}})
                   .kinetic_energy;
    run(scene, {.end = 0.002, .max_step = 1e-4}, watch);
    const double before = scene_kinetic(scene);
    for (auto& v : scene.body().points.velocity.column(0)) v *= 1.2;
    const double gained = (scene_kinetic(scene) - before) / given;
    CAPTURE(leave, gained);
    CHECK(gained > 0.1);
    CHECK(has(said([&] { run(scene, {.end = 0.003, .max_step = 1e-4}, watch); }).error, "energy_gain = "));
    CHECK(std::abs(of(watch, "energy_gain").worst - gained) <= 0.01);
  };
  for (const bool leave : {true, false}) {
    check(leave, TrackEnergy{});
    check(leave);
  }
}

TEST_CASE("Work of gravity and of a driven body is no gain, with and without an energy balance") {
  const LinearElastic rubber{{.density = 1000, .young = 1e5, .poisson = 0.3}};
  const auto check = [&](auto pull, auto... parts) {
    Scene scene{
        PlaneStrain{},
        grid(),
        Numerics<QuadraticBSpline, Apic, Usl>{},
        bodies(fill(Box{{0.2, 0.}, {0.8, 0.5}}, rubber, {.per_cell = 4})),
        walls(bottom(fixed)),
        pull,
        rigids(rigid(DistanceSurface{[](const auto& x) { return 0.52 - x[1]; }}, Prescribed{[](double) {
                       return std::array{0.0, -0.3, 0.0};
                     }},
                     Friction(0))),
        parts...};
    Watch watch;
    const Said s = said([&] { run(scene, {.end = 0.1}, watch); });
    CHECK(s.error == "");
    CHECK(s.warnings.empty());
    CHECK(strain_energy(scene.body()) > 1);
    return of(watch, "energy_gain").worst;
  };
  const auto shaken = gravity({0, -9.81}, [](double t) { return 1 + 5 * std::sin(1e3 * t); });
  CHECK(check(gravity({0, -9.81}), TrackEnergy{}) <= 0.01);
  CHECK(check(gravity({0, -9.81})) <= 0.01);
  CHECK(check(shaken) <= 0.01);
}

TEST_CASE("Gravity that changes between two checks does its work at its own strength") {
  Scene scene{
      PlaneStrain{}, grid(), Numerics<QuadraticBSpline>{},
      bodies(fill(Box{{0.3, 0.2}, {0.7, 0.6}}, LinearElastic{{.density = 1000, .young = 1e5, .poisson = 0.3}},
                  {.per_cell = 4, .velocity = {0, 2, 0}})),
      gravity({0, -10}, [](double t) { return t < 0.1 ? 1.0 : 0.1; })};
  Watch watch{{.every = 60}};
  const Said s = said([&] { run(scene, {.end = 0.2}, watch); });
  CHECK(s.error == "");
  REQUIRE(scene.steps >= 60);  // one check after the first
  REQUIRE(scene.steps < 120);
  // v: 2, 1 and 0.9 m/s, to one step. At the old strength, gravity takes 0.43 of the throw's energy more.
  CHECK(std::abs(scene.body().points.velocity[0][1] - 0.9) <= 10 * 0.005);
  CHECK(of(watch, "energy_gain").worst <= 0.01);
}

TEST_CASE("Volume, stress and lost points: a tenth warns once, the limit stops, with body and place") {
  auto scene = sand_block();
  run(scene, {.end = 0.002});
  auto& body = scene.body();
  auto& points = body.points;
  const auto volume = points.volume;
  const auto stress = points.stress;
  const auto swell = [&](double factor) {
    for (std::size_t p = 0; p < points.size(); ++p) points.volume[p] = factor * volume[p];
  };

  Watch watch{no_energy};  // stresses and volumes that are set by hand
  swell(1.04);
  CHECK(said([&] { watch.look(scene); }).warnings.empty());
  swell(1.1);
  points.volume[7] *= 2;
  CHECK(said([&] { watch.look(scene); }).warnings.size() == 1);
  const Watched& v = of(watch, "volume");
  CHECK(std::abs(v.worst - mean_volume_ratio(body) + 1) <= 1e-12);
  CHECK(v.body == 0);
  CHECK(v.place[0] == points.position[7][0]);
  CHECK(v.place[1] == points.position[7][1]);
  swell(1.2);
  CHECK(said([&] { watch.look(scene); }).warnings.empty());  // once
  swell(1.6);
  CHECK(has(said([&] { watch.look(scene); }).error,
            joined_text({"body 0: mean V/V0 = ", mean_volume_ratio(body)})));
  swell(0.4);
  CHECK(has(said([&] { watch.look(scene); }).error, joined_text({"volume = ", 1 - mean_volume_ratio(body)})));
  swell(1);

  // Outside by a share: yield = share, as the law has it.
  const auto shear = [&](std::size_t p, double share) {
    const double pressure = 5000, strength = pressure * std::sin(35_deg) + 1000 * std::cos(35_deg);
    const auto sheared = [&](double tau) { return Sym<double, 2>{{-pressure, -pressure, -pressure, tau}}; };
    double tau = strength;
    while (body.law.yield(sheared(tau)) < share) tau *= 1.0001;
    points.stress.set(p, sheared(tau));
  };
  shear(11, 0.005);
  CHECK(said([&] { watch.look(scene); }).warnings.empty());
  shear(11, 0.05);
  Said s = said([&] { watch.look(scene); });
  REQUIRE(s.warnings.size() == 1);
  CHECK(has(s.warnings[0], "strength = 0.05"));
  CHECK(of(watch, "strength").place[0] == points.position[11][0]);
  shear(points.size() - 1, 0.15);  // the last lanes of a pack are checked too
  CHECK(has(said([&] { watch.look(scene); }).error, "strength = 0.15"));
  CHECK(of(watch, "strength").place[0] == points.position[points.size() - 1][0]);
  // A stress that is round-off of larger ones does not count, wherever it points.
  points.stress = stress;
  points.stress.set(3, {{1e-9, 1e-9, 1e-9, 1e-8}});
  watch.look(scene);

  // It could not know better at the start: initial stresses may lie outside.
  auto fresh = sand_block();
  fresh.body().points.stress.set(3, {{0, 0, 0, 1e5}});
  CHECK(said([&] { Watch{no_energy}.look(fresh); }).error == "");

  points.stress = stress;
  body.lost = points.size() / 50;
  s = said([&] { watch.look(scene); });
  REQUIRE(s.warnings.size() == 1);
  CHECK(
      has(s.warnings[0], joined_text({"body 0: ", body.lost, " of ", body.lost + points.size(), " points"})));
  body.lost = points.size() / 5;
  CHECK(has(said([&] { watch.look(scene); }).error, "lost = 0.16"));
  body.lost = 0;
  CHECK(watch.warnings().size() == 3);
}

TEST_CASE("It checks at its first call, at each nth step and at the end; NaN is past every limit") {
  auto scene = sand_block();
  auto& volume = scene.body().points.volume;
  const auto seen_at_step = [&](std::size_t every, std::size_t steps) {
    auto s = scene;
    WatchLimits limits = no_energy;
    limits.every = every;
    Watch watch{limits};
    watch(s);
    for (std::size_t k = 0; k < steps; ++k) {
      step(s, 1e-5);
      if (k == 2) s.body().points.volume.assign(volume.size(), 10 * volume[0]);
      try {
        watch(s);
      } catch (const run_error&) {
        return s.steps;
      }
    }
    return std::size_t{0};
  };
  CHECK(seen_at_step(1, 20) == 3);
  CHECK(seen_at_step(8, 20) == 8);
  CHECK(seen_at_step(64, 20) == 0);
  // `run` makes it check at the end.
  WatchLimits rarely = no_energy;
  rarely.every = 1000000;
  for (auto& v : volume) v *= 2;
  Watch late{rarely};
  CHECK(has(said([&] { run(scene, {.end = 0}, late); }).error, "volume = 1"));
  auto end = sand_block();
  Watch last{rarely};
  const auto spoil = [&](const auto& s) {
    if (s.time == 0.001) end.body().points.volume.assign(volume.size(), volume[0]);
  };
  CHECK(has(said([&] { run(end, {.end = 0.001}, last, spoil); }).error, "t = 0.001 s: volume = 1"));
  volume[3] = std::numeric_limits<double>::quiet_NaN();
  CHECK(has(said([&] { Watch{no_energy}.look(scene); }).error, "volume = "));
}

TEST_CASE("Limits that are none are refused by name") {
  CHECK_THROWS_WITH(Watch(WatchLimits{.energy_gain = 0}),
                    "WatchLimits.energy_gain = 0: must be positive; infinity switches it off");
  CHECK_THROWS_AS(Watch(WatchLimits{.lost = std::nan("")}), error);
  CHECK_THROWS_AS(Watch(WatchLimits{.every = 0}), error);
}

TEST_CASE("Steps of 2.5 stable ones end by the energy that they gain") {
  auto scene = swinging(0);
  const double dt = 2.5 * stable_step(scene);
  Watch watch;
  const Said s = said([&] {
    for (int k = 0; k < 300; ++k) {
      step(scene, dt);
      watch(scene);
    }
  });
  CAPTURE(s.error);
  CHECK(has(s.error, "energy_gain = "));
}
