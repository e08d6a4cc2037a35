// Cold functions of ground_at_rest.hpp.
#pragma once
// SPDX-License-Identifier: BSD-3-Clause

#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include <arenite/core/warning.hpp>
#include <arenite/warnings/ground_at_rest.hpp>

namespace arenite::inline ARENITE_INSTRUCTION_SET {
namespace shared_detail {

ARENITE_COLD std::vector<GroundAtRest> grounds_at_rest(std::span<const GroundFill> fills,
                                                       const std::vector<Ground>& grounds, int per_cell) {
  std::vector<GroundAtRest> at_rest;
  bool may_move = false;
  for (std::size_t f = 0; f < fills.size(); ++f) {
    if (!fills[f].is_geostatic()) continue;
    const FillOptions& o = *fills[f].options;
    may_move = may_move || o.stress->geostatic()->may_move;
    at_rest.push_back({f, o.per_cell.value_or(per_cell), o.even, o.jitter, grounds[f].gravity,
                       o.stress->in(grounds[f], fills[f].layer.density)});
  }
  if (may_move) at_rest.clear();
  return at_rest;
}

template <class T, int D>
ARENITE_COLD Places<Vec<T, D>> gauss_offsets(const CellBox<T, D>& cell, const GroundAtRest& ground, T volume,
                                             int vertical) {
  Places<Vec<T, D>> offsets;
  const auto along =
      ground.even ? even_counts<T, D>(ground.per_cell, cell.extent) : lattice_counts<D>(ground.per_cell);
  Vec<T, D> edges = cell.extent;
  for (int k = 0; k < D; ++k) edges[k] /= static_cast<T>(along[static_cast<std::size_t>(k)]);
  edges[vertical] *= volume / edges.prod();
  for (int corner = 0; corner < 1 << D; ++corner) {
    Vec<T, D> x;
    for (int k = 0; k < D; ++k) {
      x[k] = edges[k] / static_cast<T>(2 * std::sqrt(3.0));
      if (corner >> k & 1) x[k] = -x[k];
    }
    offsets.push_back(x);
  }
  return offsets;
}

/// Which of the bodies at rest a body is; null: none.
ARENITE_COLD const GroundAtRest* ground_of_body(std::span<const GroundAtRest> at_rest, std::size_t body) {
  for (const GroundAtRest& ground : at_rest)
    if (ground.body == body) return &ground;
  return nullptr;
}

/// Errors of the points' sums over the nodes for forces in equilibrium, N, [nodes]: those sums minus the
/// integrals over the points' sub-cells. A midpoint rule is not exact for splines cut off at the surface and
/// at walls. `asked`: [nodes] whose error is needed.
template <class T, int D>
ARENITE_COLD std::vector<Vec<T, D>> sum_errors(const RestingScene<T, D>& scene,
                                               const std::vector<char>& asked) {
  using V = Vec<T, D>;
  std::vector<V> error(asked.size(), zeros<V>());
  const auto& g = scene.at_rest.front().gravity;
  const auto vertical = static_cast<int>(Ground{.gravity = g}.axis());
  ListedShape<T, D> shape;
  for (std::size_t number = 0; number < scene.bodies.size(); ++number) {
    const GroundAtRest* const ground = ground_of_body(scene.at_rest, number);
    if (!ground || ground->jitter > 0) continue;
    const auto& body = scene.bodies[number];
    for (std::size_t p = 0; p < body.cell->size(); ++p) {
      const Index c = (*body.cell)[p];
      scene.shape(c, nullptr, shape);
      bool is_asked = false;
      for (const Index i : shape.nodes) is_asked = is_asked || asked[i] != 0;
      if (!is_asked) continue;
      const V middle = (*body.position)[p];
      const auto add = [&](const V& x, const Sym<T, D>& stress, T share) {
        const T volume = share * (*body.volume)[p] * scene.thickness(x) / scene.thickness(middle);
        scene.shape(c, &x, shape);
        std::array<T, D> weight;
        std::array<std::array<T, D>, D> pull;
        for (std::size_t a = 0; a < D; ++a) {
          weight[a] = volume * static_cast<T>(body.density * g[a]);
          for (std::size_t b = 0; b < D; ++b)
            pull[a][b] = volume * stress(static_cast<int>(a), static_cast<int>(b));
        }
        const T hoop = scene.hoop ? volume * stress[2] : T(0);
        const T* gradient = shape.gradient.data();
        for (std::size_t i = 0; i < shape.nodes.size(); ++i, gradient += D) {
          T* const force = error[shape.nodes[i]].data();
          const T w = shape.weight[i];
          for (std::size_t a = 0; a < D; ++a) {
            force[a] += weight[a] * w;
            for (std::size_t b = 0; b < D; ++b) force[a] -= pull[a][b] * gradient[b];
          }
          if (scene.hoop) force[0] -= hoop * w / x[0];
        }
      };
      add(middle, (*body.stress)[p], 1);
      const auto offsets = scene.offsets(c, *ground, (*body.volume)[p] / scene.thickness(middle), vertical);
      for (const V& offset : offsets) {
        V x;
        for (int k = 0; k < D; ++k) x[k] = middle[k] + offset[k];
        add(x, ground->stress.at(x), T(-1) / static_cast<T>(offsets.size()));
      }
    }
  }
  scene.sum_nodes(std::span(error.data()->data(), error.size() * D), D);
  return error;
}

template <class T, int D>
ARENITE_COLD void check_rest(const RestingScene<T, D>& scene) {
  const std::size_t nodes = scene.before.size();
  ListedShape<T, D> shape;
  std::vector<T> marks(2 * nodes, T(0));  // nodes that the ground reaches, and that what moves does
  double moved = 0, weight = 0, all_nodes = 0;
  for (std::size_t number = 0; number < scene.bodies.size(); ++number) {
    const auto& body = scene.bodies[number];
    const bool is_ground = ground_of_body(scene.at_rest, number) != nullptr;
    bool moves = false;
    for (int k = 0; k < D; ++k)
      for (const T v : body.velocity->column(static_cast<std::size_t>(k))) moves = moves || v != 0;
    if (is_ground && moves) moved = 1;
    if (!is_ground && !moves) continue;
    Index marked = none;
    for (const Index c : *body.cell) {
      if (c == none || c == marked) continue;
      marked = c;
      scene.shape(c, nullptr, shape);
      for (const Index i : shape.nodes) marks[2 * std::size_t{i} + (moves ? 1 : 0)] = 1;
    }
  }
  scene.sum_nodes(marks, 2);
  std::vector<char> counts(nodes), owned(nodes);
  for (std::size_t i = 0; i < nodes; ++i) {
    counts[i] = marks[2 * i] > 0 && marks[2 * i + 1] == 0;  // what moves has the last word
    owned[i] = scene.owns(static_cast<Index>(i));
    all_nodes += owned[i];
  }
  const auto norm = [](const Vec<T, D>& v) { return static_cast<double>(std::sqrt(dot(v, v))); };
  const auto& gravity = scene.at_rest.front().gravity;
  const double g = in_scene<D>(gravity).norm();
  for (const auto& mass : scene.masses)
    for (std::size_t i = 0; i < nodes; ++i)
      if (counts[i] && owned[i]) weight += static_cast<double>(mass[i]) * g;
  std::array<double, 3> of_all{moved, weight, all_nodes};
  scene.sum(of_all);
  moved = of_all[0], weight = of_all[1], all_nodes = of_all[2];
  if (moved > 0) return;
  const double little = 1e-6 * weight / all_nodes;
  std::vector<T> pressed(nodes);  // where contact changes forces
  for (Index c = 0; c < scene.cell_count; ++c) {
    scene.shape(c, nullptr, shape);
    bool changed = false;
    for (const Index i : shape.nodes) {
      Vec<T, D> change;
      for (int k = 0; k < D; ++k) change[k] = scene.after[i][k] - scene.before[i][k];
      changed = changed || norm(change) > little;
    }
    if (changed)
      for (const Index i : shape.nodes) pressed[i] = 1;
  }
  scene.sum_nodes(pressed, 1);
  for (std::size_t i = 0; i < nodes; ++i)
    if (pressed[i] > 0) counts[i] = 0;
  const auto out = [&](std::size_t i) { return counts[i] ? norm(scene.after[i]) : 0.0; };
  double all = 0;
  for (std::size_t i = 0; i < nodes; ++i)
    if (owned[i]) all += out(i);
  scene.sum(std::span(&all, 1));
  std::vector<double> worst{0, 0, 0, 0};  // force, N, and place
  if (all > 1e-3 * weight) {
    std::vector<char> asked;
    for (std::size_t i = 0; i < nodes; ++i) asked.push_back(out(i) > little);
    const auto error = sum_errors(scene, asked);
    all = 0;
    for (std::size_t i = 0; i < nodes; ++i) {
      if (!owned[i]) continue;
      const double force = std::max(0.0, out(i) - 1.01 * norm(error[i]));
      all += force;
      if (!(force > worst[0])) continue;
      const auto x = in_space(scene.node_position(static_cast<Index>(i)));
      worst = {force, x[0], x[1], x[2]};
    }
    scene.sum(std::span(&all, 1));
    worst = scene.gather(std::move(worst));
  }
  if (!(all > 1e-3 * weight) || !scene.speaks()) return;
  std::size_t at = 0;
  for (std::size_t tile = 4; tile < worst.size(); tile += 4)
    if (worst[tile] > worst[at]) at = tile;
  double jitter = 0;
  for (const GroundAtRest& ground : scene.at_rest) jitter = std::max(jitter, ground.jitter);
  const std::string random =
      jitter > 0
          ? joined_text({" Its points have a jitter of ", jitter,
                         ", and sums over random places leave forces: fill it without, or let it settle."})
          : "";
  warn(joined_text(
      {"the ground is not at rest: in the first step ", std::round(1000 * all / weight) / 10,
       " % of its weight is out of balance, most of it about ",
       vector_text(std::span(worst).subspan(at + 1, D)), " m.", random,
       " Stress is Geostatic: do walls hold the sides and the bottom, is Geostatic.surface where "
       "matter ends and level, is all that lies on the ground in Geostatic.surcharge, or has it a "
       "Geostatic of its own? Ground that is meant to move: Geostatic.may_move"}));
}

#define ARENITE_INSTANCES(T, D)                                                                \
  template Places<Vec<T, D>> gauss_offsets(const CellBox<T, D>&, const GroundAtRest&, T, int); \
  template void check_rest(const RestingScene<T, D>&);
ARENITE_FOR_NUMBERS_AND_DIMENSIONS(ARENITE_INSTANCES)
#undef ARENITE_INSTANCES

}  // namespace shared_detail
}  // namespace arenite::inline ARENITE_INSTRUCTION_SET
