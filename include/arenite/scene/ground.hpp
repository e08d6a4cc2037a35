// Ground: what geostatic stresses take from a scene, and whether the ground is at rest in its first step.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

#include <arenite/core/warning.hpp>
#include <arenite/particles/body.hpp>
#include <arenite/scene/parts.hpp>
#include <arenite/scene/roles.hpp>

namespace arenite::inline ARENITE_INSTRUCTION_SET {

/// A body whose stress is that of a ground at rest, until the first step has shown whether it is.
struct GroundAtRest {
  std::size_t body;
  int per_cell;
  bool even;
  std::array<double, 3> gravity;  ///< m/s2
  InitialStress stress;           ///< as the position has it
};

namespace detail {

/// Gravity for geostatic stresses, (x, y, z), m/s2: accelerations and body forces at a time, s. Throws
/// `error` unless it is the same everywhere.
template <class Scene>
std::array<double, 3> gravity_of_ground(const Scene& scene, double time) {
  using V = typename Scene::V;
  V uniform = V::Zero(), of_place = V::Zero();
  scene.for_each_part([&](const auto& part) {
    using P = std::remove_cvref_t<decltype(part)>;
    if constexpr (accelerates<P, Scene>) uniform += part.acceleration(time);
    if constexpr (requires { part.acceleration_at(of_place, time); }) {
      const auto at = [&](Index i) {
        return V(part.acceleration_at(Scene::Shape::node_position(scene.mesh, i), time));
      };
      const V first = at(0);
      for (Index i = 1; i < Scene::Shape::node_count(scene.mesh); ++i)
        require((at(i) - first).norm() <= 1e-6 * first.norm(), "Geostatic: body force", vector_text(at(i)),
                {"must be the same everywhere, as at the first node, ", vector_text(first),
                            " m/s2: give the stress as a function of the position"});
      of_place += first;
    }
  });
  return in_space<typename Scene::T, Scene::D>(V(uniform + of_place));
}

/// The ground of each body of a recipe: gravity, and the layers above it. A layer is another body with a
/// geostatic stress, whose region lies wholly above.
template <class Scene, class... Fills>
std::vector<Ground> grounds_of(const Scene& scene, const Bodies<Fills...>& recipe) {
  constexpr std::size_t D = Scene::D;
  std::vector<Ground> grounds(sizeof...(Fills));
  const auto is_geostatic = [](const auto& fill) {
    return fill.options.stress && fill.options.stress->geostatic();
  };
  const auto any = [&](const auto&... fill) { return (is_geostatic(fill) || ...); };
  if (!std::apply(any, recipe.fills)) return grounds;
  const Ground common{.gravity = gravity_of_ground(scene, 0)};
  const std::size_t vertical = common.axis();
  std::vector<Ground::Layer> layers;
  const auto add = [&](const auto& fill) {
    constexpr double inf = std::numeric_limits<double>::infinity();
    Ground::Layer layer{fill.law.density(), {-inf, -inf, -inf}, {inf, inf, inf}};
    for (std::size_t k = 0; k < D && fill.region.test; ++k)
      layer.lower[k] = fill.region.lower[k], layer.upper[k] = fill.region.upper[k];
    if constexpr (is_simplex_mesh<typename Scene::Mesh> && !Scene::is_portion)
      if (!fill.region.test) {
        std::swap(layer.lower, layer.upper);
        const auto numbers = region_numbers(scene.mesh, fill.region);
        for (Index c = 0; c < scene.mesh.cell_count(); ++c)
          if (std::ranges::count(numbers, scene.mesh.region(c)))
            for (const Index i : scene.mesh.nodes(c))
              for (std::size_t k = 0; k < D; ++k) {
                const auto x = static_cast<double>(scene.mesh.position(i)[static_cast<int>(k)]);
                layer.lower[k] = std::min(layer.lower[k], x);
                layer.upper[k] = std::max(layer.upper[k], x);
              }
      }
    layers.push_back(layer);
  };
  std::apply([&](const auto&... fill) { (add(fill), ...); }, recipe.fills);
  const double close = 1e-6 * static_cast<double>(scene.mesh.size(0));
  std::size_t number = 0;
  const auto fit = [&](const auto& fill) {
    Ground& ground = grounds[number];
    const auto& own = layers[number++];
    if (!is_geostatic(fill)) return;
    ground = common;
    std::size_t other = 0;
    const auto cover = [&](const auto& of) {
      const auto& layer = layers[other++];
      if (&of == static_cast<const void*>(&fill) || !is_geostatic(of)) return;
      if (common.gravity[vertical] < 0 ? layer.lower[vertical] >= own.upper[vertical] - close
                                       : layer.upper[vertical] <= own.lower[vertical] + close)
        ground.above.push_back(layer);
    };
    std::apply([&](const auto&... of) { (cover(of), ...); }, recipe.fills);
  };
  std::apply([&](const auto&... fill) { (fit(fill), ...); }, recipe.fills);
  return grounds;
}

/// The bodies of a new scene that are to be at rest. Jittered points are not: their sums are those of a
/// random rule.
template <class M, class... Fills>
std::vector<GroundAtRest> grounds_at_rest(const Bodies<Fills...>& recipe,
                                          const std::vector<Ground>& grounds) {
  std::vector<GroundAtRest> at_rest;
  bool may_move = false;
  std::size_t number = 0;
  const auto add = [&](const auto& fill) {
    const std::size_t body = number++;
    const auto& o = fill.options;
    if (!o.stress || !o.stress->geostatic()) return;
    const Ground& ground = grounds[body];
    may_move = may_move || o.jitter > 0 || o.stress->geostatic()->may_move;
    at_rest.push_back({body, o.template points_in_cell<M>(), o.even, ground.gravity,
                       o.stress->in(ground, fill.law.density())});
  };
  std::apply([&](const auto&... fill) { (add(fill), ...); }, recipe.fills);
  if (may_move) at_rest.clear();
  return at_rest;
}

/// Places of the Gauss points of what a point stands for from its middle, m: two along each axis of a grid,
/// one more than dimensions in a simplex. `volume` of the matter, m^D: a part of a sub-cell is one of its
/// height along the axis `vertical`.
template <class M>
std::vector<typename M::Point> gauss_offsets(const M& mesh, Index cell, const GroundAtRest& ground,
                                             [[maybe_unused]] typename M::scalar volume,
                                             [[maybe_unused]] int vertical) {
  using T = typename M::scalar;
  constexpr int D = M::dimension;
  std::vector<typename M::Point> offsets;
  if constexpr (is_simplex_mesh<M>) {
    typename M::Point centre = M::Point::Zero();
    for (const Index i : mesh.nodes(cell)) centre += mesh.position(i) / static_cast<T>(D + 1);
    const auto scale = static_cast<T>(std::pow(ground.per_cell, -1.0 / D) / std::sqrt(D + 2.0));
    for (const Index i : mesh.nodes(cell)) offsets.push_back(scale * (mesh.position(i) - centre));
  } else {
    const auto along = ground.even ? even_counts<T, D>(ground.per_cell, mesh.extent(cell))
                                   : lattice_counts<D>(ground.per_cell);
    typename M::Point edges = mesh.extent(cell);
    for (int k = 0; k < D; ++k) edges[k] /= static_cast<T>(along[static_cast<std::size_t>(k)]);
    edges[vertical] *= volume / edges.prod();
    for (int corner = 0; corner < 1 << D; ++corner) {
      typename M::Point x = edges / static_cast<T>(2 * std::sqrt(3.0));
      for (int k = 0; k < D; ++k)
        if (corner >> k & 1) x[k] = -x[k];
      offsets.push_back(x);
    }
  }
  return offsets;
}

/// What the points' sums over the nodes leave of forces that are in balance, N, [nodes]: those sums less the
/// integrals over the points' sub-cells. A midpoint rule is not exact for splines cut off at the surface and
/// at walls. `asked`: [nodes] for which it is to be known.
template <class Scene>
std::vector<typename Scene::V> sum_errors(const Scene& scene, const std::vector<char>& asked) {
  using K = typename Scene::Kinematics;
  using T = typename Scene::T;
  using V = typename Scene::V;
  constexpr int D = Scene::D;
  std::vector<V> error(Scene::Shape::node_count(scene.mesh), V::Zero());
  const auto& g = scene.at_rest.front().gravity;
  const auto vertical = static_cast<int>(Ground{.gravity = g}.axis());
  std::size_t number = 0;
  scene.for_each_body([&](const auto& body, const auto&) {
    const auto of_body = std::ranges::find(scene.at_rest, number++, &GroundAtRest::body);
    if (of_body == scene.at_rest.end()) return;
    const auto& points = body.points;
    for (std::size_t p = 0; p < points.size(); ++p) {
      const Index c = points.cell[p];
      const typename Scene::Shape::template Cell<typename Scene::Mesh> cell(scene.mesh, c);
      if (std::ranges::none_of(cell.nodes, [&](Index i) { return asked[i] != 0; })) continue;
      const V middle = points.position[p];
      const auto add = [&](const V& x, const Sym<T, D>& stress, T share) {
        const T volume = share * points.volume[p] * K::thickness(x) / K::thickness(middle);
        const auto w = cell.weights(x);
        const auto gradient = cell.gradients(x);
        for (int i = 0; i < cell.size; ++i) {
          V& force = error[cell.nodes[static_cast<std::size_t>(i)]];
          for (int a = 0; a < D; ++a) {
            force[a] += volume * static_cast<T>(body.law.density() * g[static_cast<std::size_t>(a)]) * w[i];
            for (int b = 0; b < D; ++b) force[a] -= volume * stress(a, b) * gradient(b, i);
          }
          if (K::hoop) force[0] -= volume * stress[2] * w[i] / x[0];
        }
      };
      add(middle, points.stress[p], 1);
      const auto offsets =
          gauss_offsets(scene.mesh, c, *of_body, points.volume[p] / K::thickness(middle), vertical);
      for (const V& offset : offsets) {
        const V x = middle + offset;
        add(x, of_body->stress.at(x), T(-1) / static_cast<T>(offsets.size()));
      }
    }
  });
  return error;
}

/// Forces that move the nodes in a first step of a scene from rest, N, [nodes]; none if there is nothing to
/// check.
template <class Scene>
std::vector<typename Scene::V> forces_from_rest(const Scene& scene, double dt) {
  using V = typename Scene::V;
  std::vector<V> force;
  if (scene.at_rest.empty() || scene.steps > 0) return force;
  force.assign(scene.fields[0].size(), V::Zero());
  for (const auto& field : scene.fields)
    for (std::size_t i = 0; i < field.size(); ++i)
      if (field.mass[i] > 0)
        force[i] += field.mass[i] * field.velocity[i] / static_cast<typename Scene::T>(dt);
  return force;
}

/// Warns if ground that is to be at rest is not: if forces out of balance at its nodes, beyond what the
/// points' sums leave of them, are above a thousandth of its weight. `before`: the forces without contact.
/// Nodes do not count in cells where contact with walls and rigid bodies changes them, which may hold the
/// ground or set out to move it, nor those that other bodies in motion reach.
template <class Scene>
void check_rest(Scene& scene, double dt, const std::vector<typename Scene::V>& before) {
  if (before.empty()) return;
  const auto is_still = [](const auto& body) {
    for (std::size_t p = 0; p < body.points.size(); ++p)
      if (body.points.velocity[p] != Scene::V::Zero()) return false;
    return true;
  };
  std::vector<char> counts(before.size(), 0);
  const auto mark = [&](const auto& body, char as) {
    for (Index c = 0; c < scene.mesh.cell_count(); ++c)
      if (!body.cells.empty(c))
        for (const Index i : typename Scene::Shape::template Cell<typename Scene::Mesh>(scene.mesh, c).nodes)
          counts[i] = as;
  };
  bool still = true;
  for (const bool moving : {false, true}) {  // what moves has the last word
    std::size_t number = 0;
    scene.for_each_body([&](const auto& body, const auto&) {
      const bool is_ground =
          std::ranges::find(scene.at_rest, number++, &GroundAtRest::body) != scene.at_rest.end();
      const bool moves = !is_still(body);
      still = still && !(is_ground && moves);
      if (!moving && is_ground) mark(body, 1);
      if (moving && moves) mark(body, 0);
    });
  }
  if (still) {
    const auto after = forces_from_rest(scene, dt);
    const double g = in_scene<Scene::D>(scene.at_rest.front().gravity).norm();
    double weight = 0;
    for (const auto& field : scene.fields)
      for (std::size_t i = 0; i < field.size(); ++i)
        if (counts[i]) weight += static_cast<double>(field.mass[i]) * g;
    const double little = 1e-6 * weight / static_cast<double>(before.size());
    const auto changed = [&](Index i) { return static_cast<double>((after[i] - before[i]).norm()) > little; };
    for (Index c = 0; c < scene.mesh.cell_count(); ++c) {
      const auto nodes = typename Scene::Shape::template Cell<typename Scene::Mesh>(scene.mesh, c).nodes;
      if (std::ranges::any_of(nodes, changed))
        for (const Index i : nodes) counts[i] = 0;
    }
    const auto out = [&](std::size_t i) { return counts[i] ? static_cast<double>(after[i].norm()) : 0.0; };
    double all = 0, most = 0;
    for (std::size_t i = 0; i < before.size(); ++i) all += out(i);
    std::size_t worst = 0;
    if (all > 1e-3 * weight) {
      std::vector<char> asked;
      for (std::size_t i = 0; i < before.size(); ++i) asked.push_back(out(i) > little);
      const auto error = sum_errors(scene, asked);
      all = 0;
      for (std::size_t i = 0; i < before.size(); ++i) {
        const double force = std::max(0.0, out(i) - 1.01 * static_cast<double>(error[i].norm()));
        all += force;
        if (force > most) most = force, worst = i;
      }
    }
    if (all > 1e-3 * weight)
      warn(joined_text({"the ground is not at rest: in the first step ", std::round(1000 * all / weight) / 10,
                       " % of its weight is out of balance, most of it about ",
                       vector_text(Scene::Shape::node_position(scene.mesh, static_cast<Index>(worst))),
                       " m. Stress is Geostatic: do walls hold the sides and the bottom, is "
                       "Geostatic.surface where matter "
                       "ends and level, is all that lies on the ground in Geostatic.surcharge, or has it a "
                       "Geostatic of its "
                       "own? Ground that is meant to move: Geostatic.may_move"}));
  }
  scene.at_rest.clear();
}

}  // namespace detail
}  // namespace arenite::inline ARENITE_INSTRUCTION_SET
