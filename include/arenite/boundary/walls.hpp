// Walls: which nodes may not move, and in which directions. A wall blocks the velocity along some normals;
// where several walls meet at a node their blocked directions add up.
#pragma once

#include <functional>
#include <limits>
#include <string>
#include <vector>

#include <arenite/core/error.hpp>
#include <arenite/mesh/mesh.hpp>
#include <arenite/shape/shape.hpp>

namespace arenite::inline ARENITE_INSTRUCTION_SET {

/// What a wall blocks.
struct Condition {
  enum class Kind { all, face_normal, normal, all_but } kind;
  std::array<double, 3> direction{};  ///< `normal`: the blocked direction; `all_but`: the free one
};
inline constexpr Condition fixed{Condition::Kind::all};  ///< no motion
inline constexpr Condition roller{
    Condition::Kind::face_normal};  ///< no motion across the face: a smooth wall, or a symmetry plane
/// No motion across a plane with this normal (any length): a smooth wall or a symmetry plane that lies askew.
constexpr Condition symmetry(std::array<double, 3> normal) { return {Condition::Kind::normal, normal}; }
/// Motion along this axis alone.
constexpr Condition free_along(std::size_t axis) {
  Condition c{Condition::Kind::all_but};
  if (axis < 3) c.direction[axis] = 1;  // an axis that the scene does not have is refused by `resolve`
  return c;
}

/// One wall: which nodes, and what is blocked there.
struct Wall {
  int axis = -1;                                             ///< face: normal axis; -1: not a face
  bool upper = false;                                        ///< face: at the upper or lower end of the mesh
  std::string set{};                                         ///< name of a node set of a simplex mesh
  std::function<bool(const std::array<double, 3>&)> test{};  ///< any test of a node's position, m
  Condition condition = fixed;
};

inline Wall left(Condition c) { return {0, false, {}, {}, c}; }
inline Wall right(Condition c) { return {0, true, {}, {}, c}; }
inline Wall bottom(Condition c) { return {1, false, {}, {}, c}; }
inline Wall top(Condition c) { return {1, true, {}, {}, c}; }
inline Wall front(Condition c) { return {2, false, {}, {}, c}; }
inline Wall back(Condition c) { return {2, true, {}, {}, c}; }
/// The nodes of a named set of a simplex mesh.
inline Wall on(std::string set, Condition c) { return {-1, false, std::move(set), {}, c}; }
/// The nodes whose position (x, y, z = 0 in two dimensions), m, passes a test.
inline Wall where(std::function<bool(const std::array<double, 3>&)> test, Condition c) {
  return {-1, false, {}, std::move(test), c};
}

/// Walls of a scene.
struct Walls {
  std::vector<Wall> list;
};
template <std::same_as<Wall>... W>
Walls walls(W... wall) {
  return {{std::move(wall)...}};
}

/// A node that may not move freely: its velocity is multiplied by `projector` [D x D].
template <class T, int D>
struct Constraint {
  Index node;
  Mat<T, D> projector;
};

namespace detail {

/// Blocked directions at a node as an orthonormal set; adding one keeps it orthonormal.
template <int D>
struct Blocked {
  Mat<double, D> directions = Mat<double, D>::Zero();  // columns
  int count = 0;
  void add(Vec<double, D> n) {
    n.normalize();
    for (int pass = 0; pass < 2; ++pass)
      for (int k = 0; k < count; ++k) n -= directions.col(k).dot(n) * directions.col(k);
    if (count < D && n.norm() > 1e-6) directions.col(count++) = n.normalized();
  }
};

template <int D>
Vec<double, D> in_dimension(const std::array<double, 3>& a) {
  Vec<double, D> v;
  for (int k = 0; k < D; ++k) v[k] = a[static_cast<std::size_t>(k)];
  return v;
}

template <int D>
void block(Blocked<D>& at, const Condition& c, int face_axis) {
  using V = Vec<double, D>;
  const V direction = in_dimension<D>(c.direction);
  for (int k = 0; k < D; ++k) {
    const bool blocks = c.kind == Condition::Kind::all ||
                        (c.kind == Condition::Kind::face_normal && k == face_axis) ||
                        (c.kind == Condition::Kind::all_but && direction[k] == 0);
    if (blocks) at.add(V::Unit(k));
  }
  if (c.kind == Condition::Kind::normal) at.add(direction);
}

}  // namespace detail

/// Resolves walls to constrained nodes, ascending. `axis_nodes`: also block the radial motion of nodes at r =
/// 0. Throws `error` for a wall that catches no node, a face beyond the dimension, a roller that is no
/// face, or a direction that is none.
template <class Shape, class M>
std::vector<Constraint<typename M::scalar, M::dimension>> resolve(const Walls& walls, const M& mesh,
                                                                  bool axis_nodes) {
  using T = typename M::scalar;
  constexpr int D = M::dimension;
  const Index n = Shape::node_count(mesh);
  std::vector<Vec<double, D>> x(n);
  Vec<double, D> lower = Vec<double, D>::Constant(std::numeric_limits<double>::infinity()), upper = -lower;
  const auto used = [&]([[maybe_unused]] Index i) {  // a mesher may leave nodes without cells behind
    if constexpr (is_simplex_mesh<M>) return !mesh.cells_at(i).empty();
    return true;
  };
  for (Index i = 0; i < n; ++i) {
    x[i] = Shape::node_position(mesh, i).template cast<double>();
    if (!used(i)) continue;
    lower = lower.cwiseMin(x[i]);
    upper = upper.cwiseMax(x[i]);
  }
  const double near = 1e3 * static_cast<double>(std::numeric_limits<T>::epsilon()) * (upper - lower).norm();
  std::vector<detail::Blocked<D>> blocked(n);
  for (const Wall& wall : walls.list) {
    require(wall.axis < D, "Wall.axis", wall.axis, "must be an axis of the scene");
    const Condition& c = wall.condition;
    require(wall.axis >= 0 || c.kind != Condition::Kind::face_normal, "Wall.condition", "roller",
            "needs a face (left, right, ..); elsewhere name the plane: symmetry(normal)");
    if (c.kind == Condition::Kind::normal || c.kind == Condition::Kind::all_but) {
      const Vec<double, D> direction = detail::in_dimension<D>(c.direction);
      require(direction.allFinite() && direction.norm() > 0,
              c.kind == Condition::Kind::normal ? "symmetry.normal" : "free_along.axis",
              direction.transpose(), "must have a length in the scene's dimensions");
    }
    require(wall.axis >= 0 || !wall.set.empty() || wall.test, "Wall.set", wall.set,
            "must name a node set (or the wall a face or a test)");
    Index caught = 0;
    const auto take = [&](Index i) {
      detail::block<D>(blocked[i], c, wall.axis);
      ++caught;
    };
    if (!wall.set.empty()) {
      if constexpr (is_simplex_mesh<M>) {
        for (const Index i : mesh.node_set(wall.set)) take(i);
      } else {
        throw error(shared_detail::join("Wall.set = ", wall.set,
                                        ": a Cartesian grid has no node sets; use faces or where(test)"));
      }
    } else {
      for (Index i = 0; i < n; ++i) {
        if (!used(i)) continue;
        if (wall.axis >= 0) {
          const double face = wall.upper ? upper[wall.axis] : lower[wall.axis];
          if (std::abs(x[i][wall.axis] - face) <= near) take(i);
        } else {
          std::array<double, 3> at{};
          for (int k = 0; k < D; ++k) at[static_cast<std::size_t>(k)] = x[i][k];
          if (wall.test(at)) take(i);
        }
      }
    }
    require(caught > 0, "Wall.nodes", caught, "the wall must catch at least one node of the mesh");
  }
  if (axis_nodes)
    for (Index i = 0; i < n; ++i) {
      if (!used(i)) continue;
      require(x[i][0] >= -near, "Axisymmetric: r", x[i][0], "nodes must have r >= 0");
      if (x[i][0] <= near) blocked[i].add(Vec<double, D>::Unit(0));
    }
  std::vector<Constraint<T, D>> constraints;
  for (Index i = 0; i < n; ++i) {
    if (blocked[i].count == 0) continue;
    const auto q = blocked[i].directions.leftCols(blocked[i].count);
    Mat<double, D> projector = Mat<double, D>::Identity();
    if (blocked[i].count == D)
      projector.setZero();
    else
      projector -= q.lazyProduct(q.transpose());
    constraints.push_back({i, projector.template cast<T>()});
  }
  return constraints;
}

/// Removes the blocked part of the velocities of a field. Returns the impulse that the walls gave, N s.
template <class T, int D, class Velocities>
Vec<T, D> constrain(const std::vector<Constraint<T, D>>& constraints, const std::vector<T>& mass,
                    Velocities& velocity) {
  Vec<T, D> impulse = Vec<T, D>::Zero();
  for (const auto& c : constraints) {
    if (mass[c.node] == 0) continue;
    const Vec<T, D> allowed = c.projector * velocity[c.node];
    impulse += mass[c.node] * (allowed - velocity[c.node]);
    velocity[c.node] = allowed;
  }
  return impulse;
}

}  // namespace arenite::inline ARENITE_INSTRUCTION_SET
