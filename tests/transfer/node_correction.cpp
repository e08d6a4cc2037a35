// Transfers beside FLIP and APIC: XPIC and FMPM, which correct the nodes' velocities, and AFLIP. Kernels against the
// formulas of one point, and the laws that the authors state.
#include <arenite/arenite.hpp>

#include "check_conservation.hpp"
#include "check_reference.hpp"
#include "meshes.hpp"
#include "state_buffer.hpp"

using namespace arenite;
using namespace arenite::test;

namespace {

template <class K, class N, class M>
Setup<K, N, M> cloud(const M& mesh, const typename N::Transfer& transfer) {
  Setup<K, N, M> s(mesh, 5);
  s.numerics.transfer = transfer;
  return s;
}

using Rubber = LinearElastic;
Rubber rubber() { return Rubber{{.density = 1000, .young = 1e5, .poisson = 0.3}}; }

/// A block with random velocities over a floor, in two halves that share nodes.
template <class N, class Mesh>
auto shaken(const Mesh& mesh, const N& numerics) {
  Scene scene{PlaneStrain{},
              Mesh(mesh),
              numerics,
              bodies(fill(Box{{0.1, 0.}, {0.5, 0.6}}, rubber(), {.per_cell = 4}),
                     fill(Box{{0.5, 0.}, {0.9, 0.6}}, rubber(), {.per_cell = 4})),
              walls(bottom(fixed), left(roller)),
              gravity({0, -9.81})};
  std::mt19937 random(3);
  std::uniform_real_distribution<double> speed(-1, 1);
  scene.for_each_body([&](auto& body, const auto&) {
    for (std::size_t p = 0; p < body.points.size(); ++p)
      body.points.velocity.set(p, {speed(random), speed(random)});
  });
  return scene;
}

template <class Scene>
Vec<double, 2> momentum_of(const Scene& scene) {
  Vec<double, 2> sum = Vec<double, 2>::Zero();
  scene.for_each_body([&](const auto& body, const auto&) { sum += momentum(body); });
  return sum;
}

CartesianGrid<2> grid() { return CartesianGrid<2>{{.lower = {0, 0}, .upper = {1, 1}, .cell = 0.1}}; }
SimplexMesh<2> mesh() { return SimplexMesh<2>(triangles({0, 0}, {1, 1}, 10, 10)); }

template <class Transfer, class Order>
using Spline = Numerics<QuadraticBSpline, Transfer, Order>;
template <class Transfer, class Order>
using Simplex = Numerics<LinearSimplex, Transfer, Order>;

}  // namespace

TEST_CASE("XPIC, FMPM and AFLIP: the kernels are the formulas of one point") {
  const Xpic xpic{.order = 4, .kept = 0.3};
  const Fmpm fmpm{.order = 3, .kept = 0.2};
  check_reference(cloud<Axisymmetric, Spline<Xpic, Musl>>(flat_grid(), xpic), 1e-12);
  check_reference(cloud<ThreeDimensional, Spline<Fmpm, Usl>>(solid_grid(), fmpm), 1e-12);
  check_reference(cloud<PlaneStrain, Simplex<Xpic, Musl>>(sample_mesh<2>(4), xpic), 1e-12);
  check_reference(cloud<ThreeDimensional, Simplex<Fmpm, Usl>>(sample_mesh<3>(2), fmpm), 1e-12);
  check_reference(cloud<PlaneStrain, Spline<Aflip, Usl>>(flat_grid(), {.fraction = 0.7}), 1e-12);
  check_reference(cloud<ThreeDimensional, Spline<Aflip, Musl>>(solid_grid(), {}), 1e-12);
}

TEST_CASE("XPIC is v_p + S (v^new - v^old) - (I - S S+)^m v_p, point by point") {
  auto s = cloud<PlaneStrain, Simplex<Xpic, Musl>>(sample_mesh<2>(4), {.order = 3});
  s.p2g();
  s.update_grid(0.01, {0, -9.81});
  const auto& points = s.body.points;
  const auto to_points = [&](const auto& of_nodes) {
    std::vector<Vec<double, 2>> v;
    for (std::size_t p = 0; p < points.size(); ++p) {
      const LinearSimplex::Cell<SimplexMesh<2>> cell(s.mesh, points.cell[p]);
      const auto w = cell.weights(points.position[p]);
      v.emplace_back(0, 0);
      for (std::size_t i = 0; i < 3; ++i) v[p] += w[static_cast<int>(i)] * of_nodes[cell.nodes[i]];
    }
    return v;
  };
  const auto to_nodes = [&](const std::vector<Vec<double, 2>>& v) {
    std::vector<Vec<double, 2>> sum(s.nodes.size(), Vec<double, 2>::Zero());
    for (std::size_t p = 0; p < points.size(); ++p) {
      const LinearSimplex::Cell<SimplexMesh<2>> cell(s.mesh, points.cell[p]);
      const auto w = cell.weights(points.position[p]);
      for (std::size_t i = 0; i < 3; ++i)
        sum[cell.nodes[i]] += points.mass[p] * w[static_cast<int>(i)] / s.nodes.mass[cell.nodes[i]] * v[p];
    }
    return sum;
  };
  std::vector<Vec<double, 2>> noise, expected;
  for (const auto& v : points.velocity) noise.push_back(v);
  for (int m = 0; m < 3; ++m) {
    const auto seen = to_points(to_nodes(noise));
    for (std::size_t p = 0; p < noise.size(); ++p) noise[p] -= seen[p];
  }
  const auto now = to_points(s.nodes.velocity), before = to_points(s.nodes.start);
  for (std::size_t p = 0; p < noise.size(); ++p)
    expected.emplace_back(points.velocity[p] + now[p] - before[p] - noise[p]);
  s.gather();
  std::vector<Vec<double, 2>> taken;
  for (const auto& v : s.body.points.velocity) taken.push_back(v);
  CHECK(off(taken, expected) < 1e-13);
}

TEST_CASE("FMPM of a high order takes the velocities that the full mass matrix gives") {
  // sum_j M_ij v_j = p_i with M_ij = sum m w_i w_j: P2G of these velocities gives the momentum again.
  auto s = cloud<PlaneStrain, Spline<Fmpm, Usl>>(flat_grid(), {.order = 20000});
  s.p2g();
  s.update_grid(0.01, {0, -9.81});
  const auto momentum = s.nodes.velocity;
  s.gather();
  s.p2g();
  s.update_grid();
  double worst = 0;
  for (std::size_t i = 0; i < s.nodes.size(); ++i)
    worst = std::max(worst, s.nodes.mass[i] * (s.nodes.velocity[i] - momentum[i]).norm());
  CHECK(worst < 1e-6);
}

TEST_CASE("XPIC and FMPM of order 1 are PIC, bit for bit") {
  const auto after = [](const auto& of_mesh, const auto& numerics) {
    auto scene = shaken(of_mesh, numerics);
    for (int k = 0; k < 10; ++k) step(scene, 0.4 * stable_step(scene));
    return StateBuffer(scene);
  };
  const auto pic = after(grid(), Spline<Flip, Musl>{.transfer = {.fraction = 0}});
  CHECK(StateBuffer::first_difference(after(grid(), Spline<Xpic, Musl>{.transfer = {.order = 1}}), pic) ==
        "");
  CHECK(StateBuffer::first_difference(after(grid(), Spline<Fmpm, Musl>{.transfer = {.order = 1}}), pic) ==
        "");
  CHECK(StateBuffer::first_difference(after(mesh(), Simplex<Xpic, Usl>{.transfer = {.order = 1}}),
                                      after(mesh(), Simplex<Flip, Usl>{.transfer = {.fraction = 0}})) == "");
}

TEST_CASE(
    "XPIC and FMPM: what momentum the points gain is gravity's and the walls', on any number of threads") {
  const auto check = [](const auto& of_mesh, const auto& numerics) {
    const int before = threads();
    StateBuffer one;
    for (const int n : {1, 3}) {
      CAPTURE(n);
      set_threads(n);
      auto scene = shaken(of_mesh, numerics);
      const Vec<double, 2> start = momentum_of(scene);
      double weight = 0;
      scene.for_each_body([&](const auto& body, const auto&) { weight += mass(body); });
      for (int k = 0; k < 20; ++k) step(scene, 0.4 * stable_step(scene));
      const Vec<double, 2> gravity(0, -9.81 * weight * scene.time);
      CHECK((momentum_of(scene) - start - gravity - scene.wall_impulse).norm() <= 1e-12 * weight);
      if (n == 1)
        one = StateBuffer(scene);
      else
        CHECK(StateBuffer::first_difference(StateBuffer(scene), one) == "");
    }
    set_threads(before);
  };
  check(grid(), Spline<Xpic, Musl>{.transfer = {.order = 3}});
  check(grid(), Spline<Fmpm, Musl>{.transfer = {.order = 4, .time = 0.01}});
  check(mesh(), Simplex<Xpic, Usl>{.transfer = {.order = 5, .time = 0.01}});
  check(mesh(), Simplex<Fmpm, Musl>{.transfer = {.order = 4}});
}

TEST_CASE("FMPM: two bodies that collide keep their momentum to round-off, and gain no energy") {
  const auto ball = [](double x, double speed) {
    return fill(Ball{{x, 0.5}, 0.2}, rubber(), {.per_cell = 4, .velocity = {speed, 0, 0}});
  };
  Scene scene{PlaneStrain{}, CartesianGrid<2>{{.lower = {0, 0}, .upper = {1, 1}, .cell = 0.05}},
              Spline<Fmpm, Usl>{.transfer = {.order = 4}}, bodies(ball(0.27, 1), ball(0.73, -0.5)),
              Coulomb{Friction(10_deg)}};
  const auto kinetic = [&] {
    double sum = 0;
    scene.for_each_body([&](const auto& body, const auto&) { sum += kinetic_energy(body); });
    return sum;
  };
  const Vec<double, 2> start = momentum_of(scene);
  const double first = momentum(scene.body<0>())[0], energy = kinetic();
  while (scene.time < 0.18) {
    step(scene, 0.5 * stable_step(scene));
    REQUIRE(kinetic() <= energy * (1 + 1e-12));
  }
  CHECK((momentum_of(scene) - start).norm() <= 1e-12 * first);
  CHECK(momentum(scene.body<0>())[0] < 0.5 * first);  // they collided
}

TEST_CASE("Orders and time constants are checked") {
  CHECK_THROWS_WITH((Xpic{.order = 0}), Catch::Matchers::Contains("Xpic.order = 0: must be a whole number"));
  CHECK_THROWS_WITH((Fmpm{.order = 2.5}), Catch::Matchers::Contains("Fmpm.order = 2.5"));
  CHECK_THROWS_WITH((Fmpm{.time = -1}), Catch::Matchers::Contains("Fmpm.time = -1: must not be negative"));
}
