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
  const auto& a = std::get<0>(scene.bodies);
  const auto& b = std::get<1>(scene.bodies);
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
  const double energy = scene.ledger.initial_kinetic;
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
  exchange_velocities(Numerics<QuadraticBSpline, Flip, Musl>{}, 0.1);
}

TEST_CASE("Collision: momentum to round-off for unequal bars and all transfers") {
  const auto check = [](auto scene) {
    const double start = total_momentum(scene)[0];
    bool met = false;
    run(scene, {.end = 0.25, .courant = test::courant(scene, 0.4)}, [&](const auto& s) {
      const auto& given = s.contact_impulse;
      met = met || given[0].norm() > 0;
      if (s.contact_tally.nodes > 0) REQUIRE((given[0] + given[1]).norm() <= 1e-13 * start);
    });
    REQUIRE(met);
    CHECK(std::abs(total_momentum(scene)[0] - start) <= 1e-12 * start);
    CHECK(scene.limited == 0);
  };
  check(channel(Numerics<QuadraticBSpline, Apic>{}, 0.05, bar(8000)));
  check(channel(Numerics<QuadraticBSpline, Flip, Usl>{}, 0.05, bar(8000)));
  check(channel(Numerics<QuadraticBSpline, Flip>{.transfer = {.share = 0.5}}, 0.05, bar(200)));
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
  CAPTURE(e.kinetic, e.strain, e.contact, e.residual, scene.ledger.initial_kinetic);
  // What the velocity limit takes from nodes of next to no mass is counted.
  CAPTURE(scene.limited, scene.limited_momentum);
  CHECK((total_momentum(scene) - start).norm() <= 1e-12 * start.norm() + scene.limited_momentum);
  CHECK(scene.limited_momentum <= 1e-6 * start.norm());
  CHECK(e.kinetic + e.strain < scene.ledger.initial_kinetic);
  CHECK(e.contact > 0);
  CHECK(std::abs(velocities(scene)[0] - 1) > 0.1);
}
