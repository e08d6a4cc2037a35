// Rigid bodies that touch each other: collisions, slopes and stacks in closed form, momentum to round-off,
// and contact with matter in the same step.
#include <arenite/arenite.hpp>

#include "../mesh/sample_meshes.hpp"
#include "catch.hpp"
#include "state_buffer.hpp"
#include "validation.hpp"

using namespace arenite;
using test::throws;

namespace {

constexpr double g = 9.81;
using V2 = Vec<double, 2>;

/// Some matter far away, which a scene must have.
template <int D>
auto far_matter() {
  const LinearElastic rubber{{.density = 1000, .young = 1e5, .poisson = 0.2}};
  if constexpr (D == 2)
    return bodies(fill(Box{{-20., -20.}, {-19., -19.5}}, rubber, {.per_cell = 4}));
  else
    return bodies(fill(Box{{-20., -20., -20.}, {-19., -19.5, -19.}}, rubber, {.per_cell = 8}));
}
template <int D>
CartesianGrid<D> far_grid() {
  if constexpr (D == 2)
    return CartesianGrid<2>{{.lower = {-20, -20}, .upper = {-19, -19}, .cell = 0.5}};
  else
    return CartesianGrid<3>{{.lower = {-20, -20, -20}, .upper = {-19, -19, -19}, .cell = 0.5}};
}
struct Moving {
  DistanceSurface<> surface;
  Free motion;
};
template <int D, class Shape>
Moving body(const Shape& shape, const Free& motion) {
  return {{AnyDistance::of<D>(shape), 0.5}, motion};
}
/// Of unit mass, out of the way.
template <int D>
Moving parked(double x) {
  const double far = 100 + 10 * x;
  if constexpr (D == 2)
    return body<2>(Ball({far, far}, 0.1), {.mass = 1, .inertia = 1, .centre = {far, far, 0}});
  else
    return body<3>(Ball({far, far, far}, 0.1), {.mass = 1, .inertia = 1, .centre = {far, far, far}});
}

/// A fixed body, three free ones and their contact.
template <int D>
auto world(const std::array<double, 3>& gravity_vector, double friction, const DistanceSurface<>& ground,
           const Moving& a, const Moving& b = parked<D>(1), const Moving& c = parked<D>(2),
           const PrescribedPose& motion = {}) {
  using Kinematics = std::conditional_t<D == 2, PlaneStrain, ThreeDimensional>;
  const Friction smooth(0.0);
  return Scene{Kinematics{},
               far_grid<D>(),
               Numerics<QuadraticBSpline, Flip, Usl>{},
               far_matter<D>(),
               walls(bottom(fixed), left(roller), right(roller)),
               gravity(gravity_vector),
               rigid<"ground">(ground, motion, smooth),
               rigid<"a">(a.surface, a.motion, smooth),
               rigid<"b">(b.surface, b.motion, smooth),
               rigid<"c">(c.surface, c.motion, smooth),
               RigidContact{Friction(std::atan(friction))}};
}
template <int D>
DistanceSurface<> ground() {
  if constexpr (D == 2)
    return {AnyDistance::of<2>(Box{{-50., -1.}, {50., 0.}}), 0.5};
  else
    return {AnyDistance::of<3>(Box{{-50., -1., -50.}, {50., 0., 50.}}), 0.5};
}
Free box_of(double width, double height, double x, double y, double mass) {
  return {.mass = mass, .inertia = mass * (square(width) + square(height)) / 12, .centre = {x, y, 0}};
}

/// Momentum of the bodies a, b and c, and its moment about the origin.
template <class Scene>
auto momentum_of(const Scene& scene) {
  constexpr int D = Scene::D;
  Twist<double, D> sum = Twist<double, D>::Zero();
  const auto add = [&](const auto& body) {
    const Vec<double, D> p = body.motion.mass * body.velocity;
    sum += twist<double, D>(
        p, moment<double, D>(Vec<double, D>(body.position()), p) + body.motion.angular_momentum());
  };
  add(scene.template rigid<"a">());
  add(scene.template rigid<"b">());
  add(scene.template rigid<"c">());
  return sum;
}
/// Kinetic and stored energy, plus dissipated energy, minus external work.
template <class Scene>
double energy_of(const Scene& scene) {
  double sum = scene.template part<RigidContact>().dissipated;
  scene.for_each_rigid([&](const auto& body) {
    const PartEnergy e = body.count_energy();
    sum += e.kinetic + e.stored + e.dissipated - e.external;
  });
  return sum;
}

/// Two balls of radius 0.5 m and masses 1 and 3 kg that touch at the origin; the first one comes with
/// velocity `along` and `across` the normal. Returns the scene after some steps of length dt.
template <int D>
auto two_balls(double friction, double along, double across, double ratio, double dt, int steps) {
  const double share = D == 2 ? 0.5 : 0.4;
  const auto ball = [&](double x, double mass, double vx, double vy) {
    const Free motion{
        .mass = mass, .inertia = share * mass * 0.25, .centre = {x, 0, 0}, .velocity = {vx, vy, 0}};
    if constexpr (D == 2)
      return body<2>(Ball({x, 0.}, 0.5), motion);
    else
      return body<3>(Ball({x, 0., 0.}, 0.5), motion);
  };
  auto scene = world<D>({0, 0, 0}, friction, parked<D>(3).surface, ball(-0.5, 1, along, across),
                        ball(0.5, ratio, 0, 0));
  for (int k = 0; k < steps; ++k) step(scene, dt);
  return scene;
}

}  // namespace

TEST_CASE("Two balls collide as closed forms say; momentum and angular momentum are kept to round-off") {
  test::Validation table("rigid_collision");
  const auto check = [&](auto dimension) {
    constexpr int D = dimension;
    for (const double friction : {0.0, 0.1, 2.0})
      for (const double ratio : {3.0, 1e6, 1e-6}) {
        CAPTURE(D, friction, ratio);
        const double along = 2, across = 1.4, share = D == 2 ? 0.5 : 0.4;
        const auto begin = two_balls<D>(friction, along, across, ratio, 1e-7, 0);
        const auto scene = two_balls<D>(friction, along, across, ratio, 1e-7, 3);
        const auto& a = scene.template rigid<"a">();
        const auto& b = scene.template rigid<"b">();
        const double reduced = 1 / (1 + 1 / ratio), normal = reduced * along;
        const double stops = reduced * across / (1 + 1 / share), tangent = std::min(friction * normal, stops);
        CHECK(a.velocity[0] == Approx(along - normal).margin(1e-5));
        CHECK(a.velocity[1] == Approx(across - tangent).epsilon(1e-5));
        CHECK(b.velocity[0] == Approx(normal / ratio).epsilon(1e-5));
        CHECK(b.velocity[1] == Approx(tangent / ratio).epsilon(1e-5).margin(1e-5 * normal / ratio));
        CHECK(a.spin[D == 2 ? 0 : 2] == Approx(-0.5 * tangent / (share * 0.25)).epsilon(1e-5).margin(1e-6));
        const double scale = along + across;
        CHECK((momentum_of(scene) - momentum_of(begin)).norm() <= 1e-14 * scale * std::max(1.0, reduced));
        CHECK(std::abs(energy_of(scene) - energy_of(begin)) <= 1e-13 * energy_of(begin));
        CHECK(scene.template part<RigidContact>().dissipated > 0);
        if (ratio == 3) {
          const std::string what = std::string(D == 2 ? "discs" : "balls") + "; friction " +
                                   (friction == 0  ? "0"
                                    : friction < 1 ? "0.1"
                                                   : "2");
          table.value(what, "normal velocity of the first", "m/s", a.velocity[0], along - normal);
          table.value("same", "tangential velocity of the first", "m/s", a.velocity[1], across - tangent);
          table.value("same", "its spin", "rad/s", a.spin[D == 2 ? 0 : 2], -0.5 * tangent / (share * 0.25));
        }
      }
  };
  check(std::integral_constant<int, 2>());
  check(std::integral_constant<int, 3>());
}

TEST_CASE("A box on a slope sticks below its friction angle and slides above it with g (sin - mu cos)") {
  test::Validation table("rigid_slope");
  for (const double dt : {1e-3, 0.05})
    for (const double slope : {19.9_deg, 25_deg}) {
      CAPTURE(dt, slope);
      auto scene = world<2>({g * std::sin(slope), -g * std::cos(slope), 0}, std::tan(20_deg), ground<2>(),
                            body<2>(Box{{0., 0.}, {0.4, 0.2}}, box_of(0.4, 0.2, 0.2, 0.1, 2)));
      const auto& box = scene.rigid<"a">();
      const int steps = static_cast<int>(std::lround(1 / dt));
      for (int k = 0; k < steps; ++k) step(scene, dt);
      const double exact = slope < 20_deg ? 0 : g * (std::sin(slope) - std::tan(20_deg) * std::cos(slope));
      CHECK(box.velocity[0] == Approx(exact).epsilon(1e-10).margin(1e-12));
      CHECK(std::abs(box.velocity[1]) <= 1e-12);
      CHECK(std::abs(box.displacement[1]) <= 1e-12);
      CHECK(std::abs(box.orientation.angle()) <= 1e-12);
      CHECK(std::abs(energy_of(scene)) <= 1e-12);
      if (dt < 0.01) {
        table.value(
            slope < 20_deg ? "box; slope 19.9 deg; friction 20 deg" : "box; slope 25 deg; friction 20 deg",
            "acceleration", "m/s2", box.velocity[0], exact);
      }
    }
}

TEST_CASE("A ball rolls down a rigid slope with 5/7 g sin, a disc with 2/3, whatever the step") {
  test::Validation table("rigid_slope_rolling");
  const auto roll = [&](auto dimension, double dt) {
    constexpr int D = dimension;
    const double slope = 0.3, share = D == 2 ? 0.5 : 0.4, radius = 0.3;
    const Free motion{.mass = 2, .inertia = 2 * share * square(radius), .centre = {0, radius, 0}};
    const auto ball = [&] {
      if constexpr (D == 2)
        return Ball({0., 0.3}, 0.3);
      else
        return Ball({0., 0.3, 0.}, 0.3);
    };
    auto scene = world<D>({g * std::sin(slope), -g * std::cos(slope), 0}, std::tan(30_deg), ground<D>(),
                          body<D>(ball(), motion));
    const auto& a = scene.template rigid<"a">();
    const int steps = static_cast<int>(std::lround(1 / dt));
    for (int k = 0; k < steps; ++k) step(scene, dt);
    const double exact = g * std::sin(slope) / (1 + share);
    CHECK(a.velocity[0] == Approx(exact).epsilon(1e-10));
    CHECK(-radius * a.spin[D == 2 ? 0 : 2] == Approx(exact).epsilon(1e-10));
    CHECK(std::abs(a.displacement[1]) <= 1e-12);
    if (dt < 0.01)
      table.value(D == 2 ? "disc on a rigid slope" : "ball on a rigid slope", "acceleration", "m/s2",
                  a.velocity[0], exact);
  };
  for (const double dt : {0.02, 1e-3}) {
    roll(std::integral_constant<int, 2>(), dt);
    roll(std::integral_constant<int, 3>(), dt);
  }
}

TEST_CASE("A stack of boxes keeps still, and bodies in a row move on together, at mass ratios to a million") {
  test::Validation table("rigid_row");
  for (const double ratio : {1.0, 1e6, 1e-6}) {
    CAPTURE(ratio);
    auto stack = world<2>({0, -g, 0}, 0.3, ground<2>(),
                          body<2>(Box{{0., 0.}, {0.4, 0.2}}, box_of(0.4, 0.2, 0.2, 0.1, 1)),
                          body<2>(Box{{0., 0.2}, {0.4, 0.4}}, box_of(0.4, 0.2, 0.2, 0.3, ratio)),
                          body<2>(Box{{0., 0.4}, {0.4, 0.6}}, box_of(0.4, 0.2, 0.2, 0.5, 1)));
    double fastest = 0;
    for (int k = 0; k < 300; ++k) {
      step(stack, 1e-3);
      stack.for_each_rigid([&](const auto& b) { fastest = std::max(fastest, b.velocity.norm()); });
    }
    CHECK(fastest <= (ratio == 1 ? 1e-10 : 1e-7));  // of the fall of a step, 1e-2
    CHECK(stack.part<RigidContact>().deepest() <= 1e-9);

    const auto ball = [](double x, double mass, double v) {
      return body<2>(Ball({x, 0.}, 0.5),
                     {.mass = mass, .inertia = mass / 8, .centre = {x, 0, 0}, .velocity = {v, 0, 0}});
    };
    auto row =
        world<2>({0, 0, 0}, 0.3, parked<2>(3).surface, ball(0, 1, 3), ball(1, ratio, 0), ball(2, 1, 0));
    step(row, 1e-3);
    for (const double v :
         {row.rigid<"a">().velocity[0], row.rigid<"b">().velocity[0], row.rigid<"c">().velocity[0]})
      CHECK(v == Approx(3 / (2 + ratio)).epsilon(1e-8).margin(1e-11));
    table.value(ratio == 1  ? "three equal balls in a row"
                : ratio > 1 ? "middle one 1e6 times as heavy"
                            : "middle one 1e-6 times as heavy",
                "common velocity", "m/s", row.rigid<"c">().velocity[0], 3 / (2 + ratio));
  }
}

TEST_CASE("Steps as long as bodies: none passes through another; a driven body's work is all accounted for") {
  // 40 m/s and a step of 0.05 s: 2 m, through a ground 1 m thick.
  auto fast =
      world<2>({0, 0, 0}, 0.3, ground<2>(),
               body<2>(Ball({0., 0.6}, 0.1),
                       {.mass = 1, .inertia = 0.005, .centre = {0, 0.6, 0}, .velocity = {0, -40, 0}}));
  for (int k = 0; k < 5; ++k) step(fast, 0.05);
  CHECK(fast.rigid<"a">().position()[1] == Approx(0.1).epsilon(1e-6));
  CHECK(std::abs(fast.rigid<"a">().velocity[1]) <= 1e-6);

  // A piston pushes three boxes in a row.
  const auto box = [](double x) {
    return body<2>(Box{{x, 0.}, {x + 0.2, 0.2}}, box_of(0.2, 0.2, x + 0.1, 0.1, 2));
  };
  auto row = world<2>({0, 0, 0}, 0.3, {AnyDistance::of<2>(Box{{-0.5, -0.1}, {0., 0.3}}), 0.5}, box(0.1),
                      box(0.4), box(0.6), {.velocity = {2, 0, 0}});
  for (int k = 0; k < 200; ++k) {
    step(row, 1e-3);
    REQUIRE(std::abs(energy_of(row)) <= 1e-12);
  }
  CHECK(row.rigid<"c">().velocity[0] == Approx(2).epsilon(1e-9));
  CHECK(row.rigid<"ground">().driving_work == Approx(3 * 2 * 4).epsilon(1e-9));
}

TEST_CASE(
    "In space a tumbling box comes to rest on a face without a gain of energy; crossed bars stay crossed") {
  const double m = 2;
  auto scene = world<3>(
      {0, -g, 0}, std::tan(20_deg), ground<3>(),
      body<3>(
          placed(Box{{-0.2, -0.1, -0.05}, {0.2, 0.1, 0.05}}, {.at = {0, 0.3, 0}, .turned = {0.3, 0.4, 0.5}}),
          [&] {
            const Vec<double, 3> w(0.3, 0.4, 0.5), n = w.normalized();
            Mat<double, 3> cross;
            cross << 0, -n[2], n[1], n[2], 0, -n[0], -n[1], n[0], 0;
            const Mat<double, 3> turn = Mat<double, 3>::Identity() + std::sin(w.norm()) * cross +
                                        (1 - std::cos(w.norm())) * cross * cross;
            const Vec<double, 3> own = m / 12 * Vec<double, 3>(0.04 + 0.01, 0.16 + 0.01, 0.16 + 0.04);
            return Free{.mass = m,
                        .inertia = Mat<double, 3>(turn * own.asDiagonal() * turn.transpose()),
                        .centre = {0, 0.3, 0},
                        .velocity = {0.3, 0, 0.2},
                        .spin = {2, 3, -4}};
          }()),
      body<3>(Box{{9.5, 0., -0.1}, {10.5, 0.2, 0.1}},
              {.mass = m, .inertia = {0.013, 0.173, 0.173}, .centre = {10, 0.1, 0}}),
      body<3>(Box{{9.9, 0.2, -0.5}, {10.1, 0.4, 0.5}},
              {.mass = m, .inertia = {0.173, 0.173, 0.013}, .centre = {10, 0.3, 0}}));
  const auto& box = scene.rigid<"a">();
  const double start = energy_of(scene);
  double before = 0;
  for (int k = 0; k < 1000; ++k) {
    step(scene, 1e-3);
    REQUIRE(scene.part<RigidContact>().dissipated >= before - 1e-10 * start);
    before = scene.part<RigidContact>().dissipated;
    REQUIRE(std::abs(energy_of(scene) - start) <= 1e-12 * start);
    REQUIRE(scene.rigid<"c">().velocity.norm() <= 1e-9);
  }
  CHECK(scene.part<RigidContact>().deepest() <= 1e-7);
  CHECK(box.position()[1] == Approx(0.05).epsilon(1e-6));
  CHECK(box.velocity.norm() + box.spin.norm() <= 1e-9);
}

namespace {

/// Two plates, one on the other, 0.2 m wide, above an elastic bed.
template <class T>
auto plates_on_bed(double lower, double upper, const Free& of_upper, double spin = 0) {
  const LinearElastic bed{{.density = 1000, .young = 1e6, .poisson = 0.2}};
  Free below = box_of(0.2, 0.05, 0.3, 0.235, lower), above = of_upper;
  above.mass = upper;
  above.inertia = upper * (0.04 + 0.0025) / 12;
  below.velocity = {0, -0.5, 0};
  below.spin = {0, 0, spin};
  return Scene{PlaneStrain{},
               CartesianGrid<2, T>{{.lower = {0, 0}, .upper = {0.6, 0.5}, .cell = 0.02}},
               Numerics<QuadraticBSpline, Flip, Musl>{},
               bodies(fill(Box{{0., 0.}, {0.6, 0.2}}, bed, {.per_cell = 4})),
               walls(left(roller), right(roller), bottom(fixed)),
               gravity({0, -g}),
               rigid<"lower">(DistanceSurface{Box{{0.2, 0.21}, {0.4, 0.26}}}, below, Friction(20_deg)),
               rigid<"upper">(DistanceSurface{Box{{above.centre[0] - 0.1, above.centre[1] - 0.025},
                                                  {above.centre[0] + 0.1, above.centre[1] + 0.025}}},
                              above, Friction(20_deg)),
               RigidContact{Friction(20_deg)},
               TrackEnergy{}};
}
const Free on_top{.centre = {0.3, 0.285, 0}, .velocity = {0, -0.5, 0}};

}  // namespace

TEST_CASE("A plate on an equal one on an elastic bed goes the way of one plate with the mass of both") {
  test::Validation table("rigid_plates", "one plate");
  {
    const double light = 20, heavy = 20;
    auto both = plates_on_bed<double>(light, heavy, on_top);
    // The other one hovers.
    auto one = plates_on_bed<double>(40, heavy, {.centre = {5, 5, 0}, .force = {0, heavy * g, 0}});
    double travel = 0, off = 0;
    for (int k = 0; k < 300; ++k) {
      step(both, 2e-4);
      step(one, 2e-4);
      const auto& alone = one.rigid<"lower">().displacement;
      travel = std::max(travel, alone.norm());
      off = std::max(off, (both.rigid<"lower">().displacement - alone).norm());
    }
    CAPTURE(light, travel, off);
    CHECK(off <= 1e-9 * travel);
    CHECK(both.rigid<"lower">().impulse[1] > 20);  // more than stops 40 kg of 0.5 m/s
    table.value("20 kg below 20 kg", "displacement of the lower plate", "m",
                both.rigid<"lower">().displacement[1], one.rigid<"lower">().displacement[1]);
  }
}

TEST_CASE(
    "Contact of rigid bodies and matter: the same bits on any number of threads and from a saved state; "
    "float") {
  const int before = threads();
  test::StateBuffer first;
  Free slides = on_top;
  slides.centre = {0.36, 0.3, 0};
  slides.velocity = {0.3, -1, 0};
  const auto make = [&] { return plates_on_bed<double>(10, 30, slides, 1); };
  for (const int n : {1, 3}) {
    set_threads(n);
    auto whole = make(), restored = make();
    const auto steps = [](auto& scene) {
      for (int k = 0; k < 150; ++k) step(scene, 2e-4);
    };
    steps(whole);
    test::StateBuffer(whole).restore(restored);
    steps(whole);
    steps(restored);
    CHECK(std::abs(whole.rigid<"upper">().spin[0]) > 0.1);
    CHECK(whole.part<RigidContact>().dissipated > 0.1);
    const test::StateBuffer end(whole);
    CHECK(test::StateBuffer::first_difference(end, test::StateBuffer(restored)) == "");
    if (n == 1)
      first = end;
    else
      CHECK(test::StateBuffer::first_difference(end, first) == "");
  }
  set_threads(before);

  // In float positions are known to 3e-8 m and velocities to 1e-7.
  auto exact = make();
  auto rounded = plates_on_bed<float>(10, 30, slides, 1);
  for (int k = 0; k < 300; ++k) {
    step(exact, 2e-4);
    step(rounded, 2e-4);
    const auto& a = exact.rigid<"upper">();
    const auto& b = rounded.rigid<"upper">();
    CAPTURE(k, a.displacement.transpose(), b.displacement.transpose(), a.spin[0], b.spin[0]);
    REQUIRE((a.displacement - b.displacement.cast<double>()).norm() <= 1e-4);
    const Vec<double, 2> fall(0, -g * exact.time);
    const Vec<double, 2> p = 10 * rounded.rigid<"lower">().velocity.cast<double>() +
                             30 * b.velocity.cast<double>() - Vec<double, 2>(30 * 0.3, -10 * 0.5 - 30) -
                             40 * fall - rounded.rigid<"lower">().impulse.cast<double>() -
                             b.impulse.cast<double>();
    REQUIRE(p.norm() <= 1e-3);
  }
}

TEST_CASE(
    "Bodies that cannot touch are refused; pairs may have their own friction or pass through each other") {
  const auto scene_of = [](std::vector<RigidPair> pairs, double x, auto shape) {
    const Friction smooth(0.0);
    return Scene{
        PlaneStrain{},
        far_grid<2>(),
        Numerics<QuadraticBSpline, Flip, Usl>{},
        far_matter<2>(),
        walls(bottom(fixed)),
        rigid<"a">(DistanceSurface{shape},
                   Free{.mass = 1, .inertia = 1, .centre = {0, 0, 0}, .velocity = {1, 0, 0}}, smooth),
        rigid(DistanceSurface{[x](const V2& p) { return (p - V2(x, 0)).norm() - 0.5; }},
              Prescribed{[](double) {
                return Triple{0, 0, 0};
              }},
              smooth),
        RigidContact{Friction(0.3), std::move(pairs)}};
  };
  const Ball ball({0., 0.}, 0.5);
  CHECK(throws([&] { (void)scene_of({}, 0.9, ball); }, "RigidContact = a, 1: must not overlap at the start"));
  CHECK(throws(
      [&] {
        (void)scene_of({{"a", "b", {}}}, 1, ball);
      },
      "RigidContact.pairs = b: must be the name or the number of a rigid body of the scene"));
  CHECK(
      throws([&] { (void)scene_of({}, 1, [](const V2& p) { return p.norm() - 0.5; }); },
             "RigidContact = a, 1: one of both must be a shape with contact_segments(), such as Ball, Box or "
             "Polygon"));
  auto passes = scene_of({{"a", "1", {}}}, 1, ball), stops = scene_of({}, 1, ball);
  step(passes, 1e-3);
  step(stops, 1e-3);
  CHECK(passes.rigid<"a">().velocity[0] == 1);
  CHECK(std::abs(stops.rigid<"a">().velocity[0]) <= 1e-12);
}
