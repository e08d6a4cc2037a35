// Node forces: forces of a load at the nodes of a scene, and their work. The base of loads.
#pragma once
// SPDX-License-Identifier: BSD-3-Clause

#include <functional>
#include <span>
#include <type_traits>
#include <vector>

#include <arenite/core/cold.hpp>
#include <arenite/parallel/communicator.hpp>
#include <arenite/part/part_energy.hpp>
#include <arenite/transfer/node_field.hpp>

namespace arenite::inline ARENITE_INSTRUCTION_SET {

/// Positions of the nodes of a mesh, whatever it is.
template <class T, int D>
struct NodePlaces {
  const void* mesh;
  Vec<T, D> (*position)(const void* mesh, Index node);  ///< m

  template <class Scene>
  static NodePlaces of(const Scene& scene) {
    return {&scene.mesh, [](const void* of, Index i) {
              return Vec<T, D>(Scene::Shape::node_position(*static_cast<const typename Scene::Mesh*>(of), i));
            }};
  }
  Vec<T, D> operator[](std::size_t i) const { return position(mesh, static_cast<Index>(i)); }
};

/// Velocities of the nodes of a field in a step, and which of the nodes the scene counts in sums.
template <class T, int D>
struct NodeMotion {
  const NodeVectors<T, D>* start;  ///< m/s; null: `end` is the mean over the step
  const NodeVectors<T, D>* end;    ///< m/s
  std::span<const int>
      owner{};      ///< [nodes] number of the portion of the mesh that counts the node; empty: all count
  int portion = 0;  ///< number of the scene's own

  /// With the velocities at the start and end of the step.
  template <class Scene>
  static NodeMotion of(const Scene& scene, std::size_t field) {
    return counted(scene, {&scene.fields[field].start, &scene.fields[field].velocity});
  }
  /// With those of which `NodeField::mean_velocity` is the mean.
  template <class Scene>
  static NodeMotion mean_of(const Scene& scene, std::size_t field) {
    const auto& f = scene.fields[field];
    const bool is_mean = &f.strain_velocity() == &f.mapped && f.centred;
    return counted(scene, {is_mean ? nullptr : &f.start, &f.strain_velocity()});
  }

 private:
  template <class Scene>
  static NodeMotion counted(const Scene& scene, NodeMotion motion) {
    if constexpr (Scene::is_portion) {
      motion.owner = scene.portion().node_owner;
      motion.portion = scene.portion().number;
    }
    return motion;
  }
};

/// Forces of one load at all nodes of the mesh.
template <class T, int D>
class NodeForce {
 public:
  NodeVectors<T, D> force;  ///< [nodes] N, of this step

  /// Sets them to zero.
  void clear(std::size_t nodes);
  /// Each copy of a node that several scenes share gets the sum of what they put there.
  template <class Scene>
  void sum([[maybe_unused]] const Scene& scene) {
    if constexpr (Scene::is_portion)
      scene.communicator().sum_nodes(force.numbers(), force.numbers().size() / force.size());
  }
  /// Sets them to `force_at(position, sums)`, N, at the nodes with mass, else to zero; it may throw, and runs
  /// on several threads.
  using ForceAt = std::function<Vec<T, D>(const Vec<T, D>& position, const NodeSums<T, D>& sums)>;
  void set(std::span<const NodeSums<T, D>> sums, const NodePlaces<T, D>& places, const ForceAt& force_at);
  /// Adds them to a field.
  void add_to(std::span<NodeSums<T, D>> sums) const;
  /// Work in the step dt, J, at the nodes that are counted: forces times the mean of the velocities at its
  /// start and end, so that matter gains just this kinetic energy from them.
  double work(double dt, const NodeMotion<T, D>& motion) const;
  /// N, [D].
  Vec<T, D> total() const;

 private:
  bool acts_at(std::size_t i) const { return (force[i].array() != 0).any(); }
};

/// Forces of one load in each field of a scene: the base of all loads.
template <class T, int D>
class FieldForces {
 public:
  template <class Scene>
  void connect(const Scene& scene) {
    forces_.resize(scene.fields.size());
    for (auto& nodes : forces_) nodes.clear(scene.fields[0].size());
  }
  /// Nothing rests on a load.
  bool holds_against(const Vec<T, D>&) const { return false; }
  /// Total force of the last step, N, [D].
  Vec<T, D> force() const {
    Vec<T, D> sum = zeros<Vec<T, D>>();
    for (const auto& nodes : forces_) sum += nodes.total();
    return sum;
  }

 protected:
  template <class Scene>
  void add_to(Scene& scene) const {
    for (std::size_t k = 0; k < forces_.size(); ++k) forces_[k].add_to(scene.fields[k].sums);
  }
  /// Work in the step dt, J, at the nodes that the scene counts.
  template <class Scene>
  double work(const Scene& scene, double dt) const {
    double sum = 0;
    for (std::size_t k = 0; k < forces_.size(); ++k)
      sum += forces_[k].work(dt, NodeMotion<T, D>::of(scene, k));
    return sum;
  }
  /// Work of forces that act as impulses after the grid update, once `mean_velocity` is known, J.
  template <class Scene>
  double work_of_impulses(const Scene& scene, double dt) const {
    double sum = 0;
    for (std::size_t k = 0; k < forces_.size(); ++k)
      sum += forces_[k].work(dt, NodeMotion<T, D>::mean_of(scene, k));
    return sum;
  }

  std::vector<NodeForce<T, D>> forces_;  // [fields]
};

/// The base of loads whose work is external. A load has an `add_force` that gives its forces by `act`, or
/// fills `forces_` and calls `add_to`.
template <class T, int D>
class BookedForces : public FieldForces<T, D> {
 public:
  template <class Scene>
  void follow_motion(Scene& scene, double dt) {
    work_ += this->work(scene, dt);
  }
  PartEnergy count_energy() const { return {.external = work_}; }
  template <class F>
  void visit_state(F&& f) {
    f("work", work_);
  }

 protected:
  /// Adds `force_at(position, sums)`, N, at each node with mass; see `NodeForce::set`.
  template <class Scene>
  void act(Scene& scene, const typename NodeForce<T, D>::ForceAt& force_at) {
    for (std::size_t k = 0; k < this->forces_.size(); ++k)
      this->forces_[k].set(scene.fields[k].sums, NodePlaces<T, D>::of(scene), force_at);
    this->add_to(scene);
  }

  double work_ = 0;  // since the start, J
};

}  // namespace arenite::inline ARENITE_INSTRUCTION_SET

#if ARENITE_HAS_COLD

#include <arenite/parallel/failure.hpp>

namespace arenite::inline ARENITE_INSTRUCTION_SET {

template <class T, int D>
ARENITE_COLD void NodeForce<T, D>::clear(std::size_t nodes) {
  if (force.size() != nodes) force.assign(nodes, zeros<Vec<T, D>>());
  parallel_chunks(nodes, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) force[i] = zeros<Vec<T, D>>();
  });
}

template <class T, int D>
ARENITE_COLD void NodeForce<T, D>::set(std::span<const NodeSums<T, D>> sums, const NodePlaces<T, D>& places,
                                       const ForceAt& force_at) {
  Failure failure;
  parallel_chunks(sums.size(), [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      force[i] = zeros<Vec<T, D>>();
      if (sums[i].mass() > 0) failure.guard(i, [&] { force[i] = force_at(places[i], sums[i]); });
    }
  });
  failure.rethrow();
}

template <class T, int D>
ARENITE_COLD void NodeForce<T, D>::add_to(std::span<NodeSums<T, D>> sums) const {
  parallel_chunks(force.size(), [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i)
      if (acts_at(i)) sums[i].add_force(force[i]);
  });
}

template <class T, int D>
ARENITE_COLD double NodeForce<T, D>::work(double dt, const NodeMotion<T, D>& motion) const {
  const auto& end_velocity = *motion.end;
  return parallel_reduce(
      force.size(), 0.0,
      [&](std::size_t begin, std::size_t end) {
        double sum = 0;
        for (std::size_t i = begin; i < end; ++i) {
          if (!acts_at(i) || (!motion.owner.empty() && motion.owner[i] != motion.portion)) continue;
          const Vec<T, D> mean = motion.start == nullptr
                                     ? end_velocity[i]
                                     : Vec<T, D>(((*motion.start)[i] + end_velocity[i]) / 2);
          sum += static_cast<double>(force[i].dot(mean)) * dt;
        }
        return sum;
      },
      std::plus<>{});
}

template <class T, int D>
ARENITE_COLD Vec<T, D> NodeForce<T, D>::total() const {
  Vec<T, D> sum = zeros<Vec<T, D>>();
  for (const auto& f : force) sum += f;
  return sum;
}

#define ARENITE_INSTANCES(T, D) template class NodeForce<T, D>;
ARENITE_FOR_NUMBERS_AND_DIMENSIONS(ARENITE_INSTANCES)
#undef ARENITE_INSTANCES

}  // namespace arenite::inline ARENITE_INSTRUCTION_SET

#endif  // ARENITE_HAS_COLD
