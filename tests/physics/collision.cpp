// Two elastic bars collide in a smooth channel. Equal bars exchange their velocities after 2 L / c
// (one-dimensional wave theory, e.g. Timoshenko and Goodier, Theory of Elasticity, sec. 172); momentum is
// kept whatever the bars.
#include <arenite/arenite.hpp>

#include "catch.hpp"
#include "courant.hpp"
#include "meshes.hpp"

using namespace arenite;

namespace {

constexpr double speed = 0.5, length = 0.5;

LinearElastic bar(double density = 1000) {
  return LinearElastic{{.density = density, .young = 1e6, .poisson = 0.2}};
}

template <class Scene>
Vec<double, 2> total_momentum(const Scene& scene) {
  Vec<double, 2> sum = Vec<double, 2>::Zero();
  scene.for_each_body([&](const auto& body, const auto&) { sum += momentum(body); });
  return sum;
}

template <class Scene>
std::array<double, 2> velocities(const Scene& scene) {
  const auto& a = scene.template body<0>();
  const auto& b = scene.template body<1>();
  return {momentum(a)[0] / mass(a), momentum(b)[0] / mass(b)};
}

/// The bars lie one cell apart; the first moves towards the second.
template <class N>
auto channel(N numerics, double h, const LinearElastic& second = bar()) {
  return Scene{
      PlaneStrain{},
      CartesianGrid<2>{{.lower = {0, 0}, .upper = {1.5, h}, .cell = h}},
      numerics,
      bodies(fill(Box{{0.1, 0.}, {0.1 + length, h}}, bar(), {.per_cell = 4, .velocity = {speed, 0, 0}}),
             fill(Box{{0.1 + length + 2 * h, 0.}, {0.1 + 2 * length + 2 * h, h}}, second, {.per_cell = 4})),
      walls(bottom(roller), top(roller)),
      Coulomb{Friction::frictionless()},
      TrackEnergy{}};
}

template <class N>
void exchange_velocities(N numerics, double courant) {
  const double h = 0.025;
  auto scene = channel(numerics, h);
  const double start = total_momentum(scene)[0];
  const double wave = std::sqrt(bar().wave_modulus() / bar().density());
  const double energy = scene.template part<TrackEnergy>().initial_kinetic;
  double first = -1, last = -1, worst = 0, residual = 0;
  const double end = 2 * h / speed + 4 * length / wave;
  run(scene, {.end = end, .courant = test::courant(scene, courant)}, [&](const auto& s) {
    if (s.contact_tally.nodes > 0) {
      if (first < 0) first = s.time;
      last = s.time;
    }
    worst = std::max(worst, std::abs(total_momentum(s)[0] - start) / start);
    residual = std::max(residual, std::abs(energies(s).residual) / energy);
  });
  const auto v = velocities(scene);
  CAPTURE(v[0], v[1], (last - first) / (2 * length / wave));
  CHECK(worst <= 1e-13);
  // The bars part in steps of a cell's crossing, not of a wave's: what transfers and nodes take shows in the
  // rebound.
  CHECK(residual <= 0.2);
  CHECK(std::abs(v[0]) <= 0.1 * speed);
  CHECK(std::abs(v[1] - speed) <= 0.1 * speed);
  // While both bars have mass at a node their fields touch: from up to a cell's distance on.
  CHECK(last - first >= 2 * length / wave);
  CHECK(last - first <= 3 * length / wave + 2 * h / speed);
  CHECK(std::abs(energies(scene).contact) <= 0.1 * energy);
}

}  // namespace

TEST_CASE("Collision: equal bars exchange their velocities") {
  exchange_velocities(Numerics<QuadraticBSpline, Flip, Usl>{}, 0.4);
  exchange_velocities(Numerics<QuadraticBSpline, Apic, Usl>{}, 0.4);
  exchange_velocities(Numerics<QuadraticBSpline, Flip, Musl>{}, 0.4);
}

TEST_CASE("Collision: momentum to round-off for unequal bars and all transfers") {
  const auto check = [](auto scene) {
    const double start = total_momentum(scene)[0];
    bool met = false;
    double before = momentum(scene.template body<0>())[0];
    run(scene, {.end = 0.25, .courant = test::courant(scene, 0.4)}, [&](const auto& s) {
      const auto force = contact_force<0>(s);
      met = met || force.norm() > 0;
      REQUIRE((force + contact_force<1>(s)).norm() * s.time_step <= 1e-13 * start);
      // Nothing but contact acts along the channel.
      const double now = momentum(s.template body<0>())[0];
      REQUIRE(std::abs(now - before - force[0] * s.time_step) <= 1e-12 * start);
      before = now;
    });
    REQUIRE(met);
    CHECK(std::abs(total_momentum(scene)[0] - start) <= 1e-12 * start);
    CHECK(scene.limited == 0);
  };
  check(channel(Numerics<QuadraticBSpline, Apic>{}, 0.05, bar(8000)));
  check(channel(Numerics<QuadraticBSpline, Flip, Usl>{}, 0.05, bar(8000)));
  check(channel(Numerics<QuadraticBSpline, Flip>{.transfer = {.fraction = 0.5}}, 0.05, bar(200)));
}

TEST_CASE("Collision: oblique, with friction, in free flight: linear momentum to round-off, energy falls") {
  Scene scene{
      PlaneStrain{},
      CartesianGrid<2>{{.lower = {-1, -1}, .upper = {1, 1}, .cell = 0.05}},
      Numerics<QuadraticBSpline, Apic>{},
      bodies(fill(Inside{[](const auto& x) { return (x - Vec<double, 2>(-0.3, -0.05)).norm() - 0.2; }}, bar(),
                  {.per_cell = 4, .velocity = {1, 0.1, 0}}),
             fill(Inside{[](const auto& x) { return (x - Vec<double, 2>(0.2, 0.1)).norm() - 0.2; }},
                  bar(3000), {.per_cell = 4, .velocity = {-0.2, 0, 0}})),
      Coulomb{Friction(20 * pi / 180)},
      TrackEnergy{}};
  const Vec<double, 2> start = total_momentum(scene);
  run(scene, {.end = 0.3, .courant = test::courant(scene, 0.5)});
  const Energies e = energies(scene);
  CAPTURE(e.kinetic, e.strain, e.contact, e.residual, scene.template part<TrackEnergy>().initial_kinetic);
  // The momentum that the velocity limit takes from nodes of nearly zero mass is counted.
  CAPTURE(scene.limited, scene.limited_momentum);
  CHECK((total_momentum(scene) - start).norm() <= 1e-12 * start.norm() + scene.limited_momentum);
  CHECK(scene.limited_momentum <= 1e-6 * start.norm());
  CHECK(e.kinetic + e.strain < scene.template part<TrackEnergy>().initial_kinetic);
  CHECK(e.contact > 0);
  CHECK(std::abs(velocities(scene)[0] - 1) > 0.1);
}

namespace {

constexpr double radius = 0.2;

auto disc(double x, double y) {
  return Inside{[=](const auto& p) { return (p - Vec<double, 2>(x, y)).norm() - radius; }};
}

/// Two elastic discs approach each other with equal speeds, their centres `offset` apart across the way.
template <class Mesh, class N>
auto two_discs(Mesh mesh, N numerics, int per_cell, double offset, const Friction& friction) {
  return Scene{
      PlaneStrain{},
      std::move(mesh),
      numerics,
      bodies(fill(disc(-0.25, -offset / 2), bar(), {.per_cell = per_cell, .velocity = {speed, 0, 0}}),
             fill(disc(0.25, offset / 2), bar(), {.per_cell = per_cell, .velocity = {-speed, 0, 0}})),
      Coulomb{friction},
      TrackEnergy{}};
}

CartesianGrid<2> squares() {
  return CartesianGrid<2>{{.lower = {-0.7, -0.5}, .upper = {0.7, 0.5}, .cell = 0.05}};
}

/// Runs an impact of elastic bodies: energy never grows by more than `gain`, contact never gives any, and the
/// balance closes within `residual`, all as shares of the energy at the start. Returns what is left of it.
template <class Scene>
double impact(Scene scene, double courant, double gain, double residual) {
  const double start = scene.template part<TrackEnergy>().initial_kinetic;
  double most = 0, last = 0, gift = 0, off = 0;
  bool met = false;
  run(scene, {.end = 0.3, .courant = test::courant(scene, courant)}, [&](const auto& s) {
    const Energies e = energies(s);
    last = (e.kinetic + e.strain) / start;
    most = std::max(most, last);
    gift = std::min(gift, e.contact / start);
    off = std::max(off, std::abs(e.residual) / start);
    met = met || s.contact_tally.nodes > 0;
  });
  CAPTURE(last);
  CHECK(met);
  CHECK(most <= 1 + gain);
  CHECK(gift >= -1e-4);
  CHECK(off <= residual);
  return last;
}

}  // namespace

TEST_CASE("Collision: FLIP and MUSL make no energy of an impact, and the balance closes") {
  const Numerics<QuadraticBSpline, Flip, Musl> numerics;
  for (const int per_cell : {4, 9}) {
    CHECK(impact(two_discs(squares(), numerics, per_cell, 0, Friction::frictionless()), 0.5, 1e-3, 0.05) >
          0.7);
    impact(two_discs(squares(), numerics, per_cell, 0.2, Friction(0.3)), 0.5, 1e-3, 0.05);
    impact(two_discs(squares(), numerics, per_cell, 0.2, Friction::no_slip()), 0.5, 1e-3, 0.05);
  }
  impact(two_discs(squares(), numerics, 4, 0.2, Friction(0.3)), 0.1, 1e-3, 0.01);
}

TEST_CASE("Collision: the same on triangles") {
  const auto mesh = SimplexMesh<2>(test::triangles({-0.7, -0.5}, {0.7, 0.5}, 28, 20));
  CHECK(impact(two_discs(mesh, Numerics<LinearSimplex, Flip, Musl>{}, 6, 0, Friction::frictionless()), 0.5,
               0.02, 0.05) > 0.9);
}

TEST_CASE("Collision: the same against a rigid surface") {
  const auto at_rest = Prescribed{[](double) { return std::array<double, 3>{}; }};
  for (const int per_cell : {4, 9})
    CHECK(impact(
              Scene{PlaneStrain{}, squares(), Numerics<QuadraticBSpline, Flip, Musl>{},
                    bodies(fill(disc(0, -0.05), bar(), {.per_cell = per_cell, .velocity = {0.1, -speed, 0}})),
                    rigids(rigid(DistanceSurface{[](const auto& x) { return x[1] + 0.3; }}, at_rest,
                                 Friction(0.3))),
                    TrackEnergy{}},
              0.5, 1e-3, 0.05) > 0.7);
}

TEST_CASE("Collision: contact pushes no body off its wall") {
  // Two wedges on a smooth ground: the faces in contact are steep, and push one down and one up.
  const auto along = [](const auto& x) { return x[0] + x[1] / 2; };
  Scene scene{PlaneStrain{},
              CartesianGrid<2>{{.lower = {0, 0}, .upper = {0.8, 0.3}, .cell = 0.05}},
              Numerics<QuadraticBSpline, Flip, Musl>{},
              bodies(fill(Inside{[=](const auto& x) {
                            return std::max({0.1 - x[0], along(x) - 0.35, x[1] - 0.2});
                          }},
                          bar(), {.per_cell = 4, .velocity = {speed, 0, 0}}),
                     fill(Inside{[=](const auto& x) {
                            return std::max({0.4 - along(x), x[0] - 0.6, x[1] - 0.2});
                          }},
                          bar(), {.per_cell = 4})),
              walls(bottom(roller)),
              Coulomb{Friction::frictionless()}};
  const Vec<double, 2> start = total_momentum(scene);
  double pushed = 0;
  run(scene, {.end = 0.2, .courant = 0.5}, [&](const auto& s) {
    for (const auto& c : s.constraints) {
      for (const auto& field : s.fields) {
        REQUIRE(field.velocity[c.node][1] == 0);
        REQUIRE(field.mapped[c.node][1] == 0);
      }
      for (const auto& pair : s.template part<Coulomb>().pairs)
        if (pair.node == c.node) pushed += std::abs(pair.impulse[1]);
    }
    REQUIRE((total_momentum(s) - start - s.wall_impulse).norm() <= 1e-12 * start.norm() + s.limited_momentum);
  });
  CHECK(pushed > 0.01 * start.norm());
}
