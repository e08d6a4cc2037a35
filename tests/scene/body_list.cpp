// Bodies in a number that only a run knows: a list of fills goes the way of the same fills named one by one.
#include <arenite/arenite.hpp>

#include "catch.hpp"
#include "meshes.hpp"
#include "message.hpp"
#include "state_buffer.hpp"

using namespace arenite;
using test::StateBuffer;

namespace {

LinearElastic rubber(double young) {
  return LinearElastic{{.density = 1000, .young = young, .poisson = 0.3}};
}
MohrCoulomb<> sand(double friction) {
  return MohrCoulomb<>{{.density = 1500, .young = 1e6, .poisson = 0.3, .friction = friction}};
}

/// Three fills as a list and one by one: scenes of both, made by `make(bodies)`, have the same state after a
/// number of steps.
template <class F, class Make>
void check(const std::array<F, 3>& fills, int steps, Make&& make) {
  auto named = make(bodies(fills[0], fills[1], fills[2]));
  auto listed = make(bodies(std::vector<F>(fills.begin(), fills.end())));
  CHECK(listed.number_of_bodies() == 3);
  CHECK(listed.fields.size() == named.fields.size());
  for (int k = 0; k < steps; ++k) {
    const double dt = 0.4 * stable_step(named);
    REQUIRE(stable_step(listed) * 0.4 == dt);
    step(named, dt);
    step(listed, dt);
  }
  CHECK(StateBuffer::first_difference(StateBuffer(listed), StateBuffer(named)) == "");
  auto again = make(bodies(std::vector<F>(fills.begin(), fills.end())));
  const StateBuffer middle(listed);
  middle.restore(again);
  step(again, 1e-5);
  step(listed, 1e-5);
  CHECK(StateBuffer::first_difference(StateBuffer(again), StateBuffer(listed)) == "");
}

}  // namespace

TEST_CASE("a list of bodies in contact, damped, between absorbing and frictional walls: the same bits") {
  const auto block = [](double x, double speed, double young) {
    return fill(Box{{x, 0.05}, {x + 0.2, 0.35}}, rubber(young), {.velocity = {speed, 0, 0}});
  };
  check(std::array{block(0.1, 1, 1e6), block(0.4, 0, 2e6), block(0.8, -1, 5e5)}, 150, [](auto made) {
    return Scene{PlaneStrain{},
                 CartesianGrid<2>{{.lower = {0, 0}, .upper = {1, 0.5}, .cell = 0.05}},
                 Numerics<QuadraticBSpline, Apic>{},
                 made,
                 walls(left(roller)),
                 frictional(bottom(), Friction(20_deg)),
                 absorbing(right()),
                 gravity({0, -9.81}),
                 Coulomb{Friction(10_deg)},
                 ViscousDamping{.rate = 2},
                 Reactions{},
                 TrackEnergy{}};
  });
}

TEST_CASE("a list of bodies on triangles, stresses at the middle of the step, each with its field") {
  const auto block = [](double x, double speed, double young) {
    return fill(Box{{x, 0.4}, {x + 0.2, 0.6}}, rubber(young), {.per_cell = 3, .velocity = {speed, 0, 0}});
  };
  const SimplexMesh<2> mesh(test::triangles({0, 0}, {1, 1}, 20, 20));
  check(std::array{block(0.1, 1, 1e6), block(0.4, 0, 2e6), block(0.7, -1, 5e5)}, 150, [&](auto made) {
    return Scene{PlaneStrain{},
                 mesh,
                 Numerics<LinearSimplex, Flip, Musl>{},
                 made,
                 walls(bottom(fixed)),
                 Coulomb{Friction(10_deg)},
                 TrackEnergy{}};
  });
}

TEST_CASE("layers of a list, geostatic, with their own parameters: the same bits") {
  const auto layer = [](double lower, double friction) {
    return fill(Box{{0., lower}, {1., lower + 0.2}}, sand(friction),
                {.stress = Geostatic{.surface = 0.6, .k0 = 0.5}});
  };
  check(std::array{layer(0, 40_deg), layer(0.2, 35_deg), layer(0.4, 30_deg)}, 100, [](auto made) {
    return Scene{PlaneStrain{},
                 CartesianGrid<2>{{.lower = {0, 0}, .upper = {1, 1}, .cell = 0.05}},
                 Numerics<QuadraticBSpline, Apic>{},
                 made,
                 walls(bottom(fixed), left(roller), right(roller)),
                 gravity({0, -9.81}),
                 rigid(DistanceSurface{Ball<2>({0.5, 0.68}, 0.1)}, Guided{.mass = 50, .velocity = -1},
                       Friction(20_deg)),
                 TrackEnergy{}};
  });
}

TEST_CASE("forty blocks in a row hand the momentum of the first on, and each can be read and changed") {
  std::vector<Fill<LinearElastic, "", Box<2>>> blocks;
  for (int k = 0; k < 40; ++k)
    blocks.push_back(fill(Box<2>{{0.3 * k + 0.2, 0.}, {0.3 * k + 0.4, 0.1}}, rubber(1e6),
                          {.velocity = {k == 0 ? 2. : 0., 0, 0}}));
  Scene scene{PlaneStrain{},
              CartesianGrid<2>{{.lower = {0, 0}, .upper = {12.5, 0.1}, .cell = 0.05}},
              Numerics<QuadraticBSpline, Apic>{},
              bodies(blocks),
              walls(bottom(roller), top(roller)),
              Coulomb{Friction(0.0)},
              TrackEnergy{}};
  const double before = momentum(scene.body(0))[0];
  double impulse = 0;  // that contact gave the second block
  run(scene, {.end = 0.4}, [&](const auto& s) { impulse += contact_force(s, 1)[0] * s.time_step; });
  // But for what the limit at nodes without mass to speak of took, which the scene counts.
  const double limited = scene.limited_momentum;
  CHECK(limited <= 1e-7 * before);
  CHECK(std::abs(momentum(scene.body(1))[0] - impulse) <= 1e-9 * impulse + limited);
  CHECK_THAT(test::message<error>([&] { scene.body(-1); }),
             Catch::Contains("Scene::body = -1: must be less than number_of_bodies()"));
  CHECK_THAT(test::message<error>([&] { contact_force(scene, 40); }),
             Catch::Contains("contact_force: body = 40: must be less than number_of_bodies()"));
  double after = 0;
  for (const auto& body : scene.bodies) after += momentum(body)[0];
  CHECK(std::abs(after - before) <= 1e-12 * before + limited);
  CHECK(momentum(scene.body(0))[0] < 0.3 * before);
  CHECK(momentum(scene.body(1))[0] > 1e-3 * before);
  CHECK(momentum(scene.body(39))[0] == 0);
  const std::size_t points = scene.point_count();
  insert_into(scene, scene.body(7), {{.position = {2.5, 0.05}, .volume = 1e-4}});
  CHECK(scene.point_count() == points + 1);
}

TEST_CASE("a list of bodies: what is refused") {
  using F = Fill<LinearElastic, "", Box<2>>;
  CHECK(test::message<error>([] { bodies(std::vector<F>{}); }) == "bodies = 0: must be at least one fill");
  const auto scene_with = [](const std::vector<F>& fills) {
    return Scene{PlaneStrain{}, CartesianGrid<2>{{.lower = {0, 0}, .upper = {1, 1}, .cell = 0.25}},
                 Numerics<QuadraticBSpline, Apic>{}, bodies(fills)};
  };
  const F inside = fill(Box<2>{{0, 0}, {1, 1}}, rubber(1e6)),
          outside = fill(Box<2>{{2, 2}, {3, 3}}, rubber(1e6));
  CHECK_THAT(test::message<error>([&] { scene_with({inside, outside}); }), Catch::Contains("no point"));
  auto scene = scene_with({inside});
  CHECK_THAT(test::message<error>([&] { scene.number_of(3, "probe.body"); }),
             Catch::Contains("probe.body = 3: must be the number or the name of a body of the scene"));
}
