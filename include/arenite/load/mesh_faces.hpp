// Mesh faces: selects the faces of a mesh's hull that a load acts on.
#pragma once
// SPDX-License-Identifier: BSD-3-Clause

#include <Eigen/Geometry>
#include <array>
#include <cmath>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include <arenite/boundary/constraints.hpp>
#include <arenite/boundary/walls.hpp>
#include <arenite/functions/place_function.hpp>

namespace arenite::inline ARENITE_INSTRUCTION_SET {

/// Faces of the cells on the hull of the mesh, all of whose corners lie on a side of the box around it, in a
/// node set, or pass a test.
struct MeshFaces {
  int axis = -1;                              ///< side: normal axis; -1: not a side
  bool upper = false;                         ///< side: at the upper or lower end of the mesh
  std::string set{};                          ///< name of a node set of a simplex mesh
  std::function<bool(const Triple&)> test{};  ///< any test of a corner's position, m

  std::string name() const { return place_name(axis, upper, set); }
};

/// Sides of the box around the mesh: `left` and `right` at the ends of x (the inner and outer radius),
/// `bottom` and `top` of y, `front` and `back` of z.
inline MeshFaces left() { return {0, false, {}, {}}; }
inline MeshFaces right() { return {0, true, {}, {}}; }
inline MeshFaces bottom() { return {1, false, {}, {}}; }
inline MeshFaces top() { return {1, true, {}, {}}; }
inline MeshFaces front() { return {2, false, {}, {}}; }
inline MeshFaces back() { return {2, true, {}, {}}; }
/// Hull faces whose nodes are all in a named set of a simplex mesh.
inline MeshFaces on(std::string set) { return {-1, false, std::move(set), {}}; }
/// Hull faces whose corners (x, y, z = 0 in two dimensions), m, all pass a test.
inline MeshFaces where(std::function<bool(const Triple&)> test) { return {-1, false, {}, std::move(test)}; }

/// A face on the hull: its cell, and its corners. A grid's is a line or a square; its corners are in the
/// order of the axes.
template <class T, int D>
struct HullFace {
  Index cell;
  int axis;                                             ///< of a grid's face: normal to it
  bool upper;                                           ///< of a grid's face
  std::array<Index, static_cast<std::size_t>(D)> node;  ///< of a simplex's face, so that its area points out
  std::vector<Vec<T, D>> corner;                        ///< m
};

/// Area vector of a simplex's face with these corners, m^(D-1), its length the area.
template <class T>
Vec<T, 2> face_area(const std::array<Vec<T, 2>, 2>& x) {
  return {x[1][1] - x[0][1], x[0][0] - x[1][0]};
}
template <class T>
Vec<T, 3> face_area(const std::array<Vec<T, 3>, 3>& x) {
  return (x[1] - x[0]).cross(x[2] - x[0]) / 2;
}

/// Calls `f(face)` for all faces on the hull, of the cells that the scene owns.
template <class Scene, class F>
void for_each_hull_face(const Scene& scene, F&& f) {
  using M = typename Scene::Mesh;
  using T = typename Scene::T;
  constexpr int D = Scene::D;
  constexpr auto dim = static_cast<std::size_t>(D);
  const M& mesh = scene.mesh;
  const auto owns = scene.cell_owner();
  for (Index c = 0; c < mesh.cell_count(); ++c) {
    if (!owns(c)) continue;
    if constexpr (is_simplex_mesh<M>) {
      for (int k = 0; k <= D; ++k) {
        if (mesh.neighbour(c, k) != none) continue;
        HullFace<T, D> face{c, -1, false, {}, {}};
        std::array<Vec<T, D>, dim> x;
        for (std::size_t j = 0, at = 0; j <= dim; ++j) {
          if (static_cast<int>(j) == k) continue;
          face.node[at] = mesh.nodes(c)[j];
          x[at] = mesh.position(face.node[at]);
          ++at;
        }
        if constexpr (Scene::is_portion) {
          auto sorted = face.node;
          std::ranges::sort(sorted);
          if (scene.portion().cuts.contains(sorted)) continue;
        }
        const Vec<T, D> inwards = mesh.position(mesh.nodes(c)[static_cast<std::size_t>(k)]) - x[0];
        if (face_area(x).dot(inwards) > 0) std::swap(face.node[0], face.node[1]);
        face.corner.assign(x.begin(), x.end());
        f(face);
      }
    } else {
      for (int k = 0; k < D; ++k) {
        if (is_periodic<M>(k)) continue;
        for (const bool upper : {false, true}) {
          const Index at = mesh.place(c)[static_cast<std::size_t>(k)];
          if (upper ? at + 1 != whole_cells(mesh, k) : at != 0) continue;
          HullFace<T, D> face{c, k, upper, {}, {}};
          for (std::size_t n = 0; n < (std::size_t{1} << (dim - 1)); ++n) {
            Vec<T, D> x = mesh.corner(c);
            for (int a = 0, bit = 0; a < D; ++a)
              if (a != k) x[a] += static_cast<T>((n >> bit++) & 1) * mesh.extent(c)[a];
            x[k] = upper ? mesh.upper(k) : mesh.lower()[k];
            face.corner.push_back(x);
          }
          f(face);
        }
      }
    }
  }
}

/// Where a grid's face is now: its place on the axis, m, and its area, thickness included, m2. It moves with
/// the grid.
template <class K, class M>
std::pair<typename M::scalar, typename M::scalar> grid_face(const M& grid, Index cell, int axis, bool upper) {
  const auto edges = grid.extent(cell);
  typename M::Point centre = grid.corner(cell) + edges / 2;
  centre[axis] = upper ? grid.upper(axis) : grid.lower()[axis];
  auto area = K::thickness(centre);
  for (int k = 0; k < M::dimension; ++k)
    if (k != axis) area *= edges[k];
  return {centre[axis], area};
}

/// Calls `f(node)` for the nodes whose functions have a value on a face.
template <class Scene, class T, int D, class F>
void for_each_face_node(const Scene& scene, const HullFace<T, D>& face, F&& f) {
  if constexpr (is_simplex_mesh<typename Scene::Mesh>) {
    for (const Index i : face.node) f(i);
  } else {
    const typename Scene::Shape::template Cell<typename Scene::Mesh> cell(scene.mesh, face.cell);
    Vec<T, D> centre = Vec<T, D>::Zero();
    for (const auto& x : face.corner) centre += x / static_cast<T>(face.corner.size());
    std::array<bool, Scene::Shape::template Cell<typename Scene::Mesh>::size> has{};
    for (const auto& x : face.corner) {  // beside each corner, where narrow functions have a value, too
      const auto w = cell.weights(centre + T(0.9) * (x - centre));
      for (std::size_t i = 0; i < has.size(); ++i) has[i] = has[i] || w[static_cast<int>(i)] > T(1e-5);
    }
    for (std::size_t i = 0; i < has.size(); ++i)
      if (has[i]) f(cell.nodes[i]);
  }
}

/// Volume of the points of a body in a cell, m3.
template <class T, class Body>
T volume_of(const Body& body, Index cell) {
  T sum = 0;
  for (const Index p : body.cells[cell]) sum += body.points.volume[p];
  return sum;
}
/// Volume of the points of all bodies in a cell, m3.
template <class Scene>
typename Scene::T matter_in(const Scene& scene, Index cell) {
  typename Scene::T sum = 0;
  scene.for_each_body(
      [&](const auto& body, const auto&) { sum += volume_of<typename Scene::T>(body, cell); });
  return sum;
}

/// Whether a face is among those meant. Throws `error` for a side, or a set, that the mesh does not have.
template <class Scene>
auto face_test(const Scene& scene, const MeshFaces& where) {
  constexpr int D = Scene::D;
  using Face = HullFace<typename Scene::T, D>;
  typename Scene::Nodes nodes(scene.mesh);  // knows the box around the mesh
  if constexpr (Scene::is_portion) nodes.set_whole(scene.portion().lower, scene.portion().upper);
  require(where.axis < D, "MeshFaces.axis", where.axis, "must be an axis of the scene");
  require(where.axis < 0 || !is_periodic<typename Scene::Mesh>(where.axis), "MeshFaces.axis", where.axis,
          "is periodic: the mesh has no face there");
  require(where.axis >= 0 || !where.set.empty() || where.test, "MeshFaces.set", where.set,
          "must name a node set (or the faces a side or a test)");
  std::vector<bool> in_set;
  if (!where.set.empty()) {
    if constexpr (is_simplex_mesh<typename Scene::Mesh>) {
      in_set.resize(scene.mesh.node_count());
      for (const Index i : scene.mesh.node_set(where.set)) in_set[i] = true;
    } else {
      throw error(joined_text(
          {"MeshFaces.set = ", where.set, ": a Cartesian grid has no node sets; use sides or where(test)"}));
    }
  }
  const double close = nodes.tolerance();
  const double side = where.axis < 0 ? 0 : (where.upper ? nodes.upper() : nodes.lower())[where.axis];
  return [=, &where](const Face& face) {
    if (!in_set.empty()) return std::ranges::all_of(face.node, [&](Index i) -> bool { return in_set[i]; });
    return std::ranges::all_of(face.corner, [&](const auto& x) -> bool {
      return where.axis >= 0 ? std::abs(static_cast<double>(x[where.axis]) - side) <= close
                             : where.test(in_space(x));
    });
  };
}

}  // namespace arenite::inline ARENITE_INSTRUCTION_SET
