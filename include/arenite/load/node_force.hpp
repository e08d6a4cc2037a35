// Node force: what a load adds to the nodes of a field in a step, and the work of that.
#pragma once

#include <functional>
#include <vector>

#include <arenite/core/alone.hpp>
#include <arenite/transfer/node_field.hpp>

namespace arenite::inline ARENITE_INSTRUCTION_SET {

/// Forces of one load at all nodes of the mesh.
template <class T, int D>
class NodeForce {
 public:
  NodeVectors<T, D> force;  ///< [nodes] N, of this step

  /// Sets them to zero.
  void clear(std::size_t nodes) {
    if (force.size() != nodes) force.assign(nodes, zeros<Vec<T, D>>());
    parallel_chunks(nodes, [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i) force[i] = zeros<Vec<T, D>>();
    });
  }

  /// Each copy of a node that several scenes share gets the sum of what they put there.
  template <class Others>
  void sum([[maybe_unused]] Others& others) {
    if constexpr (!Others::alone) others.sum_nodes(force.numbers(), force.numbers().size() / force.size());
  }

  /// Adds them to a field.
  template <class Field>
  void add_to(Field& field) const {
    parallel_chunks(force.size(), [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i)
        if (acts_at(i)) field.collected[i].add_force(force[i]);
    });
  }

  /// Work in the step dt, J, at the nodes that `owns(node)`: forces times the mean of the velocities at its
  /// begin and end, so that matter gains just this kinetic energy from them.
  template <class Field, class Owns>
  double work(const Field& field, double dt, const Owns& owns) const {
    return work(dt, owns, [&](std::size_t i) { return ((field.start[i] + field.velocity[i]) / 2).eval(); });
  }
  /// The same with `mean(node)`, a mean velocity over the step, m/s.
  template <class Owns, class Mean>
  double work(double dt, const Owns& owns, const Mean& mean) const {
    return parallel_reduce(
        force.size(), 0.0,
        [&](std::size_t begin, std::size_t end) {
          double sum = 0;
          for (std::size_t i = begin; i < end; ++i)
            if (acts_at(i) && owns(static_cast<Index>(i)))
              sum += static_cast<double>(force[i].dot(mean(i))) * dt;
          return sum;
        },
        std::plus<>{});
  }

  /// N, [D].
  Vec<T, D> total() const {
    Vec<T, D> sum = zeros<Vec<T, D>>();
    for (const auto& f : force) sum += f;
    return sum;
  }

 private:
  bool acts_at(std::size_t i) const { return (force[i].array() != 0).any(); }
};

/// Forces of one load in each field of a scene.
template <class T, int D>
class FieldForces {
 public:
  std::vector<NodeForce<T, D>> field;  ///< [fields]

  /// Makes them, all zero.
  template <class Scene>
  void connect(const Scene& scene) {
    field.resize(scene.fields.size());
    for (auto& nodes : field) nodes.clear(scene.fields[0].size());
  }
  template <class Scene>
  void add_to(Scene& scene) const {
    for (std::size_t k = 0; k < field.size(); ++k) field[k].add_to(scene.fields[k]);
  }
  /// Work in the step dt, J, at the nodes that the scene owns.
  template <class Scene>
  double work(const Scene& scene, double dt) const {
    double sum = 0;
    for (std::size_t k = 0; k < field.size(); ++k)
      sum += field[k].work(scene.fields[k], dt, scene.node_owner());
    return sum;
  }
  /// The same of forces that act as impulses behind the grid update, once `mean_velocity` is known.
  template <class Scene>
  double work_of_impulses(const Scene& scene, double dt) const {
    double sum = 0;
    for (std::size_t k = 0; k < field.size(); ++k)
      sum += field[k].work(dt, scene.node_owner(),
                           [&](std::size_t i) { return scene.fields[k].mean_velocity(i); });
    return sum;
  }
  /// N, [D].
  Vec<T, D> total() const {
    Vec<T, D> sum = zeros<Vec<T, D>>();
    for (const auto& nodes : field) sum += nodes.total();
    return sum;
  }
};

}  // namespace arenite::inline ARENITE_INSTRUCTION_SET
