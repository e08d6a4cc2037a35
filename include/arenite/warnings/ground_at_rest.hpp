// Ground at rest: bodies with geostatic initial stress, checked for equilibrium in the first step.
#pragma once
// SPDX-License-Identifier: BSD-3-Clause

#include <array>
#include <cmath>
#include <cstddef>
#include <span>
#include <vector>

#include <arenite/core/cold.hpp>
#include <arenite/parallel/communicator.hpp>
#include <arenite/warnings/ground.hpp>

namespace arenite::inline ARENITE_INSTRUCTION_SET {

/// A body with geostatic initial stress, until the first step has checked its equilibrium.
struct GroundAtRest {
  std::size_t body;
  int per_cell;
  bool even;
  double jitter;
  std::array<double, 3> gravity;  ///< m/s2
  InitialStress stress;           ///< by position
};

namespace shared_detail {

std::vector<GroundAtRest> grounds_at_rest(std::span<const GroundFill> fills,
                                          const std::vector<Ground>& grounds, int per_cell);

/// The bodies of a new scene to be checked for equilibrium.
template <class M, class Recipe>
std::vector<GroundAtRest> grounds_at_rest(const Recipe& recipe, const std::vector<Ground>& grounds) {
  return grounds_at_rest(ground_fills(recipe), grounds, FillOptions{}.template points_in_cell<M>());
}

/// Offsets of the Gauss points of a point's sub-cell from its middle, m: two along each axis of a grid, D + 1
/// in a simplex. `volume` of the matter, m^D: a partly filled sub-cell is reduced in height, along
/// the axis `vertical`.
template <class T, int D>
Places<Vec<T, D>> gauss_offsets(const CellBox<T, D>& cell, const GroundAtRest& ground, T volume,
                                int vertical);
template <class M>
Places<typename M::Point> gauss_offsets(const M& mesh, Index cell, const GroundAtRest& ground,
                                        [[maybe_unused]] typename M::scalar volume,
                                        [[maybe_unused]] int vertical) {
  if constexpr (is_simplex_mesh<M>) {
    using T = typename M::scalar;
    constexpr int D = M::dimension;
    Places<typename M::Point> offsets;
    auto centre = zeros<typename M::Point>();
    for (const Index i : mesh.nodes(cell)) centre += mesh.position(i) / static_cast<T>(D + 1);
    const auto scale = static_cast<T>(std::pow(ground.per_cell, -1.0 / D) / std::sqrt(D + 2.0));
    for (const Index i : mesh.nodes(cell)) offsets.push_back(scale * (mesh.position(i) - centre));
    return offsets;
  } else {
    return gauss_offsets(cell_box(mesh, cell), ground, volume, vertical);
  }
}

/// A shape function in a cell as lists.
template <class T, int D>
struct ListedShape {
  std::vector<Index> nodes;
  std::vector<T> weight, gradient;  // -, and [nodes x D], 1/m
};

/// A scene after its first step from rest, as the check of its ground reads it.
template <class T, int D>
class RestingScene {
 public:
  using V = Vec<T, D>;
  struct OfBody {
    const VectorColumns<T, D>*position, *velocity;
    const Column<T>* volume;
    const TensorColumns<T, D>* stress;
    const std::vector<Index>* cell;
    double density;
  };

  /// Nodes of a cell; with a position, m, also weights and gradients there.
  virtual void shape(Index cell, const V* x, ListedShape<T, D>& shape) const = 0;
  virtual Places<V> offsets(Index cell, const GroundAtRest& ground, T volume, int vertical) const = 0;
  virtual T thickness(const V& x) const = 0;
  virtual V node_position(Index node) const = 0;
  /// Of the whole, where its mesh is cut (see `Communicator`).
  virtual bool owns(Index node) const = 0;
  virtual void sum_nodes(std::span<T> values, std::size_t count) const = 0;
  virtual void sum(std::span<double> values) const = 0;
  virtual std::vector<double> gather(std::vector<double> numbers) const = 0;
  virtual bool speaks() const = 0;

  std::span<const OfBody> bodies{};
  std::span<const GroundAtRest> at_rest{};
  std::span<const std::span<const T>> masses{};  // of each field, kg
  std::vector<V> before{}, after{};              // forces, N, [nodes]
  Index cell_count = 0;
  bool hoop = false;
};

/// Warns if ground that is to be at rest is not: if unbalanced forces at its nodes, beyond the errors of the
/// points' sums (`sum_errors`), exceed a thousandth of its weight. `before`: the forces without contact.
/// Not counted are nodes of cells where contact with walls and rigid bodies changes forces, as these may
/// support the ground or start to move it, and nodes that other moving bodies reach. Scenes over the portions
/// of one mesh call it at once.
template <class T, int D>
void check_rest(const RestingScene<T, D>& scene);

template <class Scene>
class RestingSceneOf final : public RestingScene<typename Scene::T, Scene::D> {
 public:
  using T = typename Scene::T;
  using V = typename Scene::V;

  explicit RestingSceneOf(const Scene& scene) : scene_{scene} {}
  void shape(Index c, const V* x, ListedShape<T, Scene::D>& shape) const override {
    const typename Scene::Shape::template Cell<typename Scene::Mesh> cell(scene_.mesh, c);
    shape.nodes.assign(cell.nodes.begin(), cell.nodes.end());
    if (!x) return;
    const auto w = cell.weights(*x);
    const auto gradient = cell.gradients(*x);
    shape.weight.resize(shape.nodes.size());
    shape.gradient.resize(shape.nodes.size() * Scene::D);
    std::size_t next = 0;
    for (int i = 0; i < cell.size; ++i) {
      shape.weight[static_cast<std::size_t>(i)] = w[i];
      for (int b = 0; b < Scene::D; ++b) shape.gradient[next++] = gradient(b, i);
    }
  }
  Places<V> offsets(Index cell, const GroundAtRest& ground, T volume, int vertical) const override {
    return gauss_offsets(scene_.mesh, cell, ground, volume, vertical);
  }
  T thickness(const V& x) const override { return Scene::Kinematics::thickness(x); }
  V node_position(Index node) const override { return Scene::Shape::node_position(scene_.mesh, node); }
  bool owns(Index node) const override { return scene_.node_owner()(node); }
  void sum_nodes([[maybe_unused]] std::span<T> values, [[maybe_unused]] std::size_t count) const override {
    if constexpr (Scene::is_portion) scene_.communicator().sum_nodes(values, count);
  }
  void sum([[maybe_unused]] std::span<double> values) const override {
    if constexpr (Scene::is_portion) scene_.communicator().sum(values);
  }
  std::vector<double> gather(std::vector<double> numbers) const override {
    if constexpr (Scene::is_portion) return scene_.communicator().gather(numbers);
    return numbers;
  }
  bool speaks() const override { return is_reporter(scene_); }

 private:
  const Scene& scene_;
};

/// Forces that move the nodes in a first step of a scene from rest, N, [nodes]; none if there is nothing to
/// check.
template <class Scene>
std::vector<typename Scene::V> forces_from_rest(const Scene& scene, double dt) {
  std::vector<typename Scene::V> force;
  if (scene.at_rest.empty() || scene.steps > 0) return force;
  force.assign(scene.fields[0].size(), zeros<typename Scene::V>());
  for (const auto& field : scene.fields)
    for (std::size_t i = 0; i < field.size(); ++i)
      if (field.mass[i] > 0)
        for (int k = 0; k < Scene::D; ++k)
          force[i][k] += field.mass[i] * field.velocity[i][k] / static_cast<typename Scene::T>(dt);
  return force;
}

/// `check_rest` of a scene.
template <class Scene>
void check_rest(Scene& scene, double dt, const std::vector<typename Scene::V>& before) {
  if (before.empty()) return;
  RestingSceneOf<Scene> resting(scene);
  resting.at_rest = scene.at_rest;
  resting.before = before;
  resting.after = forces_from_rest(scene, dt);
  resting.cell_count = scene.mesh.cell_count();
  resting.hoop = Scene::Kinematics::hoop;
  auto masses = by_body<std::span<const typename Scene::T>, Scene::field_count>(scene.fields.size());
  for (std::size_t f = 0; f < masses.size(); ++f) masses[f] = scene.fields[f].mass;
  auto bodies = by_body<typename RestingSceneOf<Scene>::OfBody, Scene::body_count>(scene.number_of_bodies());
  std::size_t number = 0;
  scene.for_each_body([&](const auto& body, const auto&) {
    const auto& p = body.points;
    bodies[number++] = {&p.position, &p.velocity, &p.volume, &p.stress, &p.cell, body.law.density()};
  });
  resting.masses = masses;
  resting.bodies = bodies;
  check_rest<typename Scene::T, Scene::D>(resting);
  scene.at_rest.clear();
}

}  // namespace shared_detail
}  // namespace arenite::inline ARENITE_INSTRUCTION_SET

#if ARENITE_HAS_COLD

#include <algorithm>
#include <string>
#include <utility>

#include <arenite/core/warning.hpp>

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

#endif  // ARENITE_HAS_COLD
