// The rivals of the scenes in scenes.hpp, on the same mesh, points and velocities, and the proof that they
// are fair: each conserves mass and momentum, and goes where the library's scene goes.
#pragma once

#include <algorithm>
#include <arenite/arenite.hpp>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <random>

#include "blocks_scene.hpp"
#include "rivals/bspline.hpp"
#include "rivals/tetrahedra.hpp"
#include "scenes.hpp"

namespace arenite::bench {

/// The constants of `sand`, `grains` and `elastic` in scenes.hpp.
inline constexpr double rival_density = 1540, rival_young = 5e6, rival_poisson = 0.33,
                        rival_friction = 40 * pi / 180;
template <class T>
rival::MohrCoulomb<T> rival_sand() {
  return {rival_density, rival_young, rival_poisson, rival_friction};
}
template <class T>
rival::DruckerPrager<T> rival_grains() {
  return {rival_density, rival_young, rival_poisson, rival_friction};
}
template <class T>
rival::LinearElastic<T> rival_elastic() {
  return {rival_density, rival_young, rival_poisson};
}

/// As `stir` in scenes.hpp.
template <class Rival>
void stir_rival(Rival& rival, double speed) {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> uniform(-speed, speed);
  for (auto& p : rival.points)
    for (auto& component : p.v) component = static_cast<std::decay_t<decltype(component)>>(uniform(random));
}

template <class T, class Law>
auto tetrahedral_rival(const Law& law, double points, bool averages) {
  const int k = static_cast<int>(std::lround(std::cbrt(points / 60)));
  const double h = 0.02;
  rival::Tetrahedra<T, Law> rival(tetrahedra(k, h), 3, law);
  rival.close_box(k * h);
  rival.averages = averages;
  rival.gravity = {0, static_cast<T>(-9.81), 0};
  stir_rival(rival, 0.5);
  return rival;
}

template <class T, class Law>
auto spline_rival(const Law& law, double points) {
  const int k = static_cast<int>(std::lround(std::cbrt(points / 8)));
  rival::BSpline<T, Law> rival(k + 4, 0.02, 2, k + 2, 2, law);
  rival.gravity = {0, static_cast<T>(-9.81), 0};
  stir_rival(rival, 0.5);
  return rival;
}

namespace detail_check {

inline void require(bool holds, const char* rival, const char* what, double off) {
  if (holds) return;
  std::fprintf(stderr, "benchmark: the rival %s is not fair: its %s is off by %g\n", rival, what, off);
  std::exit(1);
}

/// Mass, momentum [3] and kinetic energy of a rival's points.
struct Sums {
  double mass = 0, momentum[3] = {}, energy = 0;
};
template <class Rival>
Sums sums(const Rival& rival) {
  Sums s;
  for (const auto& p : rival.points) {
    const double m = static_cast<double>(p.mass);
    s.mass += m;
    for (std::size_t i = 0; i < std::size(p.v); ++i) {
      const double v = static_cast<double>(p.v[i]);
      s.momentum[i] += m * v;
      s.energy += m * v * v / 2;
    }
  }
  return s;
}

/// Without gravity and walls: nodes and points carry the same mass, and momentum stays.
template <class Rival>
void conserves(const char* word, Rival rival) {
  const Sums before = sums(rival);
  for (int k = 0; k < 5; ++k) rival.step(0.2 * rival.stable_step());
  const Sums after = sums(rival);
  double on_nodes = 0;
  for (const auto& node : rival.nodes) on_nodes += static_cast<double>(node.mass);
  const double lost =
      std::abs(on_nodes - after.mass) / after.mass + std::abs(after.mass - before.mass) / after.mass;
  require(lost < 1e-12, word, "mass", lost);
  double off = 0;
  for (int i = 0; i < 3; ++i) off += std::abs(after.momentum[i] - before.momentum[i]);
  off /= std::sqrt(2 * before.mass * before.energy);
  require(off < 1e-12, word, "momentum", off);
}

/// Ten equal steps of both: the same kinetic energy.
template <class Scene, class Rival>
void follows(const char* word, Scene scene, Rival rival, double tolerance) {
  const double dt = 0.2 * rival.stable_step();
  require(rival.points.size() == scene.point_count(), word, "number of points",
          static_cast<double>(rival.points.size()) - static_cast<double>(scene.point_count()));
  for (int k = 0; k < 10; ++k) {
    step(scene, dt);
    rival.step(dt);
  }
  const double energy = kinetic_energy(scene.body());
  const double off = std::abs(sums(rival).energy / energy - 1);
  require(off < tolerance, word, "kinetic energy after ten steps", off);
}

}  // namespace detail_check

/// Stops the program with a sentence if a rival is not what it claims to be. Called once, before any timing.
inline void check_rivals() {
  using namespace detail_check;
  constexpr double n = 2000;
  auto closed = tetrahedral_rival<double>(rival_sand<double>(), n, true);
  auto open = closed;
  for (auto& node : open.nodes) std::fill(std::begin(node.fixed_along), std::end(node.fixed_along), false);
  open.gravity = {};
  conserves("tetrahedra", open);
  follows("tetrahedra", tetrahedral_scene<double, NodalAveraging>(sand(), n), closed, 1e-6);
  follows("tetrahedra, elastic", tetrahedral_scene<double, NoAntiLocking>(PlainElastic{elastic()}, n),
          tetrahedral_rival<double>(rival_elastic<double>(), n, false), 1e-6);

  auto spline = spline_rival<double>(rival_grains<double>(), n);
  follows("B-splines", spline_scene<double, 3>(grains(), n), spline, 1e-6);
  spline.gravity = {};
  conserves("B-splines", spline);

  // The rival takes its forces from the moments of the weights, not from their gradients: near, not the same.
  const Blocks2d blocks{.cells = 40, .along = 2};
  auto scene = blocks_scene<double>(blocks);
  auto mls = blocks_rival<double>(blocks);
  stir(scene, 20);
  stir_rival(mls, 20);
  follows("MLS-MPM", scene, mls, 0.02);
  mls.walls = false;
  mls.gravity = 0;
  conserves("MLS-MPM", mls);
}

}  // namespace arenite::bench
