// Rigid bodies that rotate, in scenes: a tilted box dropped on sand, and a cylinder that rolls down an
// elastic bed. What the body gains the matter loses; rolling is compared with the closed form.
#include <arenite/arenite.hpp>

#include "catch.hpp"
#include "state_buffer.hpp"
#include "validation.hpp"

using namespace arenite;

namespace {

constexpr double g = 9.81;

/// A box of 0.16 x 0.1 m about (0.3, 0.3), tilted by 25 degrees.
double tilted_box(const Vec<double, 2>& x) {
  const double c = std::cos(25_deg), s = std::sin(25_deg), u = x[0] - 0.3, v = x[1] - 0.3;
  const double out = std::abs(c * u + s * v) - 0.08, up = std::abs(c * v - s * u) - 0.05;
  return std::min(std::max(out, up), 0.0) + std::hypot(std::max(out, 0.0), std::max(up, 0.0));
}
constexpr double box_mass = 30, box_inertia = box_mass * (0.16 * 0.16 + 0.1 * 0.1) / 12;

auto box_on_sand() {
  const MohrCoulomb<> sand{{.density = 1500, .young = 2e6, .poisson = 0.3, .friction = 35_deg}};
  return Scene{PlaneStrain{},
               CartesianGrid<2>{{.lower = {0, 0}, .upper = {0.6, 0.5}, .cell = 0.02}},
               Numerics<QuadraticBSpline, Flip, Musl>{},
               bodies(fill(Box{{0., 0.}, {0.6, 0.2}}, sand, {.per_cell = 4})),
               walls(left(roller), right(roller), bottom(fixed)),
               gravity({0, -g}),
               rigid<"box">(DistanceSurface{[](const auto& x) { return tilted_box(x); }},
                            Free{.mass = box_mass,
                                 .inertia = box_inertia,
                                 .centre = {0.3, 0.3, 0},
                                 .velocity = {0.4, -2, 0},
                                 .spin = {0, 0, -3}},
                            Friction(20_deg)),
               TrackEnergy{}};
}

/// A cylinder of radius 0.4 m and 500 kg/m on a bed 0.1 m thick; gravity is tilted instead of the bed.
auto rolling(double slope, double young) {
  const double radius = 0.4, mass = 500, cell = 0.02;
  const Vec<double, 2> centre(0.5, 0.1 + radius + cell / 2);
  const LinearElastic bed{{.density = 2000, .young = young, .poisson = 0.2}};
  return Scene{
      PlaneStrain{},
      CartesianGrid<2>{{.lower = {0, 0}, .upper = {1.5, 0.16}, .cell = cell}},
      Numerics<QuadraticBSpline, Apic, Usl>{},
      bodies(fill(Box{{0., 0.}, {1.5, 0.1}}, bed, {.per_cell = 4})),
      walls(left(roller), right(roller), bottom(fixed)),
      gravity({g * std::sin(slope), -g * std::cos(slope)}),
      rigid(DistanceSurface{[=](const auto& x) { return (x - centre).norm() - radius; }},
            Free{.mass = mass, .inertia = mass * square(radius) / 2, .centre = {centre[0], centre[1], 0}},
            Friction(35_deg)),
      TrackEnergy{}};
}

}  // namespace

TEST_CASE(
    "A tilted box on sand gains what the sand loses, also of angular momentum; energy is accounted for") {
  auto scene = box_on_sand();
  const auto& box = scene.rigid<"box">();
  const Vec<double, 2> start = momentum(scene.body()), fall(0, -g * mass(scene.body()));
  const double turning = box.motion.angular_momentum()[0];
  double summed = 0;
  run(scene, {.end = 0.15}, [&](const auto& s) {
    const double scale = -fall[1] * s.time + box.impulse.norm() + s.wall_impulse.norm();
    const Vec<double, 2> sand = momentum(s.body()) - start - s.time * fall - s.wall_impulse;
    REQUIRE((sand + box.impulse).norm() <= 1e-12 * scale);
    const Vec<double, 2> own = box_mass * (box.velocity - Vec<double, 2>(0.4, -2 - g * s.time));
    REQUIRE((own - box.impulse).norm() <= 1e-12 * scale);
    REQUIRE(std::abs(box.motion.angular_momentum()[0] - turning - box.angular_impulse[0]) <= 1e-12 * scale);
    REQUIRE(std::abs(box.motion.angular_momentum()[0] - box_inertia * box.spin[0]) <= 1e-14 * scale);
    summed += box.torque[0] * s.time_step;
    REQUIRE(std::abs(summed - box.angular_impulse[0]) <= 1e-12 * scale);
    REQUIRE((box.position() - Vec<double, 2>(0.3, 0.3) - box.displacement).norm() <= 1e-15);
  });
  // It lands on its lower edge, which turns it flat, and comes to rest in the sand.
  CHECK(box.contact_nodes > 4);
  CHECK(box.position()[1] < 0.27);
  CHECK(box.velocity.norm() < 0.3);
  const Energies e = energies(scene);
  const double put_in = scene.part<TrackEnergy>().initial_kinetic + e.external;
  CAPTURE(box.position().transpose(), box.orientation.angle(), box.velocity.transpose(), box.spin[0],
          e.residual / put_in);
  CHECK(std::abs(e.residual) <= 0.02 * put_in);
}

TEST_CASE(
    "A body that rotates continues with the same bits once its state is restored, on any number of threads") {
  const int before = threads();
  test::StateBuffer first;
  for (const int n : {1, 3}) {
    set_threads(n);
    auto whole = box_on_sand(), restored = box_on_sand();
    const auto steps = [](auto& scene) {
      for (int k = 0; k < 60; ++k) step(scene, 2e-4);
    };
    for (int k = 0; k < 4; ++k) steps(whole);
    REQUIRE(whole.rigid<"box">().contact_nodes > 0);
    test::StateBuffer(whole).restore(restored);
    steps(whole);
    steps(restored);
    const test::StateBuffer end(whole);
    CHECK(test::StateBuffer::first_difference(end, test::StateBuffer(restored)) == "");
    if (n == 1)
      first = end;
    else
      CHECK(test::StateBuffer::first_difference(end, first) == "");
  }
  set_threads(before);
}

TEST_CASE("A cylinder rolls down an elastic bed with 2/3 g sin", "[heavy]") {
  const double slope = 20_deg, end = 0.6, exact = 2.0 / 3 * g * std::sin(slope);
  auto scene = rolling(slope, 3e6);
  const auto& body = scene.rigid();
  test::Validation table("rolling");
  double at = 0, speed = 0, spin = 0;
  run(scene, {.end = end, .courant = 0.4}, [&](const auto& s) {
    if (s.time <= end / 2) at = s.time, speed = body.velocity[0], spin = body.spin[0];
  });
  const double found = (body.velocity[0] - speed) / (scene.time - at);
  const double turned = (body.spin[0] - spin) / (scene.time - at);
  table.value("cylinder on a bed of 5 cells", "acceleration over the second half", "m/s2", found, exact);
  table.value("same", "radius times angular acceleration", "m/s2", -0.4 * turned, exact);
  CAPTURE(found / exact, -0.4 * turned / exact);
  CHECK(std::abs(found / exact - 1) <= 0.03);
  CHECK(std::abs(-0.4 * turned / exact - 1) <= 0.05);
}
