// Shared by both translation units: the scene of a falling block, and a run of it elsewhere.
#pragma once

#include <arenite/arenite.hpp>

/// A block of 0.25 m2 that falls freely in a box of 1 m2, at rest at first.
inline auto falling_block() {
  using namespace arenite;
  const LinearElastic rubber{{.density = 1000, .young = 1_MPa, .poisson = 0.3}};
  return Scene{PlaneStrain{},
               CartesianGrid<2>({.lower = {0, 0}, .upper = {1, 1}, .cell = 0.125}),
               Numerics<QuadraticBSpline, Apic>{},
               bodies(fill(Box{{0.25, 0.375}, {0.75, 0.875}}, rubber, {.per_cell = 4})),
               walls(bottom(fixed)),
               gravity({0, -9.81})};
}

/// Mean vertical velocity of the points, m/s.
template <class Scene>
double mean_velocity(const Scene& scene) {
  const auto& velocity = scene.body().points.velocity;
  double sum = 0;
  for (const auto& v : velocity) sum += v[1];
  return sum / static_cast<double>(velocity.size());
}

/// Runs the block for 0.1 s in the other translation unit; returns its mean vertical velocity, m/s.
double fall_elsewhere();
