// Stable step: how far an explicit step may go.
#pragma once

#include <cmath>
#include <limits>

#include <arenite/scene/scene.hpp>

namespace arenite::inline ARENITE_INSTRUCTION_SET {

/// Largest step that the scene bears, s: the smallest size / (wave speed + point speed) of the cells that
/// hold points (Courant, Friedrichs, Lewy 1928), times what the numerics bear of it
/// (`Numerics::courant_limit`). Follows the mesh as it moves; rigid bodies do not limit it. Multiply by a
/// Courant number of at most 1. The wave speed is that of the law's density: volumes grown by dilatancy to r
/// times raise the true one by the root of r.
template <class Scene>
double stable_step(const Scene& scene) {
  using T = typename Scene::T;
  using std::max;
  constexpr int width = Scene::NumericsType::template width<T>;
  using P = lanes_of<T, width>;
  T least = std::numeric_limits<T>::infinity();
  scene.for_each_body([&](const auto& body, const auto&) {
    const T wave = static_cast<T>(std::sqrt(body.law.wave_modulus() / body.law.density()));
    least = scene.blocks.reduce(
        least,
        [&](Index c) {
          if (body.cells.empty(c)) return std::numeric_limits<T>::infinity();
          P fastest(0);
          body.cells.template for_packs<width>(c, [&](Index first, int count) {
            body.points.velocity.template prefetch_ahead<width>(first);
            const auto v = body.points.velocity.template load<P>(first, count);
            P square = v[0] * v[0];
            for (std::size_t k = 1; k < Scene::D; ++k) square += v[k] * v[k];
            fastest = max(fastest, square);
          });
          return scene.mesh.size(c) / (wave + std::sqrt(greatest_lane(fastest)));
        },
        [](T a, T b) { return std::min(a, b); });
  });
  return Scene::NumericsType::template courant_limit<Scene::D>() * static_cast<double>(least);
}

}  // namespace arenite::inline ARENITE_INSTRUCTION_SET
