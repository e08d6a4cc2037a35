// Free rigid bodies: rotation without moments, springs and dashpots, contact solved for all velocities
// together. Against closed forms, and to round-off where a law of nature says so.
#include "catch.hpp"

#include <arenite/core/units.hpp>
#include <arenite/rigid/body/rigid_body.hpp>
#include <arenite/transfer/node_field.hpp>
#include <random>

#include "../mesh/sample_meshes.hpp"
#include "validation.hpp"

using namespace arenite;
using namespace arenite::test;

namespace {

/// Nodes at any place, each with a normal out of the body: a surface and the mesh that it knows in one.
template <int D>
struct Spots {
  static constexpr bool has_volume_fractions = false;
  std::vector<Vec<double, D>> place{}, normal{};
  template <class Shape, class M, class HasMass, class F>
  void visit(const M&, const Pose<D>&, HasMass&&, F&& f) const {
    for (std::size_t k = 0; k < place.size(); ++k)
      f(static_cast<Index>(k), normal[k], normal[k].squaredNorm() == 0, 0.0);
  }
};
/// Stands for a mesh: nodes where they are put.
template <int D>
struct SpotMesh {
  using scalar = double;
  static constexpr int dimension = D;
  std::vector<Vec<double, D>> place{};
};
struct SpotShape {
  template <class M>
  static auto node_position(const M& mesh, Index i) {
    return mesh.place[i];
  }
};

template <int D>
using Field = NodeField<double, D, true, false>;
template <int D>
using FreeBody = RigidBody<double, D, Spots<D>, BoundFree<double, D>>;

template <int D>
FreeBody<D> alone(const Free& motion, const Friction& friction = Friction::frictionless()) {
  return {{}, BoundFree<double, D>(motion), friction};
}
template <int D>
void fly(FreeBody<D>& body, double time, double dt, Vec<double, D> gravity = Vec<double, D>::Zero()) {
  std::array<Field<D>, 1> none{Field<D>(0)};
  collide<SpotShape>(SpotMesh<D>{}, body, none, gravity, time, dt);
}
template <int D>
double energy(const FreeBody<D>& body) {
  const PartEnergy e = body.count_energy();
  return e.kinetic + e.stored + e.dissipated - e.external;
}

using V3 = Vec<double, 3>;

}  // namespace

TEST_CASE("A box tumbles about its middle axis: 100 turns, momentum and energy to round-off, period exact",
          "[heavy]") {
  // 0.4 x 0.2 x 0.1 m of 12 kg: the middle axis is y.
  const V3 side(0.4, 0.2, 0.1), square = side.cwiseProduct(side);
  const V3 inertia(square[1] + square[2], square[0] + square[2], square[0] + square[1]);  // m / 12 = 1 kg
  const double spin = 6;
  auto body = alone<3>({.mass = 12,
                        .inertia = {inertia[0], inertia[1], inertia[2]},
                        .centre = {0.3, -2, 1},
                        .velocity = {1, 2, 3},
                        .spin = {0.01 * spin, spin, 0}});
  const V3 begin = body.motion.angular_momentum();
  const double started = energy(body);
  // Euler's equations in Jacobi's functions (Landau and Lifshitz, Mechanics, section 37).
  const double two_e = inertia[0] * 1e-4 * spin * spin + inertia[1] * spin * spin, l2 = begin.squaredNorm();
  const double low = two_e * inertia[2] - l2, high = l2 - two_e * inertia[0];  // both positive
  const bool outer = l2 > two_e * inertia[1];
  const double r = (inertia[2] - inertia[1]) * high, q = (inertia[1] - inertia[0]) * low;
  const double k2 = outer ? q / r : r / q;
  const double rate = std::sqrt((outer ? r : q) / inertia.prod());
  const double period = 4 * std::comp_ellint_1(std::sqrt(k2)) / rate;

  const double dt = 0.002, end = 100 * 2 * pi / spin;
  double worst_momentum = 0, worst_energy = 0, before = 0, first = 0, last = 0;
  int crossings = 0, flips = 0;
  const int steps = static_cast<int>(end / dt);
  const int along = outer ? 0 : 2;  // a component of the spin in the body's frame that changes its sign
  bool upright = true;
  for (int k = 0; k < steps; ++k) {
    fly<3>(body, (k + 1) * dt, dt);
    const Mat<double, 3> turned = body.orientation.matrix();
    const V3 local = turned.transpose() * body.spin;
    const V3 momentum = turned * inertia.cwiseProduct(local);
    worst_momentum = std::max(worst_momentum, (momentum - begin).norm() / begin.norm());
    worst_energy = std::max(worst_energy, std::abs(energy(body) / started - 1));
    if (before < 0 && local[along] >= 0) {
      last = (k + 1) * dt - dt * local[along] / (local[along] - before);
      if (crossings++ == 0) first = last;
    }
    before = local[along];
    flips += (local[1] > 0) != upright;
    upright = local[1] > 0;
  }
  REQUIRE(crossings > 4);
  REQUIRE(flips > 8);
  const double found = (last - first) / (crossings - 1);
  CAPTURE(worst_momentum, worst_energy, found, period, crossings, flips);
  CHECK(worst_momentum <= 1e-12);
  CHECK(worst_energy <= 1e-12);
  CHECK((body.motion.angular_momentum() - begin).norm() == 0);
  CHECK(std::abs(found / period - 1) <= 1e-3);
  const V3 way = steps * dt * V3(1, 2, 3);
  CHECK((body.position() - V3(0.3, -2, 1) - way).norm() <= steps * 1e-16 * way.norm());
  Validation table("rigid_rotation");
  table.value("box about its middle axis; 100 turns; 524 steps a turn", "period of tumbling", "s", found,
              period);
  table.value("same", "energy over its start", "-", 1 + worst_energy, 1);
  table.value("same", "angular momentum; largest relative change", "-", worst_momentum, 0);
}

TEST_CASE("A symmetric top precesses with L / I1: 100 turns, second order in the step", "[heavy]") {
  const double across = 2, about = 3, spin = 5, tilt = 0.4;
  const auto error_of = [&](double dt) {
    auto body = alone<3>({.mass = 1,
                          .inertia = {across, across, about},
                          .centre = {0, 0, 0},
                          .spin = {spin * std::sin(tilt), 0, spin * std::cos(tilt)}});
    const V3 momentum = body.motion.angular_momentum();
    const double rate = momentum.norm() / across, started = energy(body);
    const V3 axis = momentum.normalized(), u = V3(0, 1, 0), v = axis.cross(u);
    const int steps = static_cast<int>(std::lround(100 * 2 * pi / rate / dt));
    double angle = 0, old = 0, worst = 0, worst_momentum = 0;
    for (int k = 0; k < steps; ++k) {
      fly<3>(body, (k + 1) * dt, dt);
      const Mat<double, 3> turned = body.orientation.matrix();
      const V3 top = turned.col(2);
      const double now = std::atan2(top.dot(v), top.dot(u));
      if (k == 0) old = std::atan2(V3(0, 0, 1).dot(v), V3(0, 0, 1).dot(u));
      angle += std::remainder(now - old, 2 * pi);
      old = now;
      worst = std::max(worst, std::abs(energy(body) / started - 1));
      const V3 local = turned.transpose() * body.spin;
      const V3 l = turned * V3(across * local[0], across * local[1], about * local[2]);
      worst_momentum = std::max(worst_momentum, (l - momentum).norm() / momentum.norm());
      REQUIRE(std::abs(top.dot(axis) - V3(0, 0, 1).dot(axis)) <= 1e-11);  // no nutation
    }
    CHECK(worst <= 1e-12);
    CHECK(worst_momentum <= 1e-12);
    const double found = angle / (steps * dt);
    if (dt < 0.002) {
      Validation table("rigid_top");
      table.value("symmetric top; 100 turns; about 900 steps a turn", "rate of precession", "rad/s", found,
                  rate);
      table.value("same", "energy over its start", "-", 1 + worst, 1);
      table.value("same", "angular momentum; largest relative change", "-", worst_momentum, 0);
    }
    return std::abs(found / rate - 1);
  };
  const double coarse = error_of(0.004), fine = error_of(0.001);
  CHECK(fine <= 1e-5);
  CHECK(std::abs(coarse / fine - 16) <= 0.5);
}

TEST_CASE("Anchored bodies oscillate and die away as closed forms say; all energy is accounted for") {
  const double dt = 1e-3;
  auto swing = alone<2>({.mass = 2,
                         .inertia = 0.5,
                         .centre = {1, 1, 0},
                         .velocity = {0.3, 0, 0},
                         .spin = {0, 0, 4},
                         .anchor = {.stiffness = {8, 0, 0}, .rotational_stiffness = {0, 0, 4.5}}});
  const double started = energy(swing);
  double worst = 0;
  for (int k = 0; k < 10000; ++k) {  // rates 2 and 3 rad/s
    fly<2>(swing, (k + 1) * dt, dt);
    worst = std::max(worst, std::abs(energy(swing) / started - 1));
  }
  CHECK(std::abs(swing.displacement[0] - 0.15 * std::sin(20.0)) <= 0.15 * 2e-3);
  CHECK(std::abs(swing.orientation.angle() - 4.0 / 3 * std::sin(30.0)) <= 4.0 / 3 * 3e-3);
  CHECK(worst <= 4 * 3e-3);  // of first order in the step, and bounded

  auto damped = alone<3>({.mass = 2,
                          .inertia = {1, 2, 2.5},
                          .centre = {0, 0, 0},
                          .velocity = {1, 0, -2},
                          .spin = {0, 3, 0},
                          .anchor = {.damping = {4, 4, 0}, .rotational_damping = {0, 6, 0}}});
  for (int k = 0; k < 1000; ++k) fly<3>(damped, (k + 1) * dt, dt);
  CHECK(std::abs(damped.velocity[0] / std::exp(-2.0) - 1) <= 3e-3);
  CHECK(damped.velocity[2] == -2);
  CHECK(std::abs(damped.spin[1] / (3 * std::exp(-3.0)) - 1) <= 6e-3);
  CHECK(std::abs(energy(damped) / (5 + 9) - 1) <= 1e-12);
}

TEST_CASE("Springs of rotation keep the energy of a turning body in space, whatever their stiffnesses",
          "[heavy]") {
  double before = 0;
  for (const double dt : {1e-3, 5e-4}) {
    auto body = alone<3>({.mass = 1,
                          .inertia = {1, 2, 2.5, 0.1, -0.2, 0.3},
                          .centre = {0, 0, 0},
                          .spin = {1, -2, 1.5},
                          .anchor = {.rotational_stiffness = {5, 9, 2}}});
    const double started = energy(body);
    double worst = 0;
    for (int k = 0; k < static_cast<int>(std::lround(20 / dt)); ++k) {
      fly<3>(body, (k + 1) * dt, dt);
      REQUIRE(body.orientation.rotation_vector().norm() < 3);
      worst = std::max(worst, std::abs(energy(body) / started - 1));
    }
    CHECK(worst <= 6 * dt);
    if (before > 0) CHECK(std::abs(before / worst - 2) <= 0.1);
    before = worst;
  }
}

TEST_CASE("Gravity, a force and a moment in time: momentum is their integral, their work is counted") {
  auto body = alone<2>({.mass = 4,
                        .inertia = 2,
                        .centre = {0, 0, 0},
                        .spin = {0, 0, 1},
                        .force =
                            [](double t) {
                              return Triple{t, 0, 0};
                            },
                        .moment = VectorFunction({0, 0, 3}, Ramp{.over = 0.5})});
  const double started = energy(body), dt = 0.001;
  for (int k = 0; k < 1000; ++k) fly<2>(body, (k + 1) * dt, dt, {0, -9.81});
  CHECK(std::abs(body.velocity[0] - 1.0 / 8) <= dt);
  CHECK(std::abs(body.velocity[1] + 9.81) <= 1e-12);
  CHECK(std::abs(body.spin[0] - (1 + 3 * 0.75 / 2)) <= 2 * dt);
  CHECK(std::abs(energy(body) - started) <= 1e-12 * body.kinetic_energy());
}

namespace {

/// Twenty nodes within a metre with normals roughly downwards, one inside, on random matter.
template <int D>
struct Meeting {
  SpotMesh<D> mesh{};
  std::array<Field<D>, 2> fields{Field<D>(21), Field<D>(21)};
  FreeBody<D> body;

  Meeting(std::mt19937& random, double mass, const Friction& friction)
      : body(alone<D>({.mass = mass,
                       .inertia = D == 2 ? Inertia(0.3 * mass) : Inertia{0.2 * mass, 0.3 * mass, 0.4 * mass},
                       .centre = {0.2, 0.1, 0},
                       .velocity = {1, -5, 0},
                       .spin = {0, 0, 3}},
                      friction)) {
    std::uniform_real_distribution<double> uniform(-1, 1);
    for (Index i = 0; i < 21; ++i) {
      Vec<double, D> x, n;
      for (int k = 0; k < D; ++k) {
        x[k] = uniform(random);
        n[k] = 0.7 * uniform(random);
      }
      n[1] = -1;
      mesh.place.push_back(x);
      body.surface.normal.push_back(n.normalized());
      if (i == 20) body.surface.normal.back().setZero();
      for (auto& f : fields) {
        f.mass[i] = random() % 3 == 0 ? 0 : 0.5 + 0.5 * uniform(random);
        for (int k = 0; k < D; ++k) f.velocity[i][k] = f.mass[i] > 0 ? uniform(random) : 0;
        f.start[i] = f.velocity[i];
      }
    }
    body.surface.place = mesh.place;
  }
  /// Momentum of the matter, and its moment about the origin.
  Twist<double, D> momentum() const {
    Twist<double, D> sum = Twist<double, D>::Zero();
    for (const auto& f : fields)
      for (std::size_t i = 0; i < f.size(); ++i) {
        const Vec<double, D> p = f.mass[i] * f.velocity[i];
        sum += twist<double, D>(p, moment<double, D>(mesh.place[i], p));
      }
    return sum;
  }
  double kinetic_energy() const {
    double sum = body.kinetic_energy();
    for (const auto& f : fields)
      for (std::size_t i = 0; i < f.size(); ++i) sum += f.mass[i] * f.velocity[i].squaredNorm() / 2;
    return sum;
  }
  Twist<double, D> momentum_of_body() const {
    const Vec<double, D> p = body.motion.mass * body.velocity;
    return twist<double, D>(
        p, moment<double, D>(Vec<double, D>(body.position()), p) + body.motion.angular_momentum());
  }
};

template <int D>
void meet_at_random() {
  std::mt19937 random(5);
  for (const double mass : {1e-9, 1e-6, 1e-3, 1.0, 1e3, 1e6, 1e9})
    for (const Friction& friction :
         {Friction::frictionless(), Friction(0.35), Friction(1.0), Friction::no_slip()})
      for (int trial = 0; trial < 50; ++trial) {
        CAPTURE(D, mass, friction.coefficient(), trial);
        Meeting<D> m(random, mass, friction);
        auto& body = m.body;
        const Twist<double, D> matter = m.momentum(), own = m.momentum_of_body();
        const double dt = 1e-9;  // the centre moves by dt v, along the momentum
        const double kinetic = m.kinetic_energy();
        const Vec<double, D> none = Vec<double, D>::Zero();
        const auto tally = collide<SpotShape>(m.mesh, body, m.fields, none, dt, dt);
        const Twist<double, D> lost = matter - m.momentum(), gained = m.momentum_of_body() - own;
        REQUIRE((lost - gained).norm() <= 1e-14 * (100 + own.norm()));
        REQUIRE((body.impulse - linear_part<D>(lost)).norm() <= 1e-14 * (100 + lost.norm()));
        const double taken =
            kinetic - m.kinetic_energy();  // what a light body does is as exact as its velocity
        if (mass >= 1e-3) REQUIRE(std::abs(taken - tally.dissipation) <= 1e-13 * (100 + kinetic));
        if (!friction.is_no_slip()) REQUIRE(body.contact_nodes > 0);
        // No balance may exist without any slip, whose impulses jump where nodes begin to touch, and of a
        // body far lighter than the nodes with much friction; nodes' round-off moves a millionth of their
        // mass.
        if (friction.is_no_slip() || mass < (friction.coefficient() > 1 ? 1 : 1e-3)) continue;
        REQUIRE(body.velocity.norm() < 15);  // of the matter at most 2
        for (const auto& t : body.touched_nodes) {
          const Vec<double, D> apart =
              m.fields[t.field].velocity[t.node] - velocity_at<double, D>(body.whole_velocity(), t.arm);
          if (t.inside)
            REQUIRE(apart.norm() < 1e-6);
          else
            REQUIRE(apart.dot(t.normal) > -1e-6);
        }
      }
}

}  // namespace

TEST_CASE("A free body gains what material loses, also of angular momentum, light or heavy; no node moves in",
          "[heavy]") {
  meet_at_random<2>();
  meet_at_random<3>();
}

TEST_CASE(
    "A ball rolls down a slope with 5/7 g sin, a disc with 2/3: contact where they touch, on fixed matter",
    "[heavy]") {
  const auto roll = [](auto dimension, double share, double across) {
    constexpr int D = dimension;
    using V = Vec<double, D>;
    const double radius = 0.3, mass = 2, slope = 0.4, dt = 1e-4, end = 1;
    auto body = alone<D>({.mass = mass, .inertia = share * mass * radius * radius, .centre = {0, radius, 0}},
                         Friction(25_deg));
    SpotMesh<D> mesh{{V::Zero()}};
    std::array<Field<D>, 1> fields{Field<D>(1)};
    V gravity = V::Zero();
    gravity[0] = 9.81 * std::sin(slope) * std::cos(across);
    gravity[D - 1] += D == 3 ? 9.81 * std::sin(slope) * std::sin(across) : 0;
    gravity[1] = -9.81 * std::cos(slope);
    body.surface.normal = {-V::Unit(1)};
    body.surface.place = mesh.place;
    for (int k = 0; k < static_cast<int>(end / dt); ++k) {
      mesh.place[0] = body.position() - radius * V::Unit(1);  // where it touches the slope
      fields[0].mass[0] = 1e7;                                // five million times the body's
      fields[0].velocity[0].setZero();
      fields[0].start[0].setZero();
      collide<SpotShape>(mesh, body, fields, gravity, (k + 1) * dt, dt);
    }
    const double exact = 9.81 * std::sin(slope) / (1 + share);
    CHECK(std::abs(body.velocity.norm() / (exact * end) - 1) <= 1e-6);
    CHECK(std::abs(body.spin.norm() * radius / (exact * end) - 1) <= 1e-6);
    CHECK(std::abs(energy(body)) <= 1e-6 * body.kinetic_energy());
    Validation table(D == 3 ? "rolling_ball" : "rolling_disc");
    table.value(D == 3 ? "ball" : "disc", "acceleration", "m/s2", body.velocity.norm() / end, exact);
    return body;
  };
  roll(std::integral_constant<int, 2>(), 0.5, 0);
  const auto ball = roll(std::integral_constant<int, 3>(), 0.4, 0.7);
  CHECK(std::abs(ball.spin.dot(ball.velocity)) <= 1e-6);  // about the axis across its way
}

TEST_CASE(
    "A body whose rotation is prescribed takes the material inside along; its drive's work is recorded") {
  const auto turn = [](auto dimension) {
    constexpr int D = dimension;
    using V = Vec<double, D>;
    using Body = RigidBody<double, D, Spots<D>, BoundPrescribedPose<double, D>>;
    const PrescribedPose wheel{.centre = {1, 2, 0}, .velocity = {0.5, 0}, .spin = [](double t) {
                                 return Triple{0, 0, 2 * t};
                               }};
    Body body{{}, BoundPrescribedPose<double, D>(wheel), Friction(0.1)};
    SpotMesh<D> mesh;
    std::array<Field<D>, 1> fields{Field<D>(8)};
    for (int i = 0; i < 8; ++i) {
      mesh.place.push_back(V::Constant(0.1 * i) + V::Unit(1));
      fields[0].mass[static_cast<std::size_t>(i)] = 0.2;
    }
    body.surface.place = mesh.place;
    body.surface.normal.assign(8, V::Zero());
    double begin = 0;
    for (int k = 0; k < 100; ++k) {
      for (std::size_t i = 0; i < 8; ++i) fields[0].start[i] = fields[0].velocity[i];
      collide<SpotShape>(mesh, body, fields, V(V::Zero()), 0.01 * (k + 1), 0.01);
      double now = 0;
      for (std::size_t i = 0; i < 8; ++i) {
        const V arm = mesh.place[i] - V(body.position() - 0.01 * body.velocity);
        V exact = V::Zero();
        exact[0] = 0.5 - 0.02 * (k + 1) * arm[1];
        exact[1] = 0.02 * (k + 1) * arm[0];
        REQUIRE((fields[0].velocity[i] - exact).norm() <= 1e-13);
        now += 0.1 * fields[0].velocity[i].squaredNorm();
      }
      REQUIRE(std::abs(body.driving_work - body.dissipated - now) <= 1e-12);
      begin = now;
    }
    CHECK(begin > 0);
    const auto turned = body.orientation.rotation_vector();
    CHECK(std::abs(turned[D == 2 ? 0 : 2] - 1.01) <= 1e-12);  // sum of 2 t dt at the ends of the steps
    CHECK((body.position() - V(V::Unit(0) * 1.5 + V::Unit(1) * 2)).norm() <= 1e-13);
  };
  turn(std::integral_constant<int, 2>());
  turn(std::integral_constant<int, 3>());
}

TEST_CASE("A free body in axisymmetry moves along the axis; what cannot be is refused") {
  BoundFree<double, 2> along(Free{.mass = 2, .centre = {0, 1, 0}, .velocity = {0, -3, 0}}, true);
  CHECK(along.start() == Twist<double, 2>(0, -3, 0));
  const auto refuses = [](const Free& f, const std::string& what) {
    return throws([&] { BoundFree<double, 3>{f}; }, what);
  };
  CHECK(refuses({.centre = {0, 0, 0}}, "Free.mass = nan: must be given, positive"));
  CHECK(refuses({.mass = 1}, "Free.centre = nan: must be given, m"));
  CHECK(refuses({.mass = 1, .centre = {0, 0, 0}}, "Free.inertia = nan: must be given, positive"));
  CHECK(refuses(
      {.mass = 1, .inertia = {1, 1, 2.1}, .centre = {0, 0, 0}},
      "Free.inertia = (1, 1, 2.1): must be that of a body: no principal moment is greater than the other "
      "two together"));
  CHECK(refuses({.mass = 1, .inertia = {1, 1, 1, 2, 0, 0}, .centre = {0, 0, 0}},
                "Free.inertia = (1, 1, 1): must be finite and positive definite"));
  CHECK(refuses({.mass = 1, .inertia = 1, .centre = {0, 0, 0}, .anchor = {.stiffness = {0, -1, 0}}},
                "Free.anchor.stiffness = -1: must not be negative"));
  CHECK(throws(
      [] {
        BoundFree<double, 2>(Free{.mass = 1, .inertia = 1, .centre = {0, 0, 0}, .spin = {1, 0, 0}});
      },
      "Free.spin = 1: must be about z in a plane scene"));
  CHECK(throws(
      [] {
        BoundFree<double, 2>(Free{.mass = 1, .centre = {0.1, 0, 0}}, true);
      },
      "Free.centre = 0.1: must lie on the axis in an axisymmetric scene"));
}
