// FLIP, XPIC and FMPM with a time constant: what points keep to themselves, that is, what the nodes do not
// see, decays as exp(-t / time) on any steps. Two points in one place with opposite velocities move no node.
#include <arenite/arenite.hpp>

#include "catch.hpp"
#include "meshes.hpp"

using namespace arenite;

namespace {

/// Points of every cell, pairwise in one place with opposite velocities.
template <class Order, class Shape, class Transfer = Flip, class Mesh>
auto pairs(const Mesh& mesh, double time) {
  Scene scene{PlaneStrain{}, Mesh(mesh), Numerics<Shape, Transfer, Order>{.transfer = {.time = time}},
              bodies(fill(Box{{0.2, 0.2}, {0.8, 0.8}},
                          LinearElastic{{.density = 1000, .young = 1e4, .poisson = 0.3}}, {.per_cell = 4}))};
  auto& points = scene.body().points;
  for (std::size_t p = 0; p + 1 < points.size(); ++p)
    if (p % 2 == 0 && points.cell[p] == points.cell[p + 1]) {
      points.position.set(p + 1, points.position[p]);
      points.velocity.set(p, {0.3, -0.1});
      points.velocity.set(p + 1, {-0.3, 0.1});
    }
  return scene;
}

template <class Scene>
void check(const Scene& start, double time) {
  for (const double dt : {2e-4, 1e-3, 3.3e-3}) {
    CAPTURE(dt);
    auto scene = start;
    const double before = kinetic_energy(scene.body());
    REQUIRE(before > 0);
    while (scene.time < 0.0198 - dt / 2) step(scene, dt);
    const double expected = before * std::exp(-2 * scene.time / time);
    CHECK(std::abs(kinetic_energy(scene.body()) - expected) <= 1e-12 * before);
    if (std::isinf(time)) CHECK(kinetic_energy(scene.body()) == before);
  }
}

}  // namespace

TEST_CASE("what points keep to themselves decays in time, not by steps") {
  const CartesianGrid<2> grid{{.lower = {0, 0}, .upper = {1, 1}, .cell = 0.1}};
  const SimplexMesh<2> mesh(test::triangles({0, 0}, {1, 1}, 10, 10));
  for (const double time : {0.004, 0.05, std::numeric_limits<double>::infinity()}) {
    CAPTURE(time);
    check(pairs<Usl, QuadraticBSpline>(grid, time), time);
    check(pairs<Musl, QuadraticBSpline>(grid, time), time);
    check(pairs<Usl, LinearSimplex>(mesh, time), time);
    check(pairs<Musl, LinearSimplex>(mesh, time), time);
    check(pairs<Musl, QuadraticBSpline, Xpic>(grid, time), time);
    check(pairs<Usl, LinearSimplex, Fmpm>(mesh, time), time);
  }
  CHECK_THROWS_WITH((Flip{.time = 0}), Catch::Matchers::Contains("Flip.time = 0: must be positive"));
}

TEST_CASE("with a time constant and no force the fraction of a step is fraction exp(-dt / time)") {
  const Flip flip{.fraction = 0.9, .time = 0.01};
  CHECK(double(flip.in_step(0.002).fraction) == Approx(0.9 * std::exp(-0.2)).epsilon(1e-15));
  CHECK(double(Flip{.fraction = 0.9}.in_step(0.002).fraction) == 0.9);
}
