// Adhesion: a rigid surface of limited shear strength, as of clay, against strength times area.
#include <arenite/arenite.hpp>

#include "catch.hpp"
#include "meshes.hpp"

using namespace arenite;

namespace {

constexpr double radius = 0.2, length = 0.6, adhesion = 4e3, pushed = 100e3;
const double area = 2 * pi * radius * length;
const LinearElastic ground{{.density = 2000, .young = 2e6, .poisson = 0.3}};

/// A shaft through a ring of ground that presses on it.
template <class Motion>
auto shaft(Motion motion, double strength, const Friction& friction = Friction::no_slip()) {
  auto data = test::triangles({0, 0}, {0.8, length}, 8, 6);
  test::name_region(data, "shaft", [](const auto& x) { return x[0] < radius; });
  test::name_region(data, "soil", [](const auto& x) { return x[0] > radius; });
  return Scene{Axisymmetric{},
               SimplexMesh<2>(data),
               Numerics<LinearSimplex, Flip, Musl>{},
               bodies(fill(Cells("soil"), ground,
                           {.per_cell = 6,
                            .stress =
                                [](const std::array<double, 3>&) {
                                  return std::array<double, 6>{-pushed, -pushed, -pushed, 0, 0, 0};
                                }})),
               walls(right(fixed), top(roller), bottom(roller)),
               gravity({0, -10}),
               rigid(MeshSurface{"shaft", strength}, motion, friction),
               TrackEnergy{}};
}

/// Mean force along the axis on the body from now to `end`.
template <class Scene>
double mean_force(Scene& scene, double end) {
  const double before = scene.rigid().impulse[1], from = scene.time;
  run(scene, {.end = end});
  return (scene.rigid().impulse[1] - before) / (scene.time - from);
}

Prescribed down(double speed) {
  return Prescribed([=](double) { return std::array<double, 3>{0, -speed, 0}; });
}

}  // namespace

TEST_CASE(
    "A shaft that is pulled through the ground carries adhesion times its area, whatever the pressure") {
  const double speed = 0.5;
  double smooth = 0;  // residual of energy without adhesion, J
  for (const double strength : {0.0, adhesion / 100, adhesion}) {
    auto scene = shaft(down(speed), strength);
    run(scene, {.end = 0.05});
    CHECK(mean_force(scene, 0.1) == Approx(strength * area).epsilon(1e-10).margin(1e-9));
    const Energies e = energies(scene);
    if (strength == 0) smooth = e.residual;
    CHECK(std::abs(e.residual - smooth) <= 1e-3 * strength * area * speed * scene.time);
  }
  // A limit that is never reached changes nothing.
  auto strong = shaft(down(speed), 1e12);
  auto unlimited = shaft(down(speed), std::numeric_limits<double>::infinity());
  CHECK(mean_force(strong, 0.02) == mean_force(unlimited, 0.02));
  // The smaller of the two limits friction.
  auto frictional = shaft(down(speed), adhesion, Friction(0.01));
  run(frictional, {.end = 0.05});
  CHECK(mean_force(frictional, 0.1) < 0.01 * 1.1 * pushed * area);
}

TEST_CASE("A shaft sinks by its weight minus adhesion times area, or does not") {
  const double mass = 2 * adhesion * area / 10;  // twice what adhesion carries
  auto sinking = shaft(Guided{.mass = mass}, adhesion);
  run(sinking, {.end = 0.05});
  const double before = sinking.rigid().velocity[1], from = sinking.time;
  run(sinking, {.end = 0.1});
  CHECK((sinking.rigid().velocity[1] - before) / (sinking.time - from) ==
        Approx(-10 + adhesion * area / mass).epsilon(1e-9));
  auto held = shaft(Guided{.mass = mass / 4}, adhesion);
  run(held, {.end = 0.5});
  CHECK(std::abs(held.rigid().displacement[1]) < 5e-3);
  auto without = shaft(Guided{.mass = mass / 4}, 0);
  run(without, {.end = 0.1});
  CHECK(without.rigid().displacement[1] == Approx(-0.05).epsilon(0.02));
}

TEST_CASE("A shear strength below zero is refused") {
  REQUIRE_THROWS_WITH(shaft(down(1), -1), "MeshSurface.shear_strength = -1: must be >= 0 Pa");
  REQUIRE_THROWS_WITH(shaft(down(1), std::nan("")), "MeshSurface.shear_strength = nan: must be >= 0 Pa");
}
