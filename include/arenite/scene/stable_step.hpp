// Stable step: the largest explicit time step at which a scene is stable.
#pragma once
// SPDX-License-Identifier: BSD-3-Clause

#include <cmath>
#include <limits>

#include <arenite/scene/scene.hpp>

namespace arenite::inline ARENITE_INSTRUCTION_SET {

namespace detail {

/// Greatest wave modulus of the points of a cell in their states, Pa.
template <int Width, class L, class T, int D, ExtraColumns E>
T stiffest(const Body<L, T, D, E>& body, Index c) {
  using P = typename LawLanes<L, T, Width>::type;
  P modulus(0);
  body.cells.template for_packs<lane_count<P>>(c, [&](Index first, int count) {
    using std::max;
    const Sym<P, D> stress{body.points.stress.template load_repeated<P>(first, count)};
    modulus =
        max(modulus, P(body.law.wave_modulus(stress, body.points.template load_history<P>(first, count))));
  });
  return greatest_lane(modulus);
}

}  // namespace detail

/// Largest stable step of the scene, s: the smallest size / (wave speed + point speed) of the cells that
/// contain points (Courant, Friedrichs, Lewy 1928), times the limit of the numerics
/// (`Numerics::courant_limit`), or smaller where a law or a part has its own `stable_step`. Follows the
/// mesh as it moves, and the state where a law's `wave_modulus` does; rigid bodies do not limit it. Multiply
/// by a Courant number of at most 1. The wave speed is that of the law's density: volumes grown by dilatancy
/// to r times raise the true one by the root of r.
template <class Scene>
double stable_step(const Scene& scene) {
  using T = typename Scene::T;
  using std::max;
  constexpr int width = Scene::NumericsType::template width<T>;
  const double limit = Scene::NumericsType::template courant_limit<Scene::D>();
  using P = lanes_of<T, width>;
  T least = std::numeric_limits<T>::infinity();
  scene.for_each_body([&](const auto& body, const auto&) {
    const auto& law = body.law;
    using L = std::remove_cvref_t<decltype(law)>;
    const T unstressed = static_cast<T>(std::sqrt(law.wave_modulus() / law.density()));
    const auto add_fastest = [&](P& square, Index first, int count) {
      const auto v = body.points.velocity.template load<P>(first, count);
      P of_points = v[0] * v[0];
      for (std::size_t k = 1; k < Scene::D; ++k) of_points += v[k] * v[k];
      square = max(square, of_points);
    };
    const auto bound = [&](Index c, T wave, T square) {
      T step = scene.mesh.size(c) / (wave + std::sqrt(square));
      if constexpr (limits_step<L>) {
        const double h = limit * static_cast<double>(scene.mesh.size(c));
        step = std::min(step, static_cast<T>(law.stable_step(h) / limit));
      }
      return step;
    };
    if constexpr (has_equal_cells<typename Scene::Mesh> && !stiffness_varies<L, T, Scene::D>) {
      // The fastest point decides, whatever its cell: points in the order of memory, which fill their packs.
      if (body.points.size() == 0) return;
      const T square = scene.blocks.reduce_blocks(
          T(0),
          [&](Index begin, Index end) {
            P of_block(0);
            body.cells.template for_packs_in_memory<width>(
                begin, end, body.points.size(),
                [&](Index first, int count) { add_fastest(of_block, first, count); });
            return greatest_lane(of_block);
          },
          [](T a, T b) { return std::max(a, b); });
      least = std::min(least, bound(0, unstressed, square));
    } else {
      least = scene.blocks.reduce(
          least,
          [&](Index c) {
            if (body.cells.empty(c)) return std::numeric_limits<T>::infinity();
            P square(0);
            body.cells.template for_packs<width>(c, [&](Index first, int count) {
              body.points.velocity.template prefetch_ahead<width>(first);
              add_fastest(square, first, count);
            });
            T wave = unstressed;
            if constexpr (stiffness_varies<L, T, Scene::D>)
              wave = std::sqrt(detail::stiffest<width>(body, c) / static_cast<T>(law.density()));
            return bound(c, wave, greatest_lane(square));
          },
          [](T a, T b) { return std::min(a, b); });
    }
  });
  double step = limit * static_cast<double>(least);
  scene.for_each_part([&](const auto& part) {
    if constexpr (bounds_step<std::remove_cvref_t<decltype(part)>, Scene>)
      step = std::min(step, part.stable_step(scene));
  });
  return step;
}

}  // namespace arenite::inline ARENITE_INSTRUCTION_SET
