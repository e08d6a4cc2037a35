// Parts of a user's own, each playing other roles, against closed forms: none of them changes the library.
#include <arenite/arenite.hpp>

#include "catch.hpp"
#include "meshes.hpp"
#include "state_buffer.hpp"

namespace {

using namespace arenite;

const LinearElastic rubber{{.density = 1000, .young = 1e6, .poisson = 0}};
CartesianGrid<2> grid() { return CartesianGrid<2>{{.lower = {0, 0}, .upper = {1, 1}, .cell = 0.1}}; }
const Box block{{0.3, 0.3}, {0.7, 0.7}};
using Apic2 = Numerics<QuadraticBSpline, Apic, Usl>;

/// Shakes everything: an acceleration in time, m/s2.
struct Shaker {
  double amplitude, rate;
  Vec<double, 2> acceleration(double time) const { return {amplitude * std::cos(rate * time), 0}; }
};

/// Drives all nodes right of x: constrains their velocity along `normal`, which may be skew, to `speed`.
struct Piston {
  double x, speed;
  Vec<double, 2> normal{1, 0};
  template <class Nodes>
  void constrain(Nodes& nodes) const {
    for (Index i = 0; i < nodes.size(); ++i)
      if (nodes.position(i)[0] >= x) nodes.block(i, normal);
  }
  Vec<double, 2> driven_velocity(const Vec<double, 2>&, double) const { return speed * normal.normalized(); }
};

/// Air that slows all matter down: v' = -rate v. Counts what it takes.
struct Drag {
  double rate, taken = 0;
  template <class Scene>
  ContactTally apply_impulses(Scene& scene, double dt) {
    ContactTally tally;
    for (auto& field : scene.fields)
      for (std::size_t i = 0; i < field.size(); ++i) {
        const Vec<double, 2> slower = std::exp(-rate * dt) * field.velocity[i];
        tally.dissipation += field.mass[i] * (field.velocity[i].squaredNorm() - slower.squaredNorm()) / 2;
        field.velocity[i] = slower;
      }
    taken += tally.dissipation;
    return tally;
  }
  PartEnergy count_energy() const { return {.dissipated = taken}; }
  template <class F>
  void visit_state(F&& f) {
    f("taken", taken);
  }
};

/// Asks for a field a body, and exchanges nothing: bodies that pass through each other.
struct Ghosts {
  static constexpr bool separates_bodies = true;
};

/// Bears no step above a limit, s.
struct Patience {
  double limit;
  template <class Scene>
  double stable_step(const Scene&) const {
    return limit;
  }
};

}  // namespace

TEST_CASE("An acceleration in time: the block's velocity is its integral, and its work is counted") {
  Scene scene{PlaneStrain{}, grid(), Apic2{}, bodies(fill(block, rubber)), Shaker{3, 40}, TrackEnergy{}};
  run(scene, {.end = 0.1, .max_step = 1e-4}, [&](const auto& s) {
    const double v = momentum(s.body())[0] / mass(s.body());
    REQUIRE(std::abs(v - 3.0 / 40 * std::sin(40 * s.time)) <= 3 * 1e-4);  // one step's
  });
  const Energies e = energies(scene);
  CHECK(std::abs(e.residual) <= 160 * 9 * 1e-4 * 0.1 / 2);  // m a2 dt t / 2: of first order in the step
}

TEST_CASE("Accelerations of several parts are added, and a scene without one has none") {
  Scene scene{PlaneStrain{},       grid(),       Apic2{}, bodies(fill(block, rubber)),
              gravity({0, -9.81}), Shaker{3, 40}};
  CHECK((scene.acceleration() - Vec<double, 2>(3, -9.81)).norm() <= 1e-15);
  const Scene still{PlaneStrain{}, grid(), Apic2{}, bodies(fill(block, rubber))};
  CHECK(still.acceleration().norm() == 0);
}

TEST_CASE("A piston draws a bar: uniform strain, and its work is what the bar stores") {
  const double speed = 0.01, end = 0.5;
  Scene scene{PlaneStrain{},
              grid(),
              Numerics<QuadraticBSpline, Flip, Musl>{.transfer = {.fraction = 0.9}},
              bodies(fill(Box{{0., 0.}, {1., 1.}}, rubber, {.per_cell = 4})),
              walls(left(roller), bottom(roller)),
              Piston{1, speed},
              TrackEnergy{}};
  run(scene, {.end = end});
  const double strain = std::log(1 + speed * end);
  double sum = 0;
  for (const auto& s : scene.body().points.stress) sum += s[0] / double(scene.body().points.size());
  CHECK(std::abs(sum / (1e6 * strain) - 1) <= 0.03);
  const Energies e = energies(scene);
  CAPTURE(e.external, e.strain, e.kinetic, e.residual);
  CHECK(std::abs(e.external / (1e6 * square(strain) / 2) - 1) <= 0.05);
  CHECK(std::abs(e.residual) <= 0.03 * e.external);
}

TEST_CASE("Parts that block at a node make one projector: their order does not matter, nor do driven nodes") {
  const auto velocities = [](auto... part) {
    Scene scene{PlaneStrain{}, grid(), Apic2{}, bodies(fill(Box{{0., 0.}, {1., 1.}}, rubber)), part...};
    step(scene, 1e-4);
    step(scene, 1e-4);
    return scene;
  };
  const Piston skew{1, 2, {1, 2}};
  const auto a = velocities(walls(bottom(roller)), walls(right(symmetry({2, 1, 0}))), skew);
  const auto b = velocities(skew, walls(right(symmetry({2, 1, 0})), bottom(roller)));
  REQUIRE(a.constraints.size() == b.constraints.size());
  for (std::size_t k = 0; k < a.constraints.size(); ++k)
    CHECK((a.constraints[k].projector - b.constraints[k].projector).norm() <= 1e-15);
  // On the driven face n . v is the piston's along its direction and zero along the wall's.
  const Vec<double, 2> wall(2, 1), piston = Vec<double, 2>(1, 2).normalized();
  for (const auto* s : {&a.fields[0], &b.fields[0]})
    for (const auto& d : a.drives) {
      const Vec<double, 2> v = s->velocity[d.node];
      if (QuadraticBSpline::node_position(a.mesh, d.node)[1] == 0) continue;  // three directions for two
      CHECK(std::abs(v.dot(wall)) <= 1e-14);
      CHECK(std::abs(v.dot(piston) - 2) <= 1e-14);
    }
  CHECK(!a.drives.empty());
}

TEST_CASE("Drag: an exponential decay, all of whose energy is counted") {
  Scene scene{PlaneStrain{}, grid(),
              Apic2{},       bodies(fill(block, rubber, {.per_cell = 4, .velocity = {0.5, 0, 0}})),
              Drag{4},       TrackEnergy{}};
  run(scene, {.end = 0.2});
  CHECK(std::abs(momentum(scene.body())[0] / mass(scene.body()) / (0.5 * std::exp(-0.8)) - 1) <= 1e-12);
  const Energies e = energies(scene);
  CHECK(std::abs(e.contact / (20 * (1 - std::exp(-1.6))) - 1) <= 1e-9);
  CHECK(std::abs(e.residual) <= 1e-9 * 20);
}

TEST_CASE("A part asks for a velocity field a body: bodies pass through each other") {
  Scene scene{PlaneStrain{}, grid(), Apic2{},
              bodies(fill<"goes">(Box{{0.2, 0.4}, {0.4, 0.6}}, rubber, {.velocity = {2, 0, 0}}),
                     fill<"stays">(Box{{0.5, 0.4}, {0.7, 0.6}}, rubber)),
              Ghosts{}};
  REQUIRE(scene.fields.size() == 2);
  run(scene, {.end = 0.15});
  CHECK(std::abs(momentum(scene.body<"goes">())[0] / mass(scene.body<"goes">()) - 2) <= 1e-12);
  CHECK(std::abs(momentum(scene.body<"stays">())[0]) <= 1e-12);
}

TEST_CASE("A part limits the step") {
  const Scene scene{PlaneStrain{}, grid(), Apic2{}, bodies(fill(block, rubber)), Patience{1e-7}};
  CHECK(stable_step(scene) == 1e-7);
  const Scene free{PlaneStrain{}, grid(), Apic2{}, bodies(fill(block, rubber)), Patience{1}};
  CHECK(stable_step(free) == stable_step(Scene{PlaneStrain{}, grid(), Apic2{}, bodies(fill(block, rubber))}));
}

TEST_CASE("Bodies are found by name and by number; parts by the recipe that made them") {
  const auto ball = DistanceSurface{[](const auto& x) { return std::hypot(x[0] - 0.5, x[1] - 0.9) - 0.05; }};
  Scene scene{
      PlaneStrain{},
      grid(),
      Apic2{},
      bodies(fill<"low">(Box{{0., 0.}, {1., 0.2}}, rubber), fill<"high">(Box{{0., 0.5}, {1., 0.6}}, rubber)),
      rigid<"ball">(ball, Guided{.mass = 2}, Friction(0)),
      rigids(rigid(ball, Guided{.mass = 3}, Friction(0))),
      Coulomb{Friction(0.1)}};
  CHECK(&scene.body<"low">() == &scene.body<0>());
  CHECK(&scene.body<"high">() == &std::get<1>(scene.bodies));
  CHECK(scene.rigid<"ball">().motion.mass == 2);
  CHECK(&scene.rigid<0>() == &scene.rigid<"ball">());
  CHECK(scene.rigid<1>().motion.mass == 3);
  CHECK(scene.part<Coulomb>().friction.coefficient() == std::tan(0.1));
  CHECK(scene.number_of("high", "option") == 1);
  CHECK_THROWS_WITH(scene.number_of("middle", "option"),
                    "option = middle: must be the number or the name of a body of the scene");
}

TEST_CASE("The state of a scene: points, bodies, rigid bodies and parts that own some") {
  const auto make = [] {
    return Scene{PlaneStrain{},
                 grid(),
                 Apic2{},
                 bodies(fill(block, rubber, {.per_cell = 4, .velocity = {0.5, 0, 0}})),
                 rigid(DistanceSurface{[](const auto& x) { return x[1] - 0.25; }},
                       Guided{.mass = 2, .velocity = 1}, Friction(0)),
                 Drag{4},
                 TrackEnergy{}};
  };
  auto a = make(), b = make();
  for (int k = 0; k < 10; ++k) step(a, 1e-4);
  const test::StateBuffer saved(a);
  CHECK(saved.has("parts/1/taken"));
  saved.restore(b);
  step(a, 1e-4);
  step(b, 1e-4);
  CHECK(a.time == b.time);
  CHECK(a.body().points.position == b.body().points.position);
  CHECK(a.rigid().velocity == b.rigid().velocity);
  CHECK(a.part<Drag>().taken == b.part<Drag>().taken);
  CHECK(energies(a).residual == energies(b).residual);
}
