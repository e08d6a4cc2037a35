// Surface of a rigid body: which nodes it touches, and its normal there. Nodes of a mesh fitted to it, or a
// signed distance.
#pragma once
// SPDX-License-Identifier: BSD-3-Clause

#include <algorithm>
#include <array>
#include <cmath>
#include <exception>
#include <limits>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include <arenite/contact/region_surface.hpp>
#include <arenite/core/bind.hpp>
#include <arenite/core/error.hpp>
#include <arenite/core/refusals.hpp>
#include <arenite/core/vector_argument.hpp>
#include <arenite/geometry/signed_distance.hpp>
#include <arenite/parallel/parallel.hpp>
#include <arenite/rigid/body/pose.hpp>
#include <arenite/shape/nodes_near.hpp>
#include <arenite/shape/shape.hpp>

namespace arenite::inline ARENITE_INSTRUCTION_SET {

/// The surface of a region of a simplex mesh that moves with the body; found when the scene is made.
struct MeshSurface {
  std::string region;
  /// Greatest shear stress that the surface gives, whatever the pressure on it, Pa: the adhesion of clay,
  /// with `Friction::no_slip()`.
  double shear_strength = std::numeric_limits<double>::infinity();
};

/// A signed distance, m, negative inside, in the body's own frame: callable with a position [D]
/// (`signed_distance`). The distance is not part of the type of a scene. It is tried when the scene is made
/// (`try_distance.hpp`): NaN is refused, then and wherever it occurs; a gradient that is not 1, as that of a
/// distance in mm, matter inside of the body and a sign that puts most of it there are warned of.
///
/// `reach`: a node counts as touched up to and at this many cell sizes (`mesh.node_size`) outside. Nodes
/// carry mass beyond the points, so that contact acts before the surfaces touch; by how much depends on
/// where nodes lie. With points in whole cells, 4 (8 in space) a cell of the grid and 6 (10) in triangles
/// (tetrahedra), the first node pushes at a distance of
///
/// | reach | quadratic B-splines | linear simplices |
/// |---|---|---|
/// | 0.5 | 0.75 to 1.75 cells | 0.4 to 1.25 cells |
/// | 0 | 0.25 to 1.25 cells | -0.1 to 0.9 cells |
///
/// the same in the plane and in space (tests/contact/acting_distance_heavy.cpp). Matter that is fast against
/// its waves comes nearer than that: at 2 m/s rubber of 1 MPa by half a cell. With `PointContact` there is no
/// reach: points push where they are, wherever the nodes lie, so that the matter's face is half a point's
/// size inside the body, 1/6 of a cell with nine points a cell, 1/4 with four
/// (tests/rigid/point_contact.cpp).
///
/// Walls stop matter at nodes if thickness / 2 + reach is at least the spacing of rows of nodes: one cell
/// with a reach of 0.5 (docs/components_contact.md#thin-walls). A new scene warns of thinner ones.
template <class Distance = AnyDistance>
struct DistanceSurface {
  Distance distance;
  double reach = 0.5;

  using TypeErased = DistanceSurface<>;
  template <class M>
  TypeErased type_erased() const {
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
/// - optional `connect(scene)`: called once, when all parts of the scene are bound;
/// - optional `shear_limit(node)`: greatest shear force that the surface gives to a node that it touches, N.
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
  explicit BoundMeshSurface(MeshSurface s) : recipe_{std::move(s)} {
    require(recipe_.shear_strength >= 0, "MeshSurface.shear_strength", recipe_.shear_strength,
            "must be >= 0 Pa");
  }
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
  /// N; of a node inside no limit.
  T shear_limit(Index node) const {
    const auto at = std::ranges::lower_bound(surface_.nodes, node);
    if (std::isinf(recipe_.shear_strength) || at == surface_.nodes.end() || *at != node)
      return std::numeric_limits<T>::infinity();
    return static_cast<T>(recipe_.shear_strength) *
           surface_.areas[static_cast<std::size_t>(at - surface_.nodes.begin())];
  }
  const RegionSurface<T, D>& surface() const { return surface_; }
  const std::string& region() const { return recipe_.region; }

 private:
  MeshSurface recipe_;
  RegionSurface<T, D> surface_;
};

template <class Traits>
auto bind_part(const MeshSurface& surface, const Traits&) {
  static_assert(is_simplex_mesh<typename Traits::Mesh>, ARENITE_SAYS_MESH_SURFACE_ON_GRID);
  return BoundMeshSurface<typename Traits::T, Traits::D>(surface);
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
  double reach() const { return surface_.reach; }

  /// Visits the nodes near the body.
  template <class Shape, class M, class Place, class HasMass, class F>
  void visit(const M& mesh, const Place& place, HasMass&& has_mass, F&& f) {
    const auto box = box_in_scene(place);
    // Of a body that is turned the reach from its box is up to sqrt(D) times as far along an axis.
    near_.template find<Shape>(mesh, box, std::sqrt(double{D}) * surface_.reach);
    const auto candidates = [&](std::size_t begin, std::size_t end, auto&& take) {
      for (std::size_t n = begin; n < end; ++n)
        if (const Index i = near_[n]; has_mass(i))
          take(i, Shape::node_position(mesh, i), static_cast<double>(mesh.node_size(i)));
    };
    search(near_.size(), 256, near_.size() >= least_items / 4, place, surface_.reach, candidates,
           [&](const Found& n) { f(n.number, n.normal, n.inside, T(0)); });
  }

  /// Calls `f(point, normal, distance)` for the points of a body (`CellList`) no farther from the surface, m,
  /// than `reach` sizes of their cells, cell by cell; the normal is zero where the distance has no slope.
  template <class M, class Place, class B, class F>
  void visit_points(const M& mesh, const Place& place, const B& body, double reach, F&& f) {
    const auto candidates = [&](std::size_t begin, std::size_t end, auto&& take) {
      for (auto c = static_cast<Index>(begin); c < end; ++c) {
        if (body.cells.empty(c)) continue;
        const auto size = static_cast<double>(mesh.size(c));
        for (const Index p : body.cells[c]) take(p, body.points.position[p], size);
      }
    };
    search(mesh.cell_count(), 64, body.points.size() >= least_items, place, reach, candidates,
           [&](const Found& p) { f(p.number, p.normal, p.distance); });
  }

 private:
  using Position = AnyDistance::Position;
  /// In cells: a face on a line of the grid has nodes at its reach of half a cell. All of them count as
  /// touched, or round-off would decide.
  static constexpr double tie = 1e-7 + 1e3 * std::numeric_limits<T>::epsilon();
  struct Found {
    Index number;  // of the node or point
    bool inside;
    Vec<T, D> normal;
    double distance;
  };
  struct Chunk {
    std::vector<Found> found{};
    std::exception_ptr failure{};
  };

  /// Searches items near the surface, in chunks on several threads, and joins the results in order: calls
  /// `f(found)`. `candidates(begin, end, take)` calls `take(number, position, size of the cell)` for items
  /// `begin` to `end`.
  template <class Place, class Candidates, class F>
  void search(std::size_t items, std::size_t chunk, bool worthwhile, const Place& place, double reach,
              const Candidates& candidates, F&& f) {
    const std::size_t chunks = (items + chunk - 1) / chunk;
    if (chunks_.size() < chunks) chunks_.resize(chunks);
    parallel_for(chunks, worthwhile, [&](std::size_t k) {
      Chunk& part = chunks_[k];
      part.found.clear();
      part.failure = nullptr;
      try {
        look(place, reach, k * chunk, std::min(items, (k + 1) * chunk), candidates, part.found);
      } catch (...) {  // out of a user's distance; a loop over threads must not throw
        part.failure = std::current_exception();
      }
    });
    for (std::size_t k = 0; k < chunks; ++k)
      if (chunks_[k].failure) std::rethrow_exception(chunks_[k].failure);
    for (std::size_t k = 0; k < chunks; ++k)
      for (const Found& found : chunks_[k].found) f(found);
  }

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

  template <class Place, class Candidates>
  void look(const Place& place, double reach, std::size_t begin, std::size_t end,
            const Candidates& candidates, std::vector<Found>& found) const {
    constexpr std::size_t block = 64;  // distances asked for in one call
    std::array<Index, block> number;
    std::array<double, block> cell, distance;
    std::array<Position, block> at;
    std::size_t count = 0;
    const auto ask = [&] {
      surface_.distance.at({at.data(), count}, distance.data());
      for (std::size_t k = 0; k < count; ++k) {
        if (distance[k] > (reach + tie) * cell[k]) continue;
        const Vec<double, D> normal = to_scene(
            place,
            in_scene<D>(surface_.distance.template differences<D>(at[k], 1e-4 * cell[k])).normalized());
        bool finite = std::isfinite(distance[k]);
        for (int i = 0; i < D; ++i) finite = finite && std::isfinite(normal[i]);
        if (!finite) throw run_error(refused_distance(at[k], distance[k]));
        // Where the distance has no slope (deep on an axis) there is no way out: such a node is inside.
        found.push_back({number[k], normal.squaredNorm() == 0, normal.template cast<T>(), distance[k]});
      }
      count = 0;
    };
    candidates(begin, end, [&](Index i, const Vec<T, D>& position, double size) {
      const Position x = to_body(place, position);
      if (is_beyond(x, reach, size)) return;
      number[count] = i;
      cell[count] = size;
      at[count] = x;
      if (++count == block) ask();
    });
    ask();
  }

  /// Whether a position is farther from the box around the body than reach, whatever the round-off.
  bool is_beyond(const Position& x, double reach, double cell) const {
    return surface_.distance.is_beyond(x, (reach + 1e-3) * cell);
  }

  DistanceSurface<> surface_;
  NodesNear<T, D> near_{};
  std::vector<Chunk> chunks_{};  // [chunks, or more], memory from step to step
};

template <class Distance, class Traits>
auto bind_part(const DistanceSurface<Distance>& surface, const Traits&) {
  return BoundDistanceSurface<typename Traits::T, Traits::D>(type_erased<typename Traits::Mesh>(surface));
}

}  // namespace arenite::inline ARENITE_INSTRUCTION_SET
