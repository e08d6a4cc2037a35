// Stable step: how far an explicit step may go.
#pragma once

#include <cmath>
#include <limits>

#include <arenite/scene/scene.hpp>

namespace arenite {

/// Smallest size / (wave speed + point speed) of the cells that hold points, s (Courant, Friedrichs, Lewy
/// 1928). Follows the mesh as it moves; rigid bodies do not limit it. Multiply by a Courant number.
template <class Scene>
double stable_step(const Scene& scene) {
  using T = typename Scene::T;
  T least = std::numeric_limits<T>::infinity();
  scene.for_each_body([&](const auto& body, const auto&) {
    const T wave = static_cast<T>(std::sqrt(body.law.wave_modulus() / body.law.density()));
    const auto& velocity = body.points.velocity;
    least = scene.blocks.reduce(
        least,
        [&](Index c) {
          const auto in_cell = body.cells[c];
          if (in_cell.empty()) return std::numeric_limits<T>::infinity();
          T fastest = 0;
          for (const Index p : in_cell) fastest = std::max(fastest, velocity[p].squaredNorm());
          return scene.mesh.size(c) / (wave + std::sqrt(fastest));
        },
        [](T a, T b) { return std::min(a, b); });
  });
  return static_cast<double>(least);
}

}  // namespace arenite
