// Contact of a rigid body at the material points: momentum, where it acts, friction, depth of penetration.
#include <arenite/arenite.hpp>

#include "catch.hpp"
#include "courant.hpp"
#include "meshes.hpp"
#include "state_buffer.hpp"

using namespace arenite;

namespace {

using P = Vec<double, 2>;
constexpr double g = 9.81;

struct Setup {
  double cell = 0.025;
  Box<2> block{{0., 0.}, {0.1, 0.2}};
  std::array<double, 2> size{0.1, 0.3};  ///< of the grid, m
  bool in_column = true;                 ///< between smooth walls, on a fixed bottom
  double damping = 0;                    ///< 1/s
  double fall = 0;                       ///< gravity, m/s2
  std::array<double, 3> velocity{};      ///< of the block, m/s
};

const LinearElastic rubber{{.density = 1000, .young = 1e6, .poisson = 0.3}};

/// A block on a grid, and a rigid body.
template <class Distance>
auto block_and_body(const Setup& s, Distance distance, Guided motion) {
  const Walls column = walls(left(roller), right(roller), bottom(fixed));
  return Scene{PlaneStrain{},
               CartesianGrid<2>{{.lower = {0, 0}, .upper = s.size, .cell = s.cell}},
               Numerics<QuadraticBSpline, Flip, Usl>{},
               bodies(fill(s.block, rubber, {.per_cell = 9, .velocity = s.velocity})),
               s.in_column ? column : walls(bottom(fixed)),
               gravity({0, -s.fall}),
               ViscousDamping{s.damping},
               rigid(DistanceSurface{distance}, motion, Friction(20_deg), PointContact{}),
               TrackEnergy{}};
}

/// Stays where it is.
Guided heavy(double fall = 0) { return {.mass = 1e9, .load = 1e9 * fall}; }
auto plate_above(double y) {
  return [y](const P& x) { return y - x[1]; };
}
auto plate_below(double y) {
  return [y](const P& x) { return x[1] - y; };
}

/// A plate rests on a column: how far its face is above the upper face of the evenly strained column, in
/// cells.
double rest_above(double cell, double load) {
  const double height = 0.2, width = 0.1;
  auto scene = block_and_body({.cell = cell, .damping = 200}, plate_above(height + cell),
                              Guided{.mass = 5, .load = -load});
  run(scene, {.end = 0.2, .courant = test::courant(scene, 0.5)});
  const auto& plate = scene.rigid();
  CHECK(std::abs(plate.force[1] - load) < 2e-3 * load);
  CHECK(plate.at_points.deepest < 1e-5 * cell);
  return (height + cell + plate.displacement[1] - height * (1 - load / (width * rubber.wave_modulus()))) /
         cell;
}

}  // namespace

TEST_CASE("Contact at points acts where the points are: no gap, and half a point's size inside") {
  // Nine points a cell lie 1/6 of a cell below the face. What is left is the strain there.
  CHECK(std::abs(rest_above(0.025, 1000) + 1. / 6) < 2e-3);
  CHECK(std::abs(rest_above(0.0125, 1000) + 1. / 6) < 2e-3);
}

TEST_CASE("wherever the surface is in the cells") {
  constexpr double cell = 0.025, speed = 2;
  for (const double part : {0.01, 0.24, 0.49, 0.76, 0.99}) {
    const double surface = (3 + part) * cell;
    auto scene = block_and_body(
        {.cell = cell, .block = {{0., 5 * cell}, {0.1, 0.2}}, .in_column = false, .velocity = {0, -speed, 0}},
        plate_below(surface), heavy());
    double lowest = 0;
    while (scene.contact_tally.nodes == 0) {
      lowest = cell;
      for (const P& x : scene.body().points.position) lowest = std::min(lowest, (x[1] - surface) / cell);
      REQUIRE(lowest > -0.1);
      step(scene, 0.01 * cell / speed);
    }
    CAPTURE(part);
    CHECK(std::abs(lowest) <= 0.0101);  // the step in which it would come to lie inside
  }
}

TEST_CASE("A block and a guided body: momentum to round-off, energy accounted for, hardly any penetration") {
  for (const double mass : {1.0, 10.0, 1e4}) {
    CAPTURE(mass);
    auto scene = block_and_body(
        {.block = {{0.05, 0.15}, {0.15, 0.25}},
         .size = {0.4, 0.6},
         .in_column = false,
         .velocity = {0.5, 3, 0}},
        [](const P& x) { return (x - P(0.16, 0.37)).norm() - 0.1; }, Guided{.mass = mass, .velocity = -2});
    const auto& ball = scene.rigid();
    const P start = momentum(scene.body());
    const double put_in = 1000 * 0.01 * (9 + 0.25) / 2 + mass * 2;
    run(scene, {.end = 0.02}, [&](const auto& s) {
      const double scale = start.norm() + mass * 2;
      REQUIRE((momentum(s.body()) - start + ball.impulse).norm() <= 1e-13 * scale);
      REQUIRE(std::abs(mass * (ball.velocity[1] + 2) - ball.impulse[1]) <= 1e-13 * scale);
      REQUIRE(std::abs(ball.contact_impulse(0)[1] + ball.force[1] * s.time_step) <= 1e-13 * scale);
    });
    CHECK(ball.impulse[1] > 5);
    CHECK(ball.at_points.deepest < 0.03 * 0.025);
    const Energies e = energies(scene);
    CHECK(e.contact > 0);
    CHECK(e.residual < 1e-3 * put_in);  // FLIP loses energy in such a collision; none comes from nothing
  }
}

TEST_CASE("Friction: a block slides with mu g, or stays") {
  const double mu = std::tan(20_deg);
  Setup s{.block = {{0.1, 0.1}, {0.3, 0.15}}, .size = {1, 0.25}, .in_column = false, .fall = g};
  const double face = 0.1 + 0.025 / 6;  // the lowest points touch it
  s.velocity = {1, 0, 0};
  auto slides = block_and_body(s, plate_below(face), heavy(g));
  run(slides, {.end = 0.15, .courant = 1});
  const P impulse = slides.rigid().impulse, left = momentum(slides.body()) / mass(slides.body());
  CHECK(std::abs(impulse[0] / impulse[1] + mu) < 1e-9);  // all points slip
  CHECK(std::abs(left[0] - (1 - mu * g * 0.15)) < 5e-3);
  // Once it stands it stays.
  s.velocity = {0.1, 0, 0};
  auto stays = block_and_body(s, plate_below(face), heavy(g));
  run(stays, {.end = 0.15, .courant = 1});
  double travel = 0;
  const auto before = static_cast<double>(stays.body().points.size());
  for (const P& x : stays.body().points.position) travel += x[0] / before;
  CHECK(std::abs(travel - 0.2 - square(0.1) / (2 * mu * g)) < 2e-4);
}

TEST_CASE("Contact at points: the same bits on any number of threads") {
  const auto after = [](int n) {
    set_threads(n);
    auto scene = block_and_body(
        {.cell = 0.00625, .velocity = {0, 1, 0}},
        [](const P& x) { return (x - P(0.03, 0.235)).norm() - 0.04; }, Guided{.mass = 3, .velocity = -5});
    for (int k = 0; k < 30; ++k) step(scene, 0.9 * stable_step(scene));
    REQUIRE(scene.rigid().contact_nodes > 20);
    return test::StateBuffer(scene);
  };
  const int before = threads();
  const auto one = after(1);
  for (const int n : {2, 3}) CHECK(test::StateBuffer::first_difference(after(n), one) == "");
  set_threads(before);
}

TEST_CASE("A ball that turns, among tetrahedra: what it gains the material loses, angular momentum too") {
  using V = Vec<double, 3>;
  const double radius = 0.15, mass_of_ball = 20, inertia = 0.4 * mass_of_ball * square(radius);
  const V centre(0.3, 0.52, 0.28);
  Scene scene{ThreeDimensional{}, SimplexMesh<3>(test::tetrahedra({0, 0, 0}, {0.6, 0.8, 0.6}, {4, 5, 4})),
              Numerics<LinearSimplex, Flip, Usl>{},
              bodies(fill(Box{{0.15, 0., 0.15}, {0.45, 0.35, 0.45}}, rubber, {.per_cell = 10})),
              rigid(DistanceSurface{[=](const V& x) { return (x - centre).norm() - radius; }},
                    Free{.mass = mass_of_ball,
                         .inertia = inertia,
                         .centre = {centre[0], centre[1], centre[2]},
                         .velocity = {0, -3, 0},
                         .spin = {0, 5, 20}},
                    Friction(20_deg), PointContact{})};
  const auto& ball = scene.rigid();
  const auto turning = [&] {
    V sum = V::Zero();
    const auto& points = scene.body().points;
    for (std::size_t p = 0; p < points.size(); ++p)
      sum += points.mass[p] * (V(points.position[p]) - centre).cross(V(points.velocity[p]));
    return sum;
  };
  const V spin = ball.motion.angular_momentum();
  for (int k = 0; k < 60; ++k) {
    const V place = ball.position();
    step(scene, 0.5 * stable_step(scene));
    REQUIRE((momentum(scene.body()) + ball.impulse).norm() <= 1e-12 * mass_of_ball * 3);
    REQUIRE((ball.motion.angular_momentum() - spin - ball.angular_impulse).norm() <= 1e-12 * spin.norm());
    V moment = V::Zero();
    for (const auto& t : ball.touched_nodes) moment -= (scene.mesh.position(t.node) - place).cross(t.impulse);
    REQUIRE((moment - ball.torque * scene.time_step).norm() <= 1e-12 * mass_of_ball);
  }
  CHECK(ball.impulse[1] > 10);
  CHECK(std::abs(ball.angular_impulse[2]) > 0.05);
  CHECK(ball.at_points.deepest < 0.01);
  CHECK(turning().norm() > 0);
}
