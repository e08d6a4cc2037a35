// A rigid body dropped onto an elastic layer: what the body gains the layer loses, and the momentum of
// everything balances with gravity and walls, whatever the mass of the body.
#include <arenite/arenite.hpp>

#include "catch.hpp"
#include "courant.hpp"
#include "meshes.hpp"

using namespace arenite;

namespace {

constexpr double g = 9.81, speed = 1;

LinearElastic soil() { return LinearElastic{{.density = 1500, .young = 1e6, .poisson = 0.3}}; }

template <class Scene>
Vec<double, 2> soil_momentum(const Scene& scene) {
  return momentum(scene.body());
}

/// Runs and checks, at every step, the balance of the soil: momentum = gravity + walls + contact. Returns the
/// least height that the body reached.
template <class Scene>
double balance(Scene& scene, double end) {
  const auto& body = scene.rigid();
  const double weight = mass(scene.body()) * g;
  const Vec<double, 2> start = soil_momentum(scene);
  double deepest = 0, summed = 0;
  run(scene, {.end = end, .courant = test::courant(scene, 0.5)}, [&](const auto& s) {
    const double scale = weight * s.time + body.impulse.norm() + s.wall_impulse.norm();
    const Vec<double, 2> rest =
        soil_momentum(s) - start - Vec<double, 2>(0, -weight * s.time) - s.wall_impulse + body.impulse;
    REQUIRE(rest.norm() <= 1e-11 * scale);
    summed += body.force[1] * s.time_step;
    REQUIRE(std::abs(summed - body.impulse[1]) <= 1e-11 * scale);
    deepest = std::min(deepest, body.displacement[1]);
    if constexpr (std::remove_cvref_t<decltype(body)>::is_free) {
      const double m = body.motion.mass;
      REQUIRE(std::abs(m * (body.velocity[1] + speed) - (body.impulse[1] - m * g * s.time)) <=
              1e-11 * (m * (speed + g * s.time) + std::abs(body.impulse[1])));
    }
  });
  CHECK(scene.lost_points() == 0);
  CHECK(body.impulse[1] > 0);
  return deepest;
}

auto dropped(double mass) { return Guided{.mass = mass, .velocity = -speed}; }

template <class Motion, class Coupling = RigidVelocity>
auto on_triangles(Motion motion, Coupling coupling = {}) {
  auto data = test::triangles({0, 0}, {0.6, 0.6}, 12, 12);
  test::name_region(data, "block", [](const auto& x) { return x[0] < 0.2 && x[1] > 0.3 && x[1] < 0.5; });
  test::name_region(data, "layer", [](const auto& x) { return x[1] < 0.3; });
  return Scene{PlaneStrain{},
               SimplexMesh<2>(data),
               Numerics<LinearSimplex, Flip, Musl>{},
               bodies(fill(Cells("layer"), soil(), {.per_cell = 6})),
               walls(left(roller), right(roller), bottom(fixed)),
               gravity({0, -g}),
               rigids(rigid(MeshSurface{"block"}, motion, Friction(20_deg), coupling)),
               MovingMesh<>{.fixed_below = 0, .moving_from = 0.3},
               TrackEnergy{}};
}

template <class Motion>
auto on_grid(Motion motion) {
  return Scene{PlaneStrain{},
               CartesianGrid<2>{{.lower = {0, 0}, .upper = {0.6, 0.6}, .cell = 0.05}},
               Numerics<QuadraticBSpline, Apic, Usl>{},
               bodies(fill(Box{{0., 0.}, {0.6, 0.3}}, soil(), {.per_cell = 4})),
               walls(left(roller), right(roller), bottom(fixed)),
               gravity({0, -g}),
               rigids(rigid(DistanceSurface{[](const auto& x) {
                              return std::max(x[0] - 0.2, std::max(0.32 - x[1], x[1] - 0.5));
                            }},
                            motion, Friction(20_deg))),
               TrackEnergy{}};
}

}  // namespace

TEST_CASE("Rigid body on triangles: light, middling and heavy, impulses balance", "[limit]") {
  double before = 0;
  for (const double mass : {1e-3, 10.0, 1000.0}) {
    CAPTURE(mass);
    auto scene = on_triangles(dropped(mass));
    const double deepest = balance(scene, 0.03);
    CHECK(deepest < before);
    before = deepest;
    const Energies e = energies(scene);
    CAPTURE(e.residual, e.kinetic, e.strain, e.contact, e.external,
            scene.template part<TrackEnergy>().initial_kinetic);
    CHECK(std::abs(e.residual) <=
          0.2 * (scene.template part<TrackEnergy>().initial_kinetic + std::abs(e.external)));
  }
  CHECK(before < -0.01);
}

TEST_CASE("Rigid body on B-splines: light, middling and heavy, impulses balance", "[limit]") {
  for (const double mass : {1e-3, 10.0, 1000.0}) {
    CAPTURE(mass);
    auto scene = on_grid(dropped(mass));
    balance(scene, 0.03);
  }
}

TEST_CASE("Impulses balance with a prescribed motion, and through the centre-of-mass velocity") {
  auto prescribed = on_triangles(Prescribed{[](double t) { return std::array<double, 3>{0, -10 * t, 0}; }});
  balance(prescribed, 0.03);
  auto soft = on_triangles(dropped(10.0), CentreOfMass{});
  balance(soft, 0.03);
}

TEST_CASE("A body far heavier than the layer keeps its speed; one far lighter takes the layer's", "[limit]") {
  auto heavy = on_grid(dropped(1e9));
  run(heavy, {.end = 0.01});
  CHECK(std::abs(heavy.rigid().velocity[1] + speed + g * 0.01) <= 1e-5);
  for (const double mass : {1e-2, 1e-4, 1e-6, 1e-9}) {
    CAPTURE(mass);
    auto light = on_grid(dropped(mass));
    run(light, {.end = 0.05}, [](const auto& s) {
      // No node that the body touches moves into it, by more than its gap.
      const auto& body = s.rigid();
      for (const auto& t : body.touched_nodes)
        REQUIRE((s.fields[t.field].velocity[t.node] - body.velocity).dot(t.normal) >=
                -t.closing - 1e-6 * speed);
    });
    CHECK(std::abs(light.rigid().velocity[1]) <= 0.2 * speed);
  }
}
