// Frictional wall: faces of the mesh on which matter slides with Coulomb friction, and from which it may
// separate.
#pragma once
// SPDX-License-Identifier: BSD-3-Clause

#include <array>
#include <string>
#include <utility>
#include <vector>

#include <arenite/boundary/constraints.hpp>
#include <arenite/contact/coulomb.hpp>
#include <arenite/contact/hold.hpp>
#include <arenite/load/mesh_faces.hpp>
#include <arenite/part/contact_tally.hpp>
#include <arenite/part/part_energy.hpp>

namespace arenite::inline ARENITE_INSTRUCTION_SET {

struct FrictionalWallOptions {
  bool separates = true;  ///< whether matter may leave the wall; else it slides on it, pulled or pressed
};

/// Fixed faces of the mesh with Coulomb friction: at each of their nodes the velocity normal to the wall is
/// set to zero, that along it reduced by at most friction times the normal impulse (`coulomb`). A wall that
/// does not separate has friction only where matter is pressed on it. A node that faces of several
/// directions share has the mean of their normals. If each side of a corner is a wall by itself, they act
/// on the node in turn, which is exact at right angles.
struct FrictionalWall {
  MeshFaces where;
  Friction friction;
  FrictionalWallOptions options;
};
/// `frictional(bottom(), Friction(20_deg))`, `frictional(left(), Friction(5_deg), {.separates = false})`
inline FrictionalWall frictional(MeshFaces where, const Friction& friction,
                                 const FrictionalWallOptions& options = {}) {
  return {std::move(where), friction, options};
}

/// Impulse, N s, of a wall on a node of a mass, kg, with a velocity, m/s; `normal`: unit, out of the wall.
template <class T, int D>
CoulombImpulse<T, D> wall_impulse(const Vec<T, D>& velocity, const Vec<T, D>& normal, T mass,
                                  const FrictionalWall& wall) {
  const T closing = velocity.dot(normal);
  if (closing < 0 || wall.options.separates) return coulomb<T, D>(velocity, normal, mass, wall.friction);
  return {-mass * closing * normal, false};
}

/// A frictional wall in a mesh: a part that gives impulses, after those of bodies and rigid bodies.
template <class T, int D>
class BoundFrictionalWall {
 public:
  using V = Vec<T, D>;

  explicit BoundFrictionalWall(FrictionalWall wall) : wall_{std::move(wall)}, name_{wall_.where.name()} {}

  /// Before parts are connected, some of which ask for the nodes.
  template <class Scene>
  void connect_walls(Scene& scene, const BoundaryNodes<D>&) {
    const auto is_meant = face_test(scene, wall_.where);
    std::vector<Index> place(scene.fields[0].size(), none);
    for_each_hull_face(scene, [&](const HullFace<T, D>& face) {
      if (!is_meant(face)) return;
      Face kept{face.node, V(V::Zero()), {}};
      if (face.axis >= 0) kept.area[face.axis] = face.upper ? 1 : -1;
      for_each_face_node(scene, face, [&](Index i) {
        if (place[i] == none) {
          place[i] = static_cast<Index>(nodes_.size());
          nodes_.push_back({i, V(V::Zero())});
        }
        kept.at.push_back(place[i]);
      });
      faces_.push_back(std::move(kept));
    });
    require(!faces_.empty() || Scene::is_portion, {"frictional(", name_, "): faces"}, faces_.size(),
            "must be at least one face of the mesh's hull");
    find_normals(scene.mesh);
    touched_.reserve(nodes_.size() * scene.fields.size());
  }

  template <class Scene>
  ContactTally apply_impulses(Scene& scene, double) {
    if constexpr (is_simplex_mesh<typename Scene::Mesh>) find_normals(scene.mesh);  // it may move
    const auto owns = scene.node_owner();
    ContactTally tally;
    touched_.clear();
    impulse_.setZero();
    for (const auto& [node, normal] : nodes_) {
      if (!owns(node)) continue;
      for (std::size_t f = 0; f < scene.fields.size(); ++f) {
        auto& field = scene.fields[f];
        const T mass = field.mass[node];
        if (!(mass > 0)) continue;
        V& v = field.velocity[node];
        const auto given = wall_impulse<T, D>(v, normal, mass, wall_);
        if (given.impulse.squaredNorm() == 0) continue;
        v += given.impulse / mass;
        impulse_ += given.impulse;
        // Mean velocities over the step, so that forces in equilibrium with the wall dissipate nothing.
        tally.dissipation -= static_cast<double>(given.impulse.dot(field.start[node] + v)) / 2;
        ++tally.nodes;
        touched_.push_back({f, node, normal, given.sticks, given.impulse, v});
      }
    }
    dissipated_ += tally.dissipation;
    return tally;
  }
  template <class Scene>
  double after_grid(const Scene& scene, double) {
    const double dissipation = rest_of_dissipation(touched_, scene.fields);
    dissipated_ += dissipation;
    return dissipation;
  }
  template <class Scene>
  double constrain_mapped(Scene& scene, double dt) {
    const double dissipation = hold_touched(touched_, scene.fields, static_cast<T>(dt));
    dissipated_ += dissipation;
    return dissipation;
  }
  PartEnergy count_energy() const { return {.dissipated = dissipated_}; }
  bool holds_against(const V& acceleration) const {
    for (const auto& n : nodes_)
      if (n.normal.dot(acceleration) < 0) return true;
    return false;
  }
  /// Calls `f(node, normal)` for the nodes of the wall, with the unit normal out of it.
  template <class F>
  void visit_wall_nodes(F&& f) const {
    for (const auto& n : nodes_) f(n.node, n.normal);
  }
  template <class F>
  void visit_state(F&& f) {
    f("dissipated", dissipated_);
  }

  /// Its name in `reaction(scene, name)`, and its impulse on the matter in the last step, N s.
  const std::string& wall_name() const { return name_; }
  const V& given_impulse() const { return impulse_; }

 private:
  struct Face {
    std::array<Index, static_cast<std::size_t>(D)> node;  // of a simplex's
    V area;                                               // of a grid's: along it, outward
    std::vector<Index> at;                                // places of its nodes in nodes_
  };
  struct Node {
    Index node;
    V normal;  // out of the wall, into the mesh
  };
  struct Touched {
    std::size_t field;
    Index node;
    V normal;
    bool sticks;
    V impulse;
    V after;  // velocity with the impulse
  };

  template <class M>
  void find_normals(const M& mesh) {
    for (auto& n : nodes_) n.normal.setZero();
    for (const Face& face : faces_) {
      V area = face.area;
      if constexpr (is_simplex_mesh<M>) {
        std::array<V, static_cast<std::size_t>(D)> x;
        for (std::size_t i = 0; i < D; ++i) x[i] = mesh.position(face.node[i]);
        area = face_area(x);
      }
      for (const Index k : face.at) nodes_[k].normal -= area;
    }
    for (auto& n : nodes_) n.normal.normalize();
  }

  FrictionalWall wall_;
  std::string name_;
  std::vector<Face> faces_;
  std::vector<Node> nodes_;
  std::vector<Touched> touched_;  // in the last step
  V impulse_ = V::Zero();         // of the last step, N s
  double dissipated_ = 0;         // since the start, J
};

template <class Traits>
auto bind_part(const FrictionalWall& wall, const Traits&) {
  return BoundFrictionalWall<typename Traits::T, Traits::D>(wall);
}

}  // namespace arenite::inline ARENITE_INSTRUCTION_SET
