// Points in a thin layer along a grid's face: the node beside the face is light, and its exchange keeps
// momentum and lets no energy come from nothing.
#include <arenite/arenite.hpp>

#include "catch.hpp"

using namespace arenite;

namespace {

CartesianGrid<2> grid() { return CartesianGrid<2>{{.lower = {0, 0}, .upper = {1, 1}, .cell = 0.1}}; }

/// An elastic block that is pressed flat against a face: its points lie within `thickness` cells of it along
/// `axis`. It is stretched along both axes.
template <class N, class... Parts>
auto layer(int axis, bool upper, double thickness, Parts... parts) {
  const LinearElastic rubber{{.density = 1000, .young = 1e6, .poisson = 0.3}};
  Scene scene{PlaneStrain{}, grid(),  N{}, bodies(fill(Box{{0.3, 0.3}, {0.7, 0.4}}, rubber, {.per_cell = 4})),
              TrackEnergy{}, parts...};
  auto& points = scene.body().points;
  for (std::size_t p = 0; p < points.size(); ++p) {
    const Vec<double, 2> x = points.position[p];
    const double height = thickness * (x[1] - 0.3);
    Vec<double, 2> place(x[0], upper ? 1 - height : height), speed(x[0] - 0.5, (upper ? -5 : 5) * height);
    if (axis == 0) std::swap(place[0], place[1]), std::swap(speed[0], speed[1]);
    points.position.set(p, place);
    points.velocity.set(p, speed);
  }
  scene.template part<TrackEnergy>().initial_kinetic = kinetic_energy(scene.body());
  return scene;
}

/// Greatest gain over the energy put in, in 300 steps at the limit of the Courant number; of the middle of a
/// step, where the velocities are.
template <class Scene>
double greatest_gain(Scene scene) {
  double gain = 0;
  for (int k = 0; k < 300 && gain < 10; ++k) {
    const double before = scene.template part<TrackEnergy>().stress_work;
    step(scene, stable_step(scene));
    const double work = scene.template part<TrackEnergy>().stress_work - before;
    gain = std::max(
        gain, (energies(scene).residual - work / 2) / scene.template part<TrackEnergy>().initial_kinetic);
  }
  return gain;
}

}  // namespace

TEMPLATE_TEST_CASE("A thin layer along a face makes no energy, on walls and free", "",
                   (Numerics<QuadraticBSpline, Apic, Usl>), (Numerics<QuadraticBSpline, Flip, Usl>),
                   (Numerics<QuadraticBSpline, Apic, Musl>), (Numerics<QuadraticBSpline, Flip, Musl>),
                   (Numerics<CubicBSpline, Flip, Usl>), (Numerics<CubicBSpline, Apic, Musl>),
                   (Numerics<MlsGradient<QuadraticBSpline>, Apic, Usl>),
                   (Numerics<MlsGradient<CubicBSpline>, Apic, Usl>)) {
  const auto all = [](Condition c) { return walls(left(c), right(c), bottom(c), top(c)); };
  for (const int axis : {0, 1})
    for (const bool upper : {false, true})
      for (const double thickness : {0.3, 0.1, 0.01, 1e-4}) {
        CAPTURE(axis, upper, thickness);
        CHECK(greatest_gain(layer<TestType>(axis, upper, thickness)) <= 0.1);
        CHECK(greatest_gain(layer<TestType>(axis, upper, thickness, all(fixed))) <= 0.1);
        CHECK(greatest_gain(layer<TestType>(axis, upper, thickness, all(roller))) <= 0.1);
      }
}

TEST_CASE("The exchange at faces keeps momentum, and lets the energy of the nodes fall") {
  auto scene = layer<Numerics<QuadraticBSpline, Flip, Usl>>(1, false, 0.1);
  relocate(scene);
  p2g(scene, 1e-4);
  update_grid(scene, 1e-4);
  auto& nodes = scene.fields[0];
  Vec<double, 2> before = Vec<double, 2>::Zero(), after = before;
  double energy_before = 0, energy_after = 0, carried = 0;
  for (Index i = 0; i < nodes.size(); ++i) {
    nodes.velocity[i] = Vec<double, 2>(std::sin(7.0 * i), std::cos(5.0 * i));
    before += nodes.mass[i] * nodes.velocity[i];
    energy_before += nodes.mass[i] * nodes.velocity[i].squaredNorm();
    carried += nodes.mass[i];
  }
  CHECK(redistribute_at_faces<QuadraticBSpline>(scene.mesh, nodes, nodes.velocity, 1e-4) ==
        6);  // above the four cells of the layer, and beside them
  for (Index i = 0; i < nodes.size(); ++i) {
    after += nodes.mass[i] * nodes.velocity[i];
    energy_after += nodes.mass[i] * nodes.velocity[i].squaredNorm();
  }
  CHECK((after - before).norm() <= 1e-14 * carried);
  CHECK(energy_after < energy_before);
}

TEST_CASE("Where a body fills the cells at a face no node is light") {
  const LinearElastic rubber{{.density = 1000, .young = 1e6, .poisson = 0.3}};
  for (const int per_cell : {1, 4, 9}) {
    Scene scene{PlaneStrain{}, grid(), Numerics<QuadraticBSpline, Apic, Usl>{},
                bodies(fill(Box{{0., 0.}, {1., 0.5}}, rubber, {.per_cell = per_cell}))};
    relocate(scene);
    p2g(scene, 1e-4);
    update_grid(scene, 1e-4);
    CHECK(redistribute_at_faces<QuadraticBSpline>(scene.mesh, scene.fields[0], scene.fields[0].velocity,
                                                  1e-4) == 0);
  }
}

TEST_CASE("A point exactly on a free face keeps its impulse, and is strained as one close to it") {
  const LinearElastic rubber{{.density = 1000, .young = 1e6, .poisson = 0.3}};
  const auto moved = [&](double height) {
    Scene scene{PlaneStrain{}, grid(), Numerics<QuadraticBSpline, Flip, Usl>{},
                bodies(fill(Box{{0.3, 0.}, {0.4, 0.1}}, rubber, {.per_cell = 1, .velocity = {2, 3, 0}}))};
    auto& points = scene.body().points;
    points.position.set(0, {0.35, height});
    Sym<double, 2> stress;
    stress[1] = -1e4;
    points.stress.set(0, stress);
    step(scene, 1e-4);
    return points;
  };
  const double height = GENERATE(1e-9, 1e-12, 1e-15, 1e-17);
  CAPTURE(height);
  const auto on_face = moved(0), close = moved(height);
  const Vec<double, 2> change = on_face.velocity[0] - close.velocity[0];
  CHECK(change.norm() <= 1e-6);
  CHECK((on_face.position[0] - close.position[0]).norm() <= 1e-8);
  const auto on = on_face.stress[0], by = close.stress[0];
  // The third node's slope s / h falls with its value s^2 / 2: as s falls to 0 its share of the strain stays,
  // 2 dt^2 sigma / (rho h^2) = 2e-5. The massless node at rest would strain the point by 6e-3.
  for (std::size_t k = 0; k < on.size; ++k)
    CHECK(std::abs(on[k] - by[k]) <= 1.01 * 2e-5 * rubber.wave_modulus());
}

TEMPLATE_TEST_CASE("The force of points exactly on a face is passed on, not lost", "", QuadraticBSpline,
                   CubicBSpline) {
  const LinearElastic rubber{{.density = 1000, .young = 1e6, .poisson = 0.3}};
  for (const bool upper : {false, true}) {
    Scene scene{PlaneStrain{}, grid(), Numerics<TestType, Flip, Usl>{},
                bodies(fill(Box{{0.3, 0.2}, {0.4, 0.3}}, rubber, {.per_cell = 1}))};
    auto& points = scene.body().points;
    points.position.set(0, {0.35, upper ? 1.0 : 0.0});
    Sym<double, 2> stress;
    stress[1] = -1e4;
    points.stress.set(0, stress);
    relocate(scene);
    p2g(scene, 1e-4);
    const double dt = 1e-4;
    update_grid(scene, dt);
    smooth_light_nodes(scene, dt);
    const auto& nodes = scene.fields[0];
    Vec<double, 2> momentum = Vec<double, 2>::Zero(), force = momentum;
    for (Index i = 0; i < nodes.size(); ++i) {
      momentum += nodes.mass[i] * nodes.velocity[i];
      force += nodes.sums[i].force();
    }
    CHECK(force.norm() <= 1e-9);
    CHECK(momentum.norm() <= 1e-12);  // without the massless node's force: 1e-4 s times some 1000 N
  }
}
