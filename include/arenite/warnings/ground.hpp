// Ground: gravity and layers of a scene, for geostatic stresses.
#pragma once
// SPDX-License-Identifier: BSD-3-Clause

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <span>
#include <utility>
#include <vector>

#include <arenite/core/cold.hpp>
#include <arenite/part/parts.hpp>
#include <arenite/part/roles.hpp>
#include <arenite/particles/body.hpp>

namespace arenite::inline ARENITE_INSTRUCTION_SET {

namespace shared_detail {

/// Gravity for geostatic stresses, (x, y, z), m/s2: accelerations and body forces at a time, s. Throws
/// `error` unless it is the same everywhere.
template <class Scene>
std::array<double, 3> gravity_of_ground(const Scene& scene, double time) {
  using V = typename Scene::V;
  const auto add = [](V& sum, const V& more) {
    for (int k = 0; k < Scene::D; ++k) sum[k] += more[k];
  };
  V uniform = zeros<V>(), of_place = zeros<V>();
  scene.for_each_part([&](const auto& part) {
    using P = std::remove_cvref_t<decltype(part)>;
    if constexpr (accelerates<P, Scene>) add(uniform, part.acceleration(time));
    if constexpr (requires { part.acceleration_at(of_place, time); }) {
      const auto at = [&](Index i) {
        return V(part.acceleration_at(Scene::Shape::node_position(scene.mesh, i), time));
      };
      const V first = at(0);
      for (Index i = 1; i < Scene::Shape::node_count(scene.mesh); ++i)
        require((at(i) - first).norm() <= 1e-6 * first.norm(), "Geostatic: body force", vector_text(at(i)),
                {"must be the same everywhere, as at the first node, ", vector_text(first),
                 " m/s2: give the stress as a function of the position"});
      add(of_place, first);
    }
  });
  add(uniform, of_place);
  return in_space(uniform);
}

/// The data of a body's fill that its ground needs.
struct GroundFill {
  const FillOptions* options;
  const AnyRegion* region;
  Ground::Layer layer;  // with the bounds of the region

  bool is_geostatic() const { return options->stress && options->stress->geostatic(); }
};

/// The fills of a recipe; regions have no bounds yet.
template <class Recipe>
auto ground_fills(const Recipe& recipe) {
  auto fills = by_body<GroundFill, Recipe::count>(recipe.size());
  std::size_t number = 0;
  recipe.for_each([&](const auto& fill) {
    fills[number++] = {&fill.options, &fill.region, {fill.law.density(), {}, {}}};
  });
  return fills;
}

/// Whether any of them is geostatic; gives the regions their bounds.
bool begin_grounds(std::span<GroundFill> fills, std::size_t dimensions);
std::vector<Ground> grounds_of(std::span<const GroundFill> fills, const Ground& common, double close);

/// The ground of each body of a recipe: gravity, and the layers above it. A layer is another body with a
/// geostatic stress, whose region lies wholly above.
template <class Scene, class Recipe>
std::vector<Ground> grounds_of(const Scene& scene, const Recipe& recipe) {
  auto fills = ground_fills(recipe);
  if (!begin_grounds(fills, Scene::D)) return std::vector<Ground>(fills.size());
  const Ground common{.gravity = gravity_of_ground(scene, 0)};
  common.axis();
  if constexpr (is_simplex_mesh<typename Scene::Mesh> && !Scene::is_portion)
    for (GroundFill& fill : fills)
      if (!fill.region->test) {
        Ground::Layer& layer = fill.layer;
        std::swap(layer.lower, layer.upper);
        const auto numbers = region_numbers(scene.mesh, *fill.region);
        for (Index c = 0; c < scene.mesh.cell_count(); ++c)
          if (scene.mesh.is_in(c, numbers))
            for (const Index i : scene.mesh.nodes(c))
              for (std::size_t k = 0; k < Scene::D; ++k) {
                const auto x = static_cast<double>(scene.mesh.position(i)[static_cast<int>(k)]);
                layer.lower[k] = std::min(layer.lower[k], x);
                layer.upper[k] = std::max(layer.upper[k], x);
              }
      }
  return grounds_of(fills, common, 1e-6 * static_cast<double>(scene.mesh.size(0)));
}

}  // namespace shared_detail
}  // namespace arenite::inline ARENITE_INSTRUCTION_SET

#if ARENITE_HAS_COLD

#include <arenite/core/warning.hpp>

namespace arenite::inline ARENITE_INSTRUCTION_SET {
namespace shared_detail {

ARENITE_COLD bool begin_grounds(std::span<GroundFill> fills, std::size_t dimensions) {
  constexpr double inf = std::numeric_limits<double>::infinity();
  bool any = false;
  for (GroundFill& fill : fills) {
    any = any || fill.is_geostatic();
    fill.layer.lower = {-inf, -inf, -inf};
    fill.layer.upper = {inf, inf, inf};
    for (std::size_t k = 0; k < dimensions && fill.region->test; ++k)
      fill.layer.lower[k] = fill.region->lower[k], fill.layer.upper[k] = fill.region->upper[k];
  }
  return any;
}

ARENITE_COLD std::vector<Ground> grounds_of(std::span<const GroundFill> fills, const Ground& common,
                                            double close) {
  std::vector<Ground> grounds(fills.size());
  const std::size_t vertical = common.axis();
  for (std::size_t f = 0; f < fills.size(); ++f) {
    if (!fills[f].is_geostatic()) continue;
    grounds[f] = common;
    const auto& own = fills[f].layer;
    for (std::size_t other = 0; other < fills.size(); ++other) {
      const auto& layer = fills[other].layer;
      if (other == f || !fills[other].is_geostatic()) continue;
      if (common.gravity[vertical] < 0 ? layer.lower[vertical] >= own.upper[vertical] - close
                                       : layer.upper[vertical] <= own.lower[vertical] + close)
        grounds[f].above.push_back(layer);
    }
  }
  return grounds;
}

}  // namespace shared_detail
}  // namespace arenite::inline ARENITE_INSTRUCTION_SET

#endif  // ARENITE_HAS_COLD
