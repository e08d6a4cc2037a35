// Surface of a rigid body: which nodes it touches, and its normal there. Nodes of a mesh fitted to it, or a
// signed distance.
#pragma once

#include <string>

#include <arenite/contact/region_surface.hpp>
#include <arenite/shape/shape.hpp>

namespace arenite::inline ARENITE_INSTRUCTION_SET {

/// The surface of a region of a simplex mesh that moves with the body; found when the scene is made.
struct MeshSurface {
  std::string region;
};

/// A signed distance, m, negative inside, in the body's own frame: callable with a position [D]. `reach`: a
/// node counts as touched from this many cell sizes outside on; half a cell acts where the points do, zero
/// acts late.
template <class Distance>
struct DistanceSurface {
  Distance distance;
  double reach = 0.5;
};
template <class Distance>
DistanceSurface(Distance) -> DistanceSurface<Distance>;
template <class Distance>
DistanceSurface(Distance, double) -> DistanceSurface<Distance>;

/// A surface once bound to a scene:
/// - `has_volume_fractions`: whether its nodes carry fractions of its volume;
/// - `visit<Shape>(mesh, displacement, f)`: calls `f(node, normal, inside, share)` for each node that it
///   touches where the body is now, with the unit normal out of the body (zero inside);
/// - optional `connect(scene)`: called once, when all parts of the scene are bound.
template <class S, class Shape, class M>
concept rigid_surface = requires(const S surface, const M& mesh,
                                 const Vec<typename M::scalar, M::dimension> x) {
  { S::has_volume_fractions } -> std::convertible_to<bool>;
  surface.template visit<Shape>(
      mesh, x, [](Index, const Vec<typename M::scalar, M::dimension>&, bool, typename M::scalar) {});
};

/// A mesh surface in its mesh. Visits each surface node with its normal and share of the body's mass, then
/// those inside.
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
  template <class Shape, class M, class F>
  void visit(const M&, const Vec<T, D>&, F&& f) const {
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

/// A signed distance in a mesh. Visits the nodes within reach; the normal is the slope of the distance.
template <class T, int D, class Distance>
class BoundDistanceSurface {
 public:
  explicit BoundDistanceSurface(DistanceSurface<Distance> s) : surface_{std::move(s)} {
    require(surface_.reach >= 0, "DistanceSurface.reach", surface_.reach, "must not be negative");
  }
  static constexpr bool has_volume_fractions = false;

  template <class Shape, class M, class F>
  void visit(const M& mesh, const Vec<T, D>& displacement, F&& f) const {
    const Index nodes = Shape::node_count(mesh);
    for (Index i = 0; i < nodes; ++i) {
      const T cell = node_size(mesh, i);
      const Vec<double, D> x = (Shape::node_position(mesh, i) - displacement).template cast<double>();
      if (surface_.distance(x) > surface_.reach * static_cast<double>(cell)) continue;
      const Vec<double, D> normal = slope(x, 1e-4 * static_cast<double>(cell));
      // Where the distance has no slope (deep on an axis) there is no way out: such a node is inside.
      f(i, Vec<T, D>(normal.template cast<T>()), normal.squaredNorm() == 0, T(0));
    }
  }

 private:
  Vec<double, D> slope(const Vec<double, D>& x, double h) const {
    Vec<double, D> g;
    for (int k = 0; k < D; ++k) {
      const Vec<double, D> step = h * Vec<double, D>::Unit(k);
      g[k] = surface_.distance(Vec<double, D>(x + step)) - surface_.distance(Vec<double, D>(x - step));
    }
    return g.normalized();
  }

  DistanceSurface<Distance> surface_;
};

template <class Distance, class Site>
auto bind_part(const DistanceSurface<Distance>& surface, const Site&) {
  return BoundDistanceSurface<typename Site::T, Site::D, Distance>(surface);
}

}  // namespace arenite::inline ARENITE_INSTRUCTION_SET
