// Loaded faces of a simplex mesh: nodal forces from the integrals of the shape functions over them.
#pragma once
// SPDX-License-Identifier: BSD-3-Clause

#include <algorithm>
#include <array>
#include <string_view>
#include <utility>
#include <vector>

#include <arenite/load/mesh_faces.hpp>
#include <arenite/load/node_force.hpp>
#include <arenite/load/surface_load.hpp>
#include <arenite/parallel/failure.hpp>

namespace arenite::inline ARENITE_INSTRUCTION_SET {

/// Samples of the faces: points of a quadrature, and for each node the weights of the samples in its
/// integral.
template <class T, int D>
class SimplexFaces {
 public:
  template <class Scene>
  SimplexFaces(const Scene& scene, const MeshFaces& where) {
    const auto is_meant = face_test(scene, where);
    std::vector<std::pair<Index, Weight>> found;
    for_each_hull_face(scene, [&](const HullFace<T, D>& face) {
      if (!is_meant(face)) return;
      ++faces_;
      for (std::size_t k = 0; k < 3; ++k) {
        const Sample sample = sample_of(face.node, k);
        for (std::size_t i = 0; i < dim; ++i)
          found.push_back({face.node[i], {static_cast<Index>(samples_.size()), sample.at[i]}});
        samples_.push_back(sample);
      }
    });
    force_.resize(samples_.size());
    std::ranges::stable_sort(found, {}, [](const auto& f) { return f.first; });
    for (const auto& [node, weight] : found) {
      if (nodes_.empty() || nodes_.back() != node) {
        nodes_.push_back(node);
        start_.push_back(weights_.size());
      }
      weights_.push_back(weight);
    }
    start_.push_back(weights_.size());
  }
  std::size_t size() const { return faces_; }

  /// Forces of a load on the faces where the mesh is now, into those of each field; matter of several fields
  /// at a node carries them in proportion to its mass. At a node without matter the load is lost.
  template <class Scene>
  void collect(const Scene& scene, const SurfaceLoad& load, std::string_view name,
               std::vector<NodeForce<T, D>>& nodes) {
    Failure failure;
    parallel_chunks(samples_.size(), [&](std::size_t begin, std::size_t end) {
      for (std::size_t s = begin; s < end; ++s) {
        std::array<Vec<T, D>, dim> corner;
        Vec<T, D> x = Vec<T, D>::Zero();
        for (std::size_t i = 0; i < dim; ++i) {
          corner[i] = scene.mesh.position(samples_[s].node[i]);
          x += samples_[s].at[i] * corner[i];
        }
        const Vec<T, D> area = samples_[s].share * Scene::Kinematics::thickness(x) * face_area(corner);
        failure.guard(s, [&] { force_[s] = load.force(x, area, scene.time, name); });
      }
    });
    failure.rethrow();
    if constexpr (Scene::is_portion) nodes[0].clear(scene.fields[0].size());  // others add to more nodes
    parallel_chunks(nodes_.size(), [&](std::size_t begin, std::size_t end) {
      for (std::size_t k = begin; k < end; ++k) {
        nodes[0].force[nodes_[k]] = force_at(k);
      }
    });
    nodes[0].sum(scene);
    share(scene.fields, nodes);
  }

  /// Sums of the magnitudes of the load that was collected last at all nodes, and at those with matter, N.
  template <class Scene>
  std::pair<double, double> magnitudes(const Scene& scene, const SurfaceLoad&, std::string_view) const {
    std::pair<double, double> sum{};
    for (std::size_t k = 0; k < nodes_.size(); ++k) {
      const auto size = static_cast<double>(force_at(k).norm());
      sum.first += size;
      if (std::ranges::any_of(scene.fields,
                              [&](const auto& field) { return field.sums[nodes_[k]].mass() > 0; }))
        sum.second += size;
    }
    return sum;
  }

 private:
  /// Force, N, at loaded node number k from the samples that were collected last.
  Vec<T, D> force_at(std::size_t k) const {
    Vec<T, D> sum = Vec<T, D>::Zero();
    for (std::size_t w = start_[k]; w < start_[k + 1]; ++w)
      sum += weights_[w].second * force_[weights_[w].first];
    return sum;
  }
  static constexpr auto dim = static_cast<std::size_t>(D);
  using Weight = std::pair<Index, T>;  // sample, value of the node's function there
  struct Sample {
    std::array<Index, dim> node;
    std::array<T, dim> at;  // barycentric coordinates
    T share;                // of the face's area
  };

  /// Gauss's on an edge, exact to the fifth degree; on a triangle exact to the second.
  static Sample sample_of(const std::array<Index, dim>& node, std::size_t k) {
    Sample sample{node, {}, T(1) / 3};
    if constexpr (D == 2) {
      constexpr double arm = 0.3872983346207417;  // sqrt(3 / 5) / 2
      sample.at[1] = static_cast<T>(k == 0 ? 0.5 - arm : k == 1 ? 0.5 : 0.5 + arm);
      sample.at[0] = 1 - sample.at[1];
      sample.share = k == 1 ? T(4) / 9 : T(5) / 18;
    } else {
      sample.at.fill(T(1) / 6);
      sample.at[k] = T(2) / 3;
    }
    return sample;
  }

  template <class Fields>
  static void share(const Fields& fields, std::vector<NodeForce<T, D>>& nodes) {
    for (std::size_t i = 0; i < fields[0].size(); ++i) {
      const Vec<T, D> whole = nodes[0].force[i];
      if ((whole.array() == 0).all()) continue;
      T all = 0;
      for (const auto& field : fields) all += field.sums[i].mass();
      for (std::size_t k = 0; k < fields.size(); ++k)
        nodes[k].force[i] =
            all > 0 ? Vec<T, D>(fields[k].sums[i].mass() / all * whole) : Vec<T, D>(Vec<T, D>::Zero());
    }
  }

  std::size_t faces_ = 0;
  std::vector<Sample> samples_;
  std::vector<Vec<T, D>> force_;    // [samples] N
  std::vector<Index> nodes_;        // loaded ones, ascending
  std::vector<std::size_t> start_;  // [loaded nodes + 1]
  std::vector<Weight> weights_;
};

}  // namespace arenite::inline ARENITE_INSTRUCTION_SET
