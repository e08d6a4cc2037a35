// Update of stress first (USF): a step of the stage is the formula, the exact frequency of a bar, and what
// any order must keep.
#include <arenite/arenite.hpp>
#include <arenite/transfer/reference.hpp>

#include "catch.hpp"
#include "courant.hpp"
#include "meshes.hpp"
#include "state_buffer.hpp"

using namespace arenite;

namespace {

constexpr double young = 1e5, density = 1000;
LinearElastic rubber(double poisson) { return LinearElastic{{density, young, poisson}}; }

/// A block that flies freely, with a velocity field that varies in the cells.
template <class K, class N, class Mesh>
auto block(const Mesh& mesh, const N& numerics) {
  Scene scene{K{}, Mesh(mesh), numerics,
              bodies(fill(Box{{0.3, 0.3}, {0.7, 0.7}}, rubber(0.3), {.per_cell = 4})), TrackEnergy{}};
  auto& points = scene.body().points;
  for (std::size_t p = 0; p < points.size(); ++p) {
    const auto x = points.position[p];
    points.velocity.set(p, {0.1 + std::sin(5 * x[1]), 0.3 * std::cos(7 * x[0]) - 0.2 * x[1]});
  }
  return scene;
}

CartesianGrid<2> grid() { return CartesianGrid<2>{{.lower = {0, 0}, .upper = {1, 1}, .cell = 0.1}}; }
SimplexMesh<2> mesh() { return SimplexMesh<2>(test::triangles({0, 0}, {1, 1}, 10, 10)); }

template <class Transfer = Flip>
using Spline = Numerics<QuadraticBSpline, Transfer, Usf>;
template <class Transfer = Flip>
using Simplex = Numerics<LinearSimplex, Transfer, Usf>;

/// Stress and velocity after a step are those of: strain by v_i^old, law, force of the new stress, FLIP.
template <class Scene>
void check_step(Scene scene) {
  using Cell = typename Scene::Shape::template Cell<typename Scene::Mesh>;
  const double dt = 0.5 * stable_step(scene);
  step(scene, dt);  // so that there is a stress
  relocate(scene);
  auto& points = scene.body().points;
  const auto sums = reference::p2g<typename Scene::Kinematics>(scene.numerics, scene.mesh, scene.body());
  auto body = scene.body();
  for (std::size_t p = 0; p < points.size(); ++p) {
    const Cell cell(scene.mesh, points.cell[p]);
    const auto w = cell.weights(points.position[p]);
    const auto gradient = cell.gradients(points.position[p]);
    Mat<double, 2> l = Mat<double, 2>::Zero();
    double radial = 0;
    for (int i = 0; i < cell.size; ++i) {
      const auto& node = sums[cell.nodes[static_cast<std::size_t>(i)]];
      Vec<double, 2> v = node.momentum / node.mass;
      if (Scene::Kinematics::hoop && cell.node_positions()(0, i) == 0) v[0] = 0;
      l += dt * v * gradient.col(i).transpose();
      radial += dt * w[i] * v[0];
    }
    auto strain = strain_step_of<double, 2>([&](int b) { return std::array<double, 2>{l(0, b), l(1, b)}; });
    if (Scene::Kinematics::hoop) strain.strain[2] = radial / points.position[p][0];
    auto stress = body.points.stress[p];
    NoHistory<double> none;
    body.law.update(stress, strain, none);
    body.points.stress.set(p, stress);
    body.points.volume[p] *= small_exp(trace(strain.strain));
  }
  const auto after = reference::p2g<typename Scene::Kinematics>(scene.numerics, scene.mesh, body);
  step(scene, dt);
  double size = 0, force_size = 0;
  for (std::size_t p = 0; p < points.size(); ++p)
    for (std::size_t k = 0; k < 4; ++k) size = std::max(size, std::abs(body.points.stress[p][k]));
  for (const auto& node : after) force_size = std::max(force_size, node.force.norm());
  for (std::size_t p = 0; p < points.size(); ++p) {
    for (std::size_t k = 0; k < 4; ++k)
      REQUIRE(std::abs(points.stress[p][k] - body.points.stress[p][k]) <= 1e-12 * size);
    REQUIRE(points.volume[p] == Approx(body.points.volume[p]).epsilon(1e-13));
  }
  for (std::size_t i = 0; i < after.size(); ++i)
    REQUIRE((scene.fields[0].sums[i].force() - after[i].force).norm() <= 1e-12 * force_size);
}

}  // namespace

TEST_CASE("USF: strains come of what the points pass to the nodes, forces of the new stresses") {
  check_step(block<PlaneStrain>(grid(), Spline<>{}));
  check_step(block<Axisymmetric>(mesh(), Simplex<>{}));
}

TEST_CASE("USF: momentum to round-off, the same bits on any number of threads, and from a saved state") {
  const auto check = [](const auto& make) {
    const int before = threads();
    set_threads(1);
    auto scene = make();
    const Vec<double, 2> start = momentum(scene.body());
    const auto steps = [](auto& of) {
      for (int k = 0; k < 15; ++k) step(of, 0.4 * stable_step(of));
    };
    steps(scene);
    const test::StateBuffer middle(scene);
    steps(scene);
    // In axisymmetry the hoop stress changes the radial component.
    const Vec<double, 2> gain = momentum(scene.body()) - start;
    CHECK(std::abs(gain[1]) <= 1e-12 * mass(scene.body()));
    if (!decltype(scene)::Kinematics::hoop) CHECK(std::abs(gain[0]) <= 1e-12 * mass(scene.body()));
    set_threads(3);
    auto again = make();
    middle.restore(again);
    steps(again);
    CHECK(test::StateBuffer::first_difference(test::StateBuffer(again), test::StateBuffer(scene)) == "");
    set_threads(before);
  };
  check([] { return block<PlaneStrain>(grid(), Spline<>{}); });
  check([] { return block<Axisymmetric>(mesh(), Simplex<>{}); });
}

TEST_CASE("USF: a bar swings at its frequency, and FLIP keeps its energy") {
  // Between rollers u = a sin(pi x / 2 L) with omega = pi c / 2 L; free at x = L. A quarter of a period on it
  // goes through rest with all its energy kinetic, half a period on with none.
  const double length = 1, c = std::sqrt(young / density), period = 4 * length / c;
  Scene scene{PlaneStrain{},       CartesianGrid<2>{{.lower = {0, 0}, .upper = {1.5, 0.1}, .cell = 0.05}},
              Spline<>{},          bodies(fill(Box{{0., 0.}, {length, 0.1}}, rubber(0), {.per_cell = 4})),
              walls(left(roller)), TrackEnergy{}};
  auto& points = scene.body().points;
  for (std::size_t p = 0; p < points.size(); ++p)
    points.velocity.set(p, {0.01 * std::sin(M_PI * points.position[p][0] / (2 * length)), 0});
  const double start = kinetic_energy(scene.body());
  double greatest = 0, lowest = start, at_lowest = 0;
  run(scene, {.end = 3.1 * period}, [&](const auto& s) {
    const double kinetic = kinetic_energy(s.body());
    greatest = std::max(greatest, kinetic + strain_energy(s.body()));
    if (s.time > 2.6 * period && s.time < 2.9 * period && kinetic < lowest) {
      lowest = kinetic;
      at_lowest = s.time;
    }
  });
  CHECK(at_lowest == Approx(2.75 * period).epsilon(0.01));
  CHECK(lowest < 0.01 * start);
  CHECK(greatest < 1.03 * start);
  CHECK(kinetic_energy(scene.body()) + strain_energy(scene.body()) > 0.97 * start);
}

TEST_CASE("A disc that spins with APIC keeps its angular momentum; it swells with USL, and shrinks with USF",
          "[heavy]") {
  // In a step points move along the tangent by w dt times the radius, which grows by (1 + (w dt)^2)^(1/2).
  // The strain of the velocities at the start of the step contains none of that (USL), the strain with the
  // weights after the motion twice as much (USF). The rest is half of w dt times the angle turned.
  const auto radius_after = [](const auto& numerics, double turns) {
    const double spin = 5.5;
    Scene scene{
        PlaneStrain{}, CartesianGrid<2>{{.lower = {-0.45, -0.45}, .upper = {0.45, 0.45}, .cell = 0.0375}},
        numerics,
        bodies(fill(Inside{[](const auto& x) { return x.norm() - 0.3; }}, rubber(0.3), {.per_cell = 4}))};
    auto& points = scene.body().points;
    Mat<double, 2> gradient;
    gradient << 0, -spin, spin, 0;
    for (std::size_t p = 0; p < points.size(); ++p) {
      points.velocity.set(p, gradient * points.position[p]);
      points.velocity_gradient.set(p, gradient);
    }
    const auto angular_momentum = [&] {
      double sum = 0;
      for (std::size_t p = 0; p < points.size(); ++p) {
        const auto x = points.position[p], v = points.velocity[p];
        const auto c = points.velocity_gradient[p];
        sum += points.mass[p] *
               (x[0] * v[1] - x[1] * v[0] + (c(1, 0) - c(0, 1)) * square(scene.mesh.edge()) / 4);
      }
      return sum;
    };
    const auto square_radius = [&] {
      double sum = 0;
      for (const auto& x : points.position) sum += x.squaredNorm();
      return sum;
    };
    const double start = angular_momentum(), small = square_radius();
    const double angle = 2 * pi * turns;
    while (scene.time * spin < angle) step(scene, 0.5 * stable_step(scene));
    CHECK(angular_momentum() == Approx(start).epsilon(1e-11));
    const double step_angle = angle / static_cast<double>(scene.steps);
    return std::pair{std::sqrt(square_radius() / small) - 1, angle * step_angle / 2};
  };
  // The centrifugal force and its oscillation stretch the disc by about 0.006 at either order.
  const auto [swollen, growth] = radius_after(Numerics<QuadraticBSpline, Apic, Usl>{}, 3);
  CHECK(growth > 0.03);
  CHECK(std::abs(swollen - growth) < 0.012);
  const auto [shrunk, loss] = radius_after(Spline<Apic>{}, 3);
  CHECK(loss > 0.03);
  CHECK(std::abs(shrunk + loss) < 0.015);
}
