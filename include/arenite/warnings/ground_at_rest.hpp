// Ground at rest: bodies with geostatic initial stress, checked for equilibrium in the first step.
#pragma once
// SPDX-License-Identifier: BSD-3-Clause

#include <array>
#include <cmath>
#include <cstddef>
#include <span>
#include <vector>

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

#ifndef ARENITE_COLD_LIBRARY
#include <arenite/warnings/ground_at_rest_cold.hpp>
#endif
