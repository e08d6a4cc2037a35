// Walls: which nodes may not move, and in which directions. A wall blocks the velocity along some normals;
// where several walls meet at a node their blocked directions add up.
#pragma once

#include <array>
#include <cmath>
#include <concepts>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include <arenite/boundary/constraints.hpp>
#include <arenite/core/vector_argument.hpp>

namespace arenite::inline ARENITE_INSTRUCTION_SET {

/// What a wall blocks.
struct Condition {
  enum class Kind { all, face_normal, normal, all_but } kind;
  std::array<double, 3> direction{};  ///< `normal`: the blocked direction; `all_but`: the free one
};
inline constexpr Condition fixed{Condition::Kind::all};  ///< no motion
inline constexpr Condition roller{
    Condition::Kind::face_normal};  ///< no motion across the face: a smooth wall, or a symmetry plane
/// No motion across a plane with this normal (any length): a smooth wall or a symmetry plane along no axis.
constexpr Condition symmetry(std::array<double, 3> normal) { return {Condition::Kind::normal, normal}; }
/// Motion along this axis alone.
constexpr Condition free_along(std::size_t axis) {
  Condition c{Condition::Kind::all_but};
  if (axis < 3) c.direction[axis] = 1;  // an axis that the scene does not have is refused by `Walls`
  return c;
}

/// What a place on the hull of a mesh is called: the side of the box around it, normal to `axis`, or the node
/// set, or "where".
inline std::string place_name(int axis, bool upper, const std::string& set) {
  static constexpr std::array<const char*, 6> sides{"left", "right", "bottom", "top", "front", "back"};
  if (axis >= 0 && axis < 3) return sides[static_cast<std::size_t>(2 * axis + upper)];
  return set.empty() ? "where" : set;
}

/// One wall: which nodes, and what is blocked there.
struct Wall {
  int axis = -1;                                             ///< face: normal axis; -1: not a face
  bool upper = false;                                        ///< face: at the upper or lower end of the mesh
  std::string set{};                                         ///< name of a node set of a simplex mesh
  std::function<bool(const std::array<double, 3>&)> test{};  ///< any test of a node's position, m
  Condition condition = fixed;
  std::string given_name{};  ///< where there is no better one

  /// What the wall is called: its face, its node set, or the name given.
  std::string name() const { return given_name.empty() ? place_name(axis, upper, set) : given_name; }
};
/// `named("platen", where(..))`: the wall under a name of its own, by which its reaction is read.
inline Wall named(std::string name, Wall wall) {
  wall.given_name = std::move(name);
  return wall;
}

/// Faces of the box around the mesh: `left` and `right` at the ends of x (the inner and outer radius),
/// `bottom` and `top` of y, `front` and `back` of z.
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

/// Walls of a scene: a part that constrains. Throws `error` for a wall that catches no node, a face beyond
/// the dimension, a roller that is no face, or a direction that is none.
struct Walls {
  static constexpr bool reads_start_state = false;
  std::vector<Wall> list;

  const std::vector<Wall>& walls_here() const { return list; }
  template <class Shape, class M>
  void constrain(NodeConstraints<Shape, M>& nodes) const {
    for (const Wall& wall : list) catch_nodes(wall, nodes);
  }

  /// What can be said of a wall in D dimensions without a mesh. Returns the direction that its condition
  /// names; zero if it names none.
  template <int D>
  static Vec<double, D> check(const Wall& wall) {
    using Kind = Condition::Kind;
    const Condition& c = wall.condition;
    require(wall.axis < D, "Wall.axis", wall.axis, "must be an axis of the scene");
    require(wall.axis >= 0 || c.kind != Kind::face_normal, "Wall.condition", "roller",
            "needs a face (left, right, ..); elsewhere name the plane: symmetry(normal)");
    require(wall.axis >= 0 || !wall.set.empty() || wall.test, "Wall.set", wall.set,
            "must name a node set (or the wall a face or a test)");
    if (c.kind != Kind::normal && c.kind != Kind::all_but) return Vec<double, D>::Zero();
    return direction_argument<double, D>(c.kind == Kind::normal ? "symmetry.normal" : "free_along.axis",
                                         c.direction);
  }

 private:
  template <class Shape, class M>
  static void catch_nodes(const Wall& wall, NodeConstraints<Shape, M>& nodes) {
    constexpr int D = M::dimension;
    using V = Vec<double, D>;
    using Kind = Condition::Kind;
    const Condition& c = wall.condition;
    require(wall.axis < 0 || !is_periodic<M>(wall.axis), "Wall.axis", wall.axis,
            "is periodic: the mesh has no face there");
    const V direction = check<D>(wall);
    Index caught = 0;
    const auto take = [&](Index i) {
      for (int k = 0; k < D; ++k)
        if (c.kind == Kind::all || (c.kind == Kind::face_normal && k == wall.axis) ||
            (c.kind == Kind::all_but && direction[k] == 0))
          nodes.block(i, V::Unit(k));
      if (c.kind == Kind::normal) nodes.block(i, direction);
      ++caught;
    };
    if (!wall.set.empty()) {
      if constexpr (is_simplex_mesh<M>) {
        for (const Index i : nodes.mesh().node_set(wall.set)) take(i);
      } else {
        throw error(joined_text({"Wall.set = ", wall.set,
                                ": a Cartesian grid has no node sets; use faces or where(test)"}));
      }
    } else {
      for (Index i = 0; i < nodes.size(); ++i) {
        if (!nodes.is_used(i)) continue;
        const V& x = nodes.position(i);
        if (wall.axis >= 0) {
          const double face = (wall.upper ? nodes.upper() : nodes.lower())[wall.axis];
          if (std::abs(x[wall.axis] - face) <= nodes.near()) take(i);
        } else {
          if (wall.test(in_space(x))) take(i);
        }
      }
    }
    require(caught > 0 || nodes.is_part(), "Wall.nodes", caught,
            "the wall must catch at least one node of the mesh");
  }
};
/// `walls(bottom(fixed), left(roller), ..)`
template <std::same_as<Wall>... W>
Walls walls(W... wall) {
  return {{std::move(wall)...}};
}
/// Refused by the compiler: a place without a condition.
template <class... W>
requires(!(std::same_as<W, Wall> && ...)) Walls walls(W...) {
  static_assert(
      (std::same_as<W, Wall> && ...),
      "walls: each is a place with its condition: bottom(fixed), on(\"set\", fixed), where(test, roller)");
  return {};
}

}  // namespace arenite::inline ARENITE_INSTRUCTION_SET
