// Scenes that the benchmarks step: one of each family of compositions, filled with moving, yielding points.
#pragma once

#include <arenite/arenite.hpp>
#include <arenite/mesh/box_mesh.hpp>
#include <cmath>
#include <random>

namespace arenite::bench {

/// Box of k x k x k cubes of edge h, each cut into six tetrahedra.
inline MeshData<3> tetrahedra(int k, double h) {
  const auto n = static_cast<Index>(k);
  return box_mesh<3>({{0, 0, 0}, {h * k, h * k, h * k}, {n, n, n}});
}

inline MohrCoulomb<> sand() {
  return MohrCoulomb{{.density = 1540, .young = 5e6, .poisson = 0.33, .friction = 40_deg}};
}
inline DruckerPrager<> grains() {
  return DruckerPrager{{.density = 1540, .young = 5e6, .poisson = 0.33, .friction = 40_deg}};
}
/// An elastic law that does not say that it is linear: stresses are then those of the end of a step, as the
/// rivals', and not of its middle.
struct PlainElastic : LinearElastic {
  static constexpr bool linear = false;
};
inline LinearElastic elastic() { return LinearElastic{{.density = 1540, .young = 5e6, .poisson = 0.33}}; }

/// Velocities that shear and compress at random, so that most points of a plastic law yield (seed fixed).
template <class Scene>
void stir(Scene& scene, double speed) {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> uniform(-speed, speed);
  scene.for_each_body([&](auto& body, const auto&) {
    for (std::size_t p = 0; p < body.points.size(); ++p) {
      Vec<typename Scene::T, Scene::D> v;
      for (auto& component : v) component = static_cast<typename Scene::T>(uniform(random));
      body.points.velocity.set(p, v);
    }
  });
}

/// About `points` points in tetrahedra, 10 in each.
template <class T, class AntiLocking, class Transfer = Flip, class Order = Musl, class Law>
auto tetrahedral_scene(const Law& law, double points) {
  const int k = static_cast<int>(std::lround(std::cbrt(points / 60)));
  const double h = 0.02;
  Scene scene{ThreeDimensional{},
              SimplexMesh<3, T>(tetrahedra(k, h)),
              Numerics<LinearSimplex, Transfer, Order, AntiLocking>{},
              bodies(fill(Box{{-1, -1, -1}, {100, 100, 100}}, law, {.per_cell = 10})),
              walls(left(roller), right(roller), bottom(fixed), front(roller), back(roller)),
              gravity({0, -9.81, 0})};
  stir(scene, 0.5);
  return scene;
}

/// About `points` points in triangles, 10 in each.
template <class Kinematics, class AntiLocking, class Transfer, class Order, class Law>
auto triangular_scene(const Law& law, double points) {
  const auto k = static_cast<Index>(std::lround(std::sqrt(points / 20)));
  Scene scene{Kinematics{},
              SimplexMesh<2>(box_mesh<2>({{0, 0}, {0.02 * k, 0.02 * k}, {k, k}})),
              Numerics<LinearSimplex, Transfer, Order, AntiLocking>{},
              bodies(fill(Box{{-1., -1.}, {100., 100.}}, law, {.per_cell = 10})),
              walls(left(roller), right(roller), bottom(fixed)),
              gravity({0, -9.81})};
  stir(scene, 0.5);
  return scene;
}

/// About `points` points on a grid of quadratic B-splines; 8 a cell in space, 4 in the plane.
template <class T, int D, class Transfer = Apic, class Order = Usl, class Law>
auto spline_scene(const Law& law, double points) {
  constexpr int per_cell = D == 3 ? 8 : 4;
  const double k = std::round(std::pow(points / per_cell, 1.0 / D)), h = 0.02;
  std::array<double, D> upper;
  upper.fill((k + 4) * h);
  using Kinematics = std::conditional_t<D == 3, ThreeDimensional, PlaneStrain>;
  Box<D> box;
  box.lower.fill(2 * h);
  box.upper.fill((k + 2) * h);
  Scene scene{Kinematics{}, CartesianGrid<D, T>{{.lower = {}, .upper = upper, .cell = h}},
              Numerics<QuadraticBSpline, Transfer, Order>{}, bodies(fill(box, law, {.per_cell = per_cell})),
              gravity(Triple{0, -9.81, 0})};
  stir(scene, 0.5);
  return scene;
}

}  // namespace arenite::bench
