// A surface and a motion of your own for a rigid body: a plate with a damper, set onto an elastic layer. It
// comes to rest where the layer carries its weight: force = m g, sigma_yy = -(m g / A + rho g (H - y)) below
// it.
//
//   g++ -std=c++20 -O3 -march=native -Iinclude -I/usr/include/eigen3 examples/extend/own_rigid_body.cpp -o own_rigid_body -pthread && ./own_rigid_body
//   prints: force 1962.27 N, weight 1962.00 N; stress -12038 Pa, exact -12017 Pa
#include <arenite/arenite.hpp>
#include <cstdio>
using namespace arenite;

/// All above a height, m: the nodes there are touched (arenite/rigid/body/surface.hpp). Needs nothing of the mesh,
/// so that it is its own bound surface.
struct Plate {
  static constexpr bool has_volume_fractions = false;
  double height;

  template <class Shape, class M, class V, class HasMass, class F>
  void visit(const M& mesh, const V& displacement, HasMass&& has_mass, F&& f) const {
    const V down = -V::Unit(1);
    for (Index i = 0; i < Shape::node_count(mesh); ++i)
      if (has_mass(i) && Shape::node_position(mesh, i)[1] >= height + displacement[1])
        f(i, down, false, typename V::Scalar(0));
  }
};

/// A guided mass, kg, slowed by a damper, N s/m: m dv/dt = m a - c v (arenite/rigid/motion/motion.hpp).
struct Damped {
  double mass, damping;
};
template <class T, int D>
struct BoundDamped : BoundGuided<T, D> {
  using V = Vec<T, D>;
  double rate;  // 1/s
  explicit BoundDamped(const Damped& d)
      : BoundGuided<T, D>(Guided{.mass = d.mass}), rate{d.damping / d.mass} {}

  V free_velocity(const V& before, const V& acceleration, T, T dt) const {
    return before + dt * (acceleration.dot(this->axis) * this->axis - static_cast<T>(rate) * before);
  }
};
template <class Traits>
auto bind_part(const Damped& motion, const Traits&) {
  return BoundDamped<typename Traits::T, Traits::D>(motion);
}

int main() {
  const double g = 9.81, weight = 200 * g, width = 0.2;
  const LinearElastic layer{{.density = 1500, .young = 2_MPa, .poisson = 0.2}};
  Scene scene{PlaneStrain{},
              CartesianGrid<2>{{.lower = {0, 0}, .upper = {width, 0.3}, .cell = 0.025}},
              Numerics<QuadraticBSpline, Apic, Usl>{},
              bodies(fill(Box{{0, 0}, {width, 0.2}}, layer, {.per_cell = 4})),
              walls(left(roller), right(roller), bottom(roller)),
              gravity({0, -g}),
              rigid(Plate{0.2}, Damped{.mass = 200, .damping = 4e4}, Friction::frictionless())};
  run(scene, {.end = 0.3});
  const double force = scene.rigid().force[1];
  double stress = 0, volume = 0;  // of the lower half, whose middle carries 3/4 of the layer
  const auto& points = scene.body().points;
  for (std::size_t p = 0; p < points.size(); ++p) {
    if (points.position[p][1] > 0.1) continue;
    stress += points.stress[p][1] * points.volume[p];
    volume += points.volume[p];
  }
  const double mean = stress / volume, exact = -(weight / width + 1500 * g * 0.15);
  std::printf("force %.2f N, weight %.2f N; stress %.0f Pa, exact %.0f Pa\n", force, weight, mean, exact);
  return std::abs(force / weight - 1) < 1e-3 && std::abs(mean / exact - 1) < 5e-3 ? 0 : 1;
}
