// Rigid bodies at the walls of the mesh: a run reports one that passes a wall or leaves the mesh; with
// `RigidContact.walls` walls stop them, with friction, as closed forms say.
#include <arenite/arenite.hpp>
#include <arenite/tiles.hpp>
#include <cstdlib>

#include "../run/said.hpp"
#include "catch.hpp"

using namespace arenite;
using namespace arenite::test;

namespace {

constexpr double g = 9.81, radius = 0.2, kg = 30, cell = 0.1;

struct Thrown {
  std::array<double, 3> at{1, 1, 0}, velocity{}, gravity{0, -g, 0};
  std::optional<Friction> walls{};
};

/// A disc in a mesh of 2 x 2 m over a block of rubber in a corner: below a fixed wall, on the left a smooth one, above a frictional
/// one, on the right none.
template <class Mesh, class... Portion>
auto world(const Thrown& t, const Mesh& mesh, const Portion&... portion) {
  return Scene{
      PlaneStrain{},
      mesh,
      Numerics<QuadraticBSpline, Flip, Usl>{},
      bodies(fill(Box{{1.7, 0.}, {2., 0.2}}, LinearElastic{{.density = 1000, .young = 1e5, .poisson = 0.2}},
                  {.per_cell = 4})),
      walls(bottom(fixed), left(roller)),
      frictional(top(), Friction(10_deg)),
      gravity(t.gravity),
      rigid<"disc">(
          DistanceSurface{Ball({t.at[0], t.at[1]}, radius)},
          Free{.mass = kg, .inertia = kg * square(radius) / 2, .centre = t.at, .velocity = t.velocity},
          Friction(0)),
      RigidContact{.friction = Friction(0), .walls = t.walls},
      portion...};
}
CartesianGrid<2> grid() { return CartesianGrid<2>{{.lower = {0, 0}, .upper = {2, 2}, .cell = cell}}; }
auto world(const Thrown& t) { return world(t, grid()); }
/// The time that a warning names, s.
double time_of(const std::string& text) {
  REQUIRE_THAT(text, Catch::StartsWith("t = "));
  return std::strtod(text.c_str() + 4, nullptr);
}
/// Runs to `end`; what was warned of.
template <class S>
std::vector<std::string> warned(S& scene, double end) {
  return said([&] { run(scene, {.end = end}); }).warnings;
}

}  // namespace

TEST_CASE(
    "A body that falls through a wall is reported, then that it has left the mesh, once each and in time") {
  auto scene = world({});
  const double longest = 0.5 * stable_step(scene);
  const auto texts = warned(scene, 1);
  REQUIRE(texts.size() == 2);
  CHECK_THAT(texts[0], Catch::Contains("s: rigid body disc has passed the wall at the bottom by 0.025 m, a "
                                       "quarter of a cell, at (1, -0.025) m: walls hold matter alone; "
                                       "RigidContact.walls"));
  CHECK(std::abs(time_of(texts[0]) - std::sqrt(2 * (1 - radius + cell / 4) / g)) <= 1.5 * longest);
  CHECK_THAT(texts[1], Catch::Contains("s: rigid body disc has left the mesh: its centre is at (1, -0.2"));
  CHECK(std::abs(time_of(texts[1]) - std::sqrt(2 * (1 + radius) / g)) <= 1.5 * longest);
}

TEST_CASE(
    "Each kind of wall is reported by its name; an open side and one that is crossed at the start are not") {
  const auto first = [](const Thrown& t, double end) {
    auto scene = world(t);
    const auto texts = warned(scene, end);
    return texts.empty() ? std::string() : texts[0];
  };
  CHECK_THAT(first({.gravity = {0, g, 0}}, 0.5), Catch::Contains("passed the wall at the top"));
  CHECK_THAT(first({.gravity = {-g, 0, 0}}, 0.5), Catch::Contains("passed the wall at the left"));
  CHECK(first({.gravity = {g, 0, 0}}, 0.45).empty());
  CHECK_THAT(first({.gravity = {g, 0, 0}}, 0.6), Catch::Contains("has left the mesh"));
  // On a plane of symmetry, until it comes to the floor.
  CHECK(first({.at = {0, 1, 0}}, 0.39).empty());
  CHECK_THAT(first({.at = {0, 1, 0}}, 0.45), Catch::Contains("passed the wall at the bottom"));
  // Outside of the mesh from the start.
  CHECK(first({.at = {4, 1, 0}}, 0.5).empty());
}

TEST_CASE("Walls that stop rigid bodies: a disc lands and stays, at each side, and on a plane of symmetry") {
  const auto rests = [](const Thrown& t, double x, double y) {
    auto scene = world(t);
    CHECK(warned(scene, 1).empty());
    const auto& disc = scene.template rigid<"disc">();
    CHECK(std::abs(disc.position()[0] - x) <= 1e-9);
    CHECK(std::abs(disc.position()[1] - y) <= 1e-9);
    CHECK(disc.velocity.norm() <= 1e-9);
    return scene;
  };
  const auto scene = rests({.walls = Friction(0)}, 1, radius);
  const double matter = momentum(scene.body())[1];
  const double weights = (kg + 1000 * 0.3 * 0.2) * g;
  CHECK(scene.wall_impulse[1] == Approx(weights + matter).epsilon(1e-9));
  CHECK(scene.part<RigidContact>().dissipated == Approx(kg * g * (1 - radius)).epsilon(0.01));
  rests({.gravity = {0, g, 0}, .walls = Friction(0)}, 1, 2 - radius);
  rests({.gravity = {-g, 0, 0}, .walls = Friction(0)}, radius, 1);
  rests({.gravity = {-g, -g, 0}, .walls = Friction(0)}, radius, radius);
  rests({.at = {0, 1, 0}, .walls = Friction(0)}, 0, radius);
}

TEST_CASE("On a slope a disc slides on a smooth wall with g sin and rolls on a rough one with 2/3 g sin") {
  for (const double friction : {0.0, 0.5}) {
    const double slope = 20_deg;
    auto scene = world({.at = {0.5, radius, 0},
                        .gravity = {g * std::sin(slope), -g * std::cos(slope), 0},
                        .walls = Friction(std::atan(friction))});
    CHECK(warned(scene, 0.5).empty());
    const auto& disc = scene.rigid<"disc">();
    const double speed = (friction == 0 ? 1 : 2. / 3) * g * std::sin(slope) * 0.5;
    CHECK(disc.velocity[0] == Approx(speed).epsilon(1e-9));
    CHECK(disc.spin[0] == Approx(friction == 0 ? 0 : -speed / radius).epsilon(1e-9).margin(1e-12));
    CHECK(std::abs(disc.position()[1] - radius) <= 1e-9);
  }
}

TEST_CASE("A body that reaches into a fixed wall at the start is refused where walls stop bodies") {
  CHECK_THROWS_WITH(world({.at = {1, 0.1, 0}, .walls = Friction(0)}),
                    "RigidContact = disc, bottom: must not overlap at the start");
}

TEST_CASE("Tiles stop bodies and report as the whole does") {
  OneRank here;
  for (const std::optional<Friction>& walls : {std::optional<Friction>{}, std::optional(Friction(0))}) {
    const Thrown t{.at = {1, 0.5, 0}, .walls = walls};
    auto whole = world(t);
    auto tiled = distribute(here, grid(), {.tiles = 3},
                            [&](auto mesh, auto... portion) { return world(t, mesh, portion...); });
    const auto expected = warned(whole, 0.5), found = warned(tiled, 0.5);
    CHECK(found.size() == (walls ? 0 : 2));
    CHECK(found == expected);
    const Vec<double, 2> at = whole.rigid<"disc">().position();
    tiled.for_each_tile(
        [&](const auto& scene) { CHECK((scene.template rigid<"disc">().position() - at).norm() <= 1e-12); });
  }
}
