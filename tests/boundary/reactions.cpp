// Reactions of walls, and walls that move as prescribed, against balances of momentum and Hooke's law.
#include <arenite/arenite.hpp>

#include "catch.hpp"

using namespace arenite;

namespace {

const LinearElastic rubber{{.density = 1000, .young = 1e6, .poisson = 0}};

template <class... Parts>
auto block(const Box<2>& box, const FillOptions& options, const Parts&... parts) {
  return Scene{PlaneStrain{},
               CartesianGrid<2>{{.lower = {0, 0}, .upper = {1, 1}, .cell = 0.1}},
               Numerics<QuadraticBSpline, Apic, Usl>{},
               bodies(fill(box, rubber, options)),
               parts...,
               Reactions{}};
}
auto pulled(const Walls& held, std::array<double, 2> g, const Box<2>& box = {{0, 0}, {1, 1}}) {
  return block(box, {.per_cell = 4}, held, gravity({g[0], g[1]}));
}

}  // namespace

TEST_CASE("A block at rest: the floor carries its weight, the walls nothing") {
  const double g = 9.81;
  auto scene = block({{0, 0}, {1, 0.6}}, {.per_cell = 4, .stress = Geostatic{.surface = 0.6, .k0 = 0}},
                     walls(left(roller), right(roller), bottom(roller)), gravity({0, -g}));
  run(scene, {.end = 0.1});
  const double weight = mass(scene.body()) * g;
  const auto floor = reaction(scene, "bottom");
  CHECK(std::abs(floor.force[1] / weight - 1) <= 0.01);
  CHECK(std::abs(floor.impulse[1] - (weight * scene.time + momentum(scene.body())[1])) <=
        1e-12 * weight * scene.time);
  CHECK(floor.force[0] == 0);
  CHECK(reaction(scene, "left").impulse.norm() <= 1e-12 * weight * scene.time);
  try {
    reaction(scene, "top");
    FAIL("nothing thrown");
  } catch (const error& e) {
    CHECK(std::string(e.what()) == "reaction: wall = top: must be one of: left, right, bottom");
  }
}

TEST_CASE("At corners each wall gives along the directions that it blocks; what several block, the first") {
  const auto held = walls(bottom(roller), left(fixed), named("ramp", right(symmetry({2, 1, 0}))),
                          named("roof", where([](const auto& x) { return x[1] == 1; }, fixed)));
  auto scene = pulled(held, {3, -2});
  for (int k = 0; k < 5; ++k) step(scene, 1e-3);
  const auto floor = reaction(scene, "bottom"), wall = reaction(scene, "left"),
             ramp = reaction(scene, "ramp"), roof = reaction(scene, "roof");
  CHECK(floor.impulse[0] == 0);
  CHECK(std::abs(ramp.impulse[0] - 2 * ramp.impulse[1]) <= 1e-12 * ramp.impulse.norm());
  CHECK((floor.impulse + wall.impulse + ramp.impulse + roof.impulse - scene.wall_impulse).norm() <=
        1e-12 * scene.wall_impulse.norm());
  for (const auto& r : {floor, wall, ramp, roof}) CHECK(r.impulse.norm() > 0.01);
  // Momentum theorem with all walls.
  const Vec<double, 2> given = mass(scene.body()) * scene.time * Vec<double, 2>(3, -2);
  CHECK((momentum(scene.body()) - given - scene.wall_impulse).norm() <= 1e-12 * given.norm());
}

TEST_CASE("A piston presses a bar: reaction E A strain at both ends, work E A strain^2 L / 2") {
  const double strain = 1e-5, length = 1, width = 0.2, young = 1e6, rise = 3;  // s; a period takes 0.13 s
  const auto speed = [=](double t) {
    const double s = t / rise;
    return strain * length * 30 * s * s * (1 - s) * (1 - s) / rise;  // integrates to strain * length
  };
  auto scene = block({{0, 0}, {length, width}}, {.per_cell = 4}, walls(left(roller), bottom(roller)),
                     driven(right(roller), {-1, 0}, speed), TrackEnergy{});
  run(scene, {.end = rise});
  const double force = young * width * strain;
  CHECK(std::abs(reaction(scene, "right").force[0] / -force - 1) <= 0.01);
  CHECK(std::abs(reaction(scene, "left").force[0] / force - 1) <= 0.01);
  CHECK(std::abs(energies(scene).external / (force * strain * length / 2) - 1) <= 0.01);
  CHECK(std::abs(energies(scene).residual) <= 0.01 * energies(scene).external);
  CHECK(reaction(scene, "right").force[1] == 0);  // normal only
}
