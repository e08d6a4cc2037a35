// Surface of a rigid body: which nodes it touches, and its normal there. Nodes of a mesh fitted to it, or a
// signed distance.
#pragma once

#include <algorithm>
#include <array>
#include <exception>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include <arenite/contact/region_surface.hpp>
#include <arenite/core/bind.hpp>
#include <arenite/core/parallel.hpp>
#include <arenite/core/vector_argument.hpp>
#include <arenite/rigid/pose.hpp>
#include <arenite/rigid/signed_distance.hpp>
#include <arenite/shape/nodes_near.hpp>
#include <arenite/shape/shape.hpp>

namespace arenite::inline ARENITE_INSTRUCTION_SET {

/// The surface of a region of a simplex mesh that moves with the body; found when the scene is made.
struct MeshSurface {
  std::string region;
};

/// A signed distance, m, negative inside, in the body's own frame: callable with a position [D]
/// (`signed_distance`). The distance is not part of the type of a scene.
///
/// `reach`: a node counts as touched up to this many cell sizes (`mesh.node_size`) outside. Nodes carry mass
/// ahead of the points, so that contact acts before the surfaces meet, by how much depends on where nodes
/// lie. With points in whole cells, 4 (8 in space) a cell of the grid and 6 (10) in triangles (tetrahedra),
/// the first node pushes at a distance of
///
/// | reach | quadratic B-splines | linear simplices |
/// |---|---|---|
/// | 0.5 | 0.75 to 1.75 cells | 0.4 to 1.25 cells |
/// | 0 | 0.25 to 1.25 cells | -0.1 to 0.9 cells |
///
/// the same in the plane and in space (tests/contact/acting_distance_heavy.cpp). Matter that is fast against
/// its waves comes nearer than that: at 2 m/s rubber of 1 MPa by half a cell.
template <class Distance = AnyDistance>
struct DistanceSurface {
  Distance distance;
  double reach = 0.5;

  using Erased = DistanceSurface<>;
  template <class M>
  Erased erased() const {
    if constexpr (std::same_as<Distance, AnyDistance>) {
      return *this;
    } else {
      static_assert(
          signed_distance<Distance, M::dimension>,
          "DistanceSurface: the distance must be callable as double(const Vec<double, D>& position) "
          "const in the scene's dimension");
      return {AnyDistance::of<M::dimension>(distance), reach};
    }
  }
};
template <class Distance>
DistanceSurface(Distance) -> DistanceSurface<Distance>;
template <class Distance>
DistanceSurface(Distance, double) -> DistanceSurface<Distance>;

/// A surface once bound to a scene:
/// - `has_volume_fractions`: whether its nodes carry fractions of its volume;
/// - `visit<Shape>(mesh, place, has_mass, f)`: `place` is the body's displacement [D], m, or the `Pose` of a
///   body that rotates; a surface may take one of them or both. Calls `f(node, normal, inside, fraction)` for
///   each node that it touches where the body is now, in an order that does not depend on threads, with the
///   unit normal out of the body (zero inside); nodes without matter, `!has_mass(node)`, need no call;
/// - optional `connect(scene)`: called once, when all parts of the scene are bound.
template <class S, class Shape, class M, class Place = Vec<typename M::scalar, M::dimension>>
concept rigid_surface = requires(S surface, const M& mesh, const Place x) {
  { S::has_volume_fractions } -> std::convertible_to<bool>;
  surface.template visit<Shape>(
      mesh, x, [](Index) { return true; },
      [](Index, const Vec<typename M::scalar, M::dimension>&, bool, typename M::scalar) {});
};

/// A mesh surface in its mesh. Visits each surface node with its normal and fraction of the body's volume,
/// then those inside.
template <class T, int D>
class BoundMeshSurface {
 public:
  explicit BoundMeshSurface(MeshSurface s) : recipe_{std::move(s)} {}
  static constexpr bool has_volume_fractions = true;

  template <class Scene>
  void connect(const Scene& scene) {
    surface_ = surface_of<typename Scene::Kinematics>(scene.mesh, recipe_.region, scene.constraints,
                                                      Scene::is_portion);
  }
  template <class Shape, class M, class HasMass, class F>
  void visit(const M&, const Vec<T, D>&, HasMass&&, F&& f) const {
    for (std::size_t k = 0; k < surface_.nodes.size(); ++k)
      f(surface_.nodes[k], surface_.normals[k], false, surface_.volume_fraction[k]);
    for (const Index i : surface_.inside) f(i, Vec<T, D>::Zero(), true, T(0));
  }
  const RegionSurface<T, D>& surface() const { return surface_; }

 private:
  MeshSurface recipe_;
  RegionSurface<T, D> surface_;
};

template <class Site>
auto bind_part(const MeshSurface& surface, const Site&) {
  static_assert(is_simplex_mesh<typename Site::Mesh>,
                "Rigid: a MeshSurface needs a simplex mesh; on a grid use a DistanceSurface");
  return BoundMeshSurface<typename Site::T, Site::D>(surface);
}

/// A signed distance in a mesh. Visits the nodes with matter within reach; the normal is the slope of the
/// distance.
template <class T, int D>
class BoundDistanceSurface {
 public:
  explicit BoundDistanceSurface(DistanceSurface<> s) : surface_{std::move(s)} {
    require(surface_.reach >= 0, "DistanceSurface.reach", surface_.reach, "must not be negative");
  }
  static constexpr bool has_volume_fractions = false;
  const AnyDistance& distance() const { return surface_.distance; }

  /// Visits the nodes near the body, in chunks on several threads, and joins their results in order.
  template <class Shape, class M, class Place, class HasMass, class F>
  void visit(const M& mesh, const Place& place, HasMass&& has_mass, F&& f) {
    const auto box = box_in_scene(place);
    // Of a body that is turned the reach from its box is up to sqrt(D) times as far along an axis.
    near_.template find<Shape>(mesh, box, std::sqrt(double{D}) * surface_.reach);
    const std::size_t nodes = near_.size(), chunks = (nodes + chunk - 1) / chunk;
    if (found_.size() < chunks) found_.resize(chunks);
    parallel_for(chunks, nodes >= least_items / 4, [&](std::size_t k) {
      Found& found = found_[k];
      found.nodes.clear();
      found.failure = nullptr;
      try {
        look<Shape>(mesh, place, has_mass, k * chunk, std::min(nodes, (k + 1) * chunk), found.nodes);
      } catch (...) {  // out of a user's distance; a loop over threads must not throw
        found.failure = std::current_exception();
      }
    });
    const std::span all(found_.data(), chunks);
    for (const Found& found : all)
      if (found.failure) std::rethrow_exception(found.failure);
    for (const Found& found : all)
      for (const auto& n : found.nodes) f(n.node, n.normal, n.inside, T(0));
  }

 private:
  using Position = AnyDistance::Position;
  struct Node {
    Index node;
    bool inside;
    Vec<T, D> normal;
  };
  static constexpr std::size_t chunk = 256;  // nodes; a distance may cost much
  struct Found {                             ///< in a chunk of nodes
    std::vector<Node> nodes{};
    std::exception_ptr failure{};
  };

  /// Position in the body's frame, and direction in that of the scene.
  static Position to_body(const Vec<T, D>& displacement, const Vec<T, D>& x) {
    return in_space<T, D>(x - displacement);
  }
  static Position to_body(const Pose<D>& pose, const Vec<T, D>& x) {
    return in_space<double, D>(pose.to_body(x.template cast<double>()));
  }
  static const Vec<double, D>& to_scene(const Vec<T, D>&, const Vec<double, D>& normal) { return normal; }
  static Vec<double, D> to_scene(const Pose<D>& pose, const Vec<double, D>& normal) {
    return pose.to_scene(normal);
  }

  /// Box about the body where it is now, m.
  Box<std::size_t{D}> box_in_scene(const Vec<T, D>& displacement) const {
    return moved_box<D>(surface_.distance.bounds<D>(), Mat<double, D>::Identity(),
                        displacement.template cast<double>());
  }
  Box<std::size_t{D}> box_in_scene(const Pose<D>& pose) const {
    return moved_box<D>(surface_.distance.bounds<D>(), pose.rotation,
                        pose.centre + pose.displacement - pose.rotation * pose.centre);
  }

  template <class Shape, class M, class Place, class HasMass>
  void look(const M& mesh, const Place& place, HasMass& has_mass, std::size_t begin, std::size_t end,
            std::vector<Node>& found) const {
    constexpr std::size_t block = 64;  // distances asked for in one call
    std::array<Index, block> node;
    std::array<double, block> cell, distance;
    std::array<Position, block> at;
    std::size_t count = 0;
    const auto ask = [&] {
      surface_.distance.at({at.data(), count}, distance.data());
      for (std::size_t k = 0; k < count; ++k) {
        if (distance[k] > surface_.reach * cell[k]) continue;
        const Vec<double, D> normal = to_scene(place, slope(at[k], 1e-4 * cell[k]));
        // Where the distance has no slope (deep on an axis) there is no way out: such a node is inside.
        found.push_back({node[k], normal.squaredNorm() == 0, normal.template cast<T>()});
      }
      count = 0;
    };
    for (std::size_t n = begin; n < end; ++n) {
      const Index i = near_[n];
      if (!has_mass(i)) continue;
      const Position x = to_body(place, Shape::node_position(mesh, i));
      const auto size = static_cast<double>(mesh.node_size(i));
      if (is_beyond(x, size)) continue;
      node[count] = i;
      cell[count] = size;
      at[count] = x;
      if (++count == block) ask();
    }
    ask();
  }

  /// Whether a position is farther from the box around the body than reach, whatever the round-off.
  bool is_beyond(const Position& x, double cell) const {
    const double far = (surface_.reach + 1e-3) * cell;
    for (std::size_t k = 0; k < D; ++k)
      if (x[k] < surface_.distance.lower()[k] - far || x[k] > surface_.distance.upper()[k] + far) return true;
    return false;
  }

  /// Unit normal from central differences; zero where there is no slope.
  Vec<double, D> slope(const Position& x, double h) const {
    std::array<Position, 2 * D> place;
    std::array<double, 2 * D> distance;
    place.fill(x);
    for (std::size_t k = 0; k < D; ++k) {
      place[2 * k][k] += h;
      place[2 * k + 1][k] -= h;
    }
    surface_.distance.at(place, distance.data());
    Vec<double, D> g;
    for (std::size_t k = 0; k < D; ++k) g[static_cast<int>(k)] = distance[2 * k] - distance[2 * k + 1];
    return g.normalized();
  }

  DistanceSurface<> surface_;
  NodesNear<T, D> near_{};
  std::vector<Found> found_{};  // [chunks of nodes, or more], memory from step to step
};

template <class Distance, class Site>
auto bind_part(const DistanceSurface<Distance>& surface, const Site&) {
  return BoundDistanceSurface<typename Site::T, Site::D>(erased<typename Site::Mesh>(surface));
}

}  // namespace arenite::inline ARENITE_INSTRUCTION_SET
