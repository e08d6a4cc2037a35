// Rigid bodies against node fields: momentum to round-off, any mass, prescribed motion, centre of mass.
#include "catch.hpp"

#include <arenite/core/units.hpp>
#include <arenite/rigid/body/rigid_body.hpp>
#include <arenite/transfer/node_field.hpp>

#include "../mesh/sample_meshes.hpp"

using namespace arenite;
using namespace arenite::test;

namespace {

using P = Vec<double, 2>;

/// A surface written down node by node.
struct ListedSurface {
  static constexpr bool has_volume_fractions = true;
  std::vector<Index> nodes;
  std::vector<P> normals;
  std::vector<double> volume_fraction;
  std::vector<Index> inside{};
  template <class Shape, class M, class HasMass, class F>
  void visit(const M&, const P&, HasMass&&, F&& f) const {
    for (std::size_t k = 0; k < nodes.size(); ++k) f(nodes[k], normals[k], false, volume_fraction[k]);
    for (const Index i : inside) f(i, P(0, 0), true, 0.0);
  }
};

using Field = NodeField<double, 2, true, false>;
const CartesianGrid<2> grid({.lower = {0, 0}, .upper = {1, 1}, .cell = 0.25});

template <class Coupling = RigidVelocity>
auto make_rigid(ListedSurface surface, Guided motion, Friction friction) {
  using Motion = BoundGuided<double, 2>;
  return RigidBody<double, 2, ListedSurface, Motion, Coupling>{std::move(surface), Motion(motion), friction};
}
auto make_rigid(ListedSurface surface, Prescribed motion, Friction friction) {
  using Motion = BoundPrescribed<double, 2>;
  return RigidBody<double, 2, ListedSurface, Motion>{std::move(surface), Motion(motion), friction};
}

template <class R, class Fields>
ContactTally meet(R& body, Fields& fields, P gravity = {0, 0}, double dt = 0.01, double time = 0) {
  return collide<QuadraticBSpline>(grid, body, fields, gravity, time, dt);
}

/// Twenty touched nodes with normals that point roughly downwards, and one inside.
ListedSurface many_nodes(std::mt19937& random) {
  std::uniform_real_distribution<double> uniform(-1, 1);
  ListedSurface s;
  for (Index i = 0; i < 20; ++i) {
    s.nodes.push_back(i);
    const double a = 1.4 * uniform(random);
    s.normals.push_back({std::sin(a), -std::cos(a)});
    s.volume_fraction.push_back(0.04);
  }
  s.inside = {21};
  return s;
}

std::array<Field, 2> soil(std::mt19937& random) {
  std::uniform_real_distribution<double> uniform(0, 1);
  std::array<Field, 2> fields{Field(36), Field(36)};
  for (auto& f : fields)
    for (Index i = 0; i < 36; ++i) {
      f.mass[i] = random() % 3 == 0 ? 0 : uniform(random);
      f.velocity[i] = f.mass[i] > 0 ? P(uniform(random) - 0.5, uniform(random) - 0.5) : P(0, 0);
      f.start[i] = f.velocity[i];
    }
  return fields;
}

P momentum(const std::array<Field, 2>& fields) {
  P sum(0, 0);
  for (const auto& f : fields)
    for (std::size_t i = 0; i < f.size(); ++i) sum += f.mass[i] * f.velocity[i];
  return sum;
}

}  // namespace

TEST_CASE("a guided body gains what the soil loses, light or heavy, and no node is left moving in") {
  std::mt19937 random(5);
  for (const double mass : {1e-6, 1e-3, 1.0, 1e3, 1e6, 1e9})
    for (const Friction& friction :
         {Friction::frictionless(), Friction(0.35), Friction(1.0), Friction::no_slip()})
      for (int trial = 0; trial < 10; ++trial) {
        CAPTURE(mass, friction.coefficient(), trial);
        auto fields = soil(random);
        auto body = make_rigid(many_nodes(random), Guided{.mass = mass, .velocity = -5.6, .load = 3 * mass},
                               friction);
        const P before = momentum(fields);
        const P gravity(0, -9.81);
        const double drive = 0.01 * (-9.81 + 3);
        meet(body, fields, gravity);
        const P lost = before - momentum(fields);
        REQUIRE(body.contact_nodes > 0);
        REQUIRE((body.impulse - lost).norm() <= 1e-14 * (20 + lost.norm()));
        REQUIRE((body.force * 0.01 - lost).norm() <= 1e-14 * (20 + lost.norm()));
        // Along the guide: M (v - v_trial) = impulse on the body, to round-off.
        REQUIRE(std::abs(mass * (body.velocity[1] + 5.6 - drive) - body.impulse[1]) <=
                1e-13 * (body.impulse.norm() + mass * 5.6));
        REQUIRE(body.velocity[0] == 0);
        REQUIRE((body.displacement - 0.01 * body.velocity).norm() < 1e-16);
        // Without any slip an impulse jumps where a node begins to touch: there may be no exact balance.
        if (friction.is_no_slip()) continue;
        // A light body cannot be flung: its speed stays between the soil's and its own.
        REQUIRE(std::abs(body.velocity[1]) < 7);
        for (const auto& t : body.touched_nodes) {
          const P relative = fields[t.field].velocity[t.node] - body.velocity;
          if (t.inside)
            REQUIRE(relative.norm() < 1e-7);
          else
            REQUIRE(relative.dot(t.normal) > -1e-7);
        }
      }
}

TEST_CASE("one node, frictionless: the velocity after is that of two masses stuck together") {
  for (const double mass : {1e-6, 0.5, 2e6}) {
    std::array<Field, 1> fields{Field(36)};
    fields[0].mass[7] = 1.5;
    fields[0].velocity[7] = {0.3, 1};
    auto body =
        make_rigid({{7}, {P(0, -1)}, {1}}, Guided{.mass = mass, .velocity = -2}, Friction::frictionless());
    const auto tally = meet(body, fields);
    const double common = (1.5 * 1 + mass * -2) / (1.5 + mass);
    // The body's velocity follows from the impulse, whose round-off a light body shows.
    REQUIRE(std::abs(body.velocity[1] - common) < 1e-15 * (20 + 20 / mass));
    REQUIRE((fields[0].velocity[7] - P(0.3, common)).norm() < 1e-14);
    REQUIRE(tally.nodes == 1);
  }
}

TEST_CASE("no contact: a guided body falls as in free fall") {
  std::array<Field, 1> fields{Field(36)};
  auto body = make_rigid({{7}, {P(0, -1)}, {1}},
                         Guided{.mass = 2, .axis = {0, 3, 0}, .velocity = -1, .load = -4}, Friction(0.3));
  meet(body, fields, {5, -10}, 0.1);
  REQUIRE(std::abs(body.velocity[1] - (-1 - 0.1 * (10 + 2))) < 1e-15);
  REQUIRE(body.force.norm() == 0);
  REQUIRE(body.contact_nodes == 0);
  REQUIRE(std::abs(body.driving_work - 2 * (2.2 * 2.2 - 1) / 2) < 1e-14);
  // Soil that moves away faster is not touched.
  fields[0].mass[7] = 1;
  fields[0].velocity[7] = {0, -9};
  meet(body, fields, {0, 0}, 0.1);
  REQUIRE(body.contact_nodes == 0);
  REQUIRE(fields[0].velocity[7] == P(0, -9));
}

TEST_CASE("a load in time: a guided mass under F sin(w t) gains 2 F / (m w) in half a period") {
  const double mass = 2, force = 3, period = 0.5, w = 2 * pi / period, dt = period / 4000;
  std::array<Field, 1> fields{Field(36)};
  auto body = make_rigid({{7}, {P(0, -1)}, {1}},
                         Guided{.mass = mass, .load = [=](double t) { return force * std::sin(w * t); }},
                         Friction::frictionless());
  for (int n = 1; n <= 2000; ++n) meet(body, fields, {0, 0}, dt, n * dt);  // at the end of each step
  const double gained = 2 * force / (mass * w), way = force * pi / (mass * w * w);
  REQUIRE(std::abs(body.velocity[1] / gained - 1) < 1e-6);
  REQUIRE(std::abs(body.displacement[1] / way - 1) < 1e-3);
  REQUIRE(std::abs(body.driving_work / (mass * gained * gained / 2) - 1) < 1e-5);
  // A ramp, whose value is that of the start of the step.
  auto ramped = make_rigid({{7}, {P(0, -1)}, {1}}, Guided{.mass = mass, .load = Ramp{.to = 8, .over = 1}},
                           Friction::frictionless());
  for (int n = 1; n <= 8; ++n) meet(ramped, fields, {0, 0}, 0.125, n * 0.125);
  REQUIRE(ramped.velocity[1] == 0.125 * (0 + 1 + 2 + 3 + 4 + 5 + 6 + 7) / mass);
}

TEST_CASE("a prescribed body has its velocity, whatever it touches") {
  std::mt19937 random(7);
  auto fields = soil(random);
  const P before = momentum(fields);
  const auto motion = [](double t) { return std::array<double, 3>{0, -2 * t, 0}; };
  auto body = make_rigid(many_nodes(random), Prescribed{motion}, Friction(0.3));
  meet(body, fields, {0, -9.81}, 0.01, 0.5);
  REQUIRE(body.velocity == P(0, -1));
  REQUIRE((body.impulse - (before - momentum(fields))).norm() < 1e-13);
  REQUIRE(body.impulse[1] > 0);
  for (const auto& t : body.touched_nodes)
    if (!t.inside) REQUIRE((fields[t.field].velocity[t.node] - body.velocity).dot(t.normal) > -1e-14);
}

TEST_CASE(
    "through the centre of mass: the node gets the mean velocity of soil and its volume_fraction of the "
    "body") {
  std::array<Field, 1> fields{Field(36)};
  fields[0].mass[7] = 1.5;
  fields[0].velocity[7] = {0.3, 1};
  fields[0].mass[8] = 0.5;
  fields[0].velocity[8] = {0, -9};  // parts
  auto body = make_rigid<CentreOfMass>({{7, 8}, {P(0, -1), P(0, -1)}, {0.25, 0.5}},
                                       Guided{.mass = 8, .velocity = -2}, Friction::frictionless());
  meet(body, fields);
  const double centre = (1.5 * 1 + 2 * -2) / 3.5;  // 0.25 of 8 kg at the node
  REQUIRE((fields[0].velocity[7] - P(0.3, centre)).norm() < 1e-15);
  REQUIRE(fields[0].velocity[8] == P(0, -9));
  REQUIRE(std::abs(body.velocity[1] - (-2 + 1.5 * (1 - centre) / 8)) < 1e-15);
  // No slip: all of the velocity.
  fields[0].velocity[7] = {0.3, 1};
  auto rough = make_rigid<CentreOfMass>({{7}, {P(0, -1)}, {0.25}}, Guided{.mass = 8, .velocity = -2},
                                        Friction::no_slip());
  meet(rough, fields);
  REQUIRE((fields[0].velocity[7] - P(1.5 * 0.3 / 3.5, centre)).norm() < 1e-15);
}

TEST_CASE("mapped velocities keep what a rigid body stopped, whether they would close or part") {
  std::array<Field, 1> fields{Field(36)};
  for (const Index i : {2u, 3u, 4u, 5u, 6u}) fields[0].mass[i] = 1;
  fields[0].velocity[2] = {9, 0};   // slides
  fields[0].velocity[6] = {0, -9};  // parts
  auto body =
      make_rigid({{2, 3, 4, 6}, {P(0, -1), P(0, -1), P(0, -1), P(0, -1)}, {}, {5}}, Prescribed{[](double) {
                   return std::array<double, 3>{0, -2, 0};
                 }},
                 Friction(0.1));
  body.surface.volume_fraction.assign(4, 0.25);
  meet(body, fields);
  fields[0].mapped[2] = {1, 3};
  fields[0].mapped[3] = {1, 3};
  fields[0].mapped[4] = {1, -3};
  fields[0].mapped[5] = {1, 3};
  fields[0].mapped[6] = {1, 3};
  hold_touched(body.touched_nodes, fields, 0.01);
  REQUIRE((fields[0].mapped[2] - P(1, -2)).norm() < 1e-15);
  REQUIRE(fields[0].mapped[3] == P(0, -2));
  REQUIRE(fields[0].mapped[4] == P(0, -2));
  REQUIRE(fields[0].mapped[5] == P(0, -2));
  REQUIRE(fields[0].mapped[6] == P(1, 3));
}

TEST_CASE("bad motions are refused") {
  REQUIRE(throws([] { BoundGuided<double, 2>(Guided{}); }, "Guided.mass = nan: must be given, positive"));
  REQUIRE(throws([] { BoundGuided<double, 2>(Guided{.mass = -1}); },
                 "Guided.mass = -1: must be given, positive"));
  REQUIRE(throws([] { BoundGuided<double, 2>(Guided{.mass = 1, .velocity = std::nan("")}); },
                 "Guided.velocity = nan: must be finite"));
  REQUIRE(throws([] { BoundGuided<double, 2>(Guided{.mass = 1, .load = std::nan("")}); },
                 "Guided.load = nan: must be finite"));
  REQUIRE(throws(
      [] { BoundGuided<double, 2>(Guided{.mass = 1, .load = [](const Triple& x, double) { return x[0]; }}); },
      "Guided.load = f(x, t): must be a number or a function of time"));
  REQUIRE(throws(
      [] {
        BoundGuided<double, 2>(Guided{.mass = 1, .load = [](double) { return std::nan(""); }})
            .free_velocity({0, 0}, {0, 0}, 0.25, 0.125);
      },
      "t = 0.125 s: Guided.load = nan: must be finite"));
  const auto along = [](const std::array<double, 3>& axis) {
    return [axis] { BoundGuided<double, 2>(Guided{.mass = 1, .axis = axis}); };
  };
  const double inf = std::numeric_limits<double>::infinity();
  REQUIRE_NOTHROW(along({3, 4, 0})());
  REQUIRE(throws(along({0, 0, 1}), "Guided.axis = (0, 0): must have a length in the scene's dimensions"));
  REQUIRE(throws(along({0, inf, 0}), "Guided.axis = inf: must be finite"));
  REQUIRE(
      throws(along({0, 1, 1}), "Guided.axis = 1: must be zero along an axis that the scene does not have"));
  const auto driven = [](const std::array<double, 3>& velocity) {
    return [velocity] {
      const BoundPrescribed<double, 2> motion(Prescribed{[velocity](double) { return velocity; }});
      motion.free_velocity({0, 0}, {0, 0}, 0, 0);
    };
  };
  REQUIRE(throws(driven({0, std::nan(""), 0}), "Prescribed.velocity = nan: must be finite"));
  REQUIRE(throws(driven({0, 0, 2}),
                 "Prescribed.velocity = 2: must be zero along an axis that the scene does not have"));
}
