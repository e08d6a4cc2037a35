// Walls: which nodes may not move, and in which directions. A wall blocks the velocity along some normals;
// at a node of several walls their blocked directions add up.
#pragma once
// SPDX-License-Identifier: BSD-3-Clause

#include <array>
#include <cmath>
#include <concepts>
#include <functional>
#include <initializer_list>
#include <string>
#include <utility>
#include <vector>

#include <arenite/boundary/constraints.hpp>
#include <arenite/core/cold.hpp>
#include <arenite/core/vector_argument.hpp>

namespace arenite::inline ARENITE_INSTRUCTION_SET {

/// The directions that a wall blocks.
struct Condition {
  enum class Kind { all, face_normal, normal, all_but } kind;
  std::array<double, 3> direction{};  ///< `normal`: the blocked direction; `all_but`: the free one
};
inline constexpr Condition fixed{Condition::Kind::all};  ///< no motion
inline constexpr Condition roller{
    Condition::Kind::face_normal};  ///< no motion across the face: a smooth wall, or a symmetry plane
/// No motion across a plane with this normal (any length): a smooth wall or a symmetry plane along no axis.
constexpr Condition symmetry(std::array<double, 3> normal) { return {Condition::Kind::normal, normal}; }
/// Motion only along this axis.
constexpr Condition free_along(std::size_t axis) {
  Condition c{Condition::Kind::all_but};
  if (axis < 3) c.direction[axis] = 1;  // an axis that the scene does not have is refused by `Walls`
  return c;
}

/// Name of a place on the hull of a mesh: the side of the box around it, normal to `axis`, or the node
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
  std::string given_name{};  ///< by `named`; empty: none

  /// Name of the wall: the one given, else that of its face or node set.
  std::string name() const { return given_name.empty() ? place_name(axis, upper, set) : given_name; }
};
/// `named("platen", where(..))`: the wall under this name, by which its reaction is read.
inline Wall named(std::string name, Wall wall) {
  wall.given_name = std::move(name);
  return wall;
}

namespace detail {

Wall face_wall(int axis, bool upper, const Condition& condition);

}  // namespace detail

/// Faces of the box around the mesh: `left` and `right` at the ends of x (the inner and outer radius),
/// `bottom` and `top` of y, `front` and `back` of z.
inline Wall left(const Condition& c) { return detail::face_wall(0, false, c); }
inline Wall right(const Condition& c) { return detail::face_wall(0, true, c); }
inline Wall bottom(const Condition& c) { return detail::face_wall(1, false, c); }
inline Wall top(const Condition& c) { return detail::face_wall(1, true, c); }
inline Wall front(const Condition& c) { return detail::face_wall(2, false, c); }
inline Wall back(const Condition& c) { return detail::face_wall(2, true, c); }
/// The nodes of a named set of a simplex mesh.
inline Wall on(std::string set, Condition c) { return {-1, false, std::move(set), {}, c}; }
/// The nodes whose position (x, y, z = 0 in two dimensions), m, passes a test.
inline Wall where(std::function<bool(const std::array<double, 3>&)> test, Condition c) {
  return {-1, false, {}, std::move(test), c};
}

/// Walls of a scene: a part that constrains. Throws `error` for a wall that has no node, a face beyond
/// the dimension, a roller that is no face, or an invalid direction.
struct Walls {
  static constexpr bool reads_start_state = false;
  std::vector<Wall> list;

  const std::vector<Wall>& walls_here() const { return list; }
  template <int D>
  void constrain(BoundaryNodes<D>& nodes) const;

  /// Throws `error` for a wall that is invalid in D dimensions on any mesh. Returns the direction that its
  /// condition names; zero if it names none.
  template <int D>
  static Vec<double, D> check(const Wall& wall);
};
namespace detail {

/// Copies of some walls.
Walls walls_of(std::initializer_list<const Wall*> walls);

}  // namespace detail

/// `walls(bottom(fixed), left(roller), ..)`
template <std::same_as<Wall>... W>
Walls walls(const W&... wall) {
  return detail::walls_of({&wall...});
}
/// Refused by the compiler: a place without a condition.
template <class... W>
requires(!(std::same_as<W, Wall> && ...)) Walls walls(const W&...) {
  static_assert(
      (std::same_as<W, Wall> && ...),
      "walls: each is a place with its condition: bottom(fixed), on(\"set\", fixed), where(test, roller)");
  return {};
}

}  // namespace arenite::inline ARENITE_INSTRUCTION_SET

#if ARENITE_HAS_COLD

namespace arenite::inline ARENITE_INSTRUCTION_SET {

template <int D>
ARENITE_COLD Vec<double, D> Walls::check(const Wall& wall) {
  using Kind = Condition::Kind;
  const Condition& c = wall.condition;
  const int kind = static_cast<int>(c.kind);
  require(kind >= 0 && kind <= static_cast<int>(Kind::all_but), "Condition.kind", kind, "must be 0 to 3");
  require(wall.axis < D, "Wall.axis", wall.axis, "must be an axis of the scene");
  require(wall.axis >= 0 || c.kind != Kind::face_normal, "Wall.condition", "roller",
          "needs a face (left, right, ..); elsewhere name the plane: symmetry(normal)");
  require(wall.axis >= 0 || !wall.set.empty() || wall.test, "Wall.set", wall.set,
          "must name a node set (or the wall a face or a test)");
  if (c.kind != Kind::normal && c.kind != Kind::all_but) return zeros<Vec<double, D>>();
  return direction_argument<double, D>(c.kind == Kind::normal ? "symmetry.normal" : "free_along.axis",
                                       c.direction);
}

namespace detail {

ARENITE_COLD Wall face_wall(int axis, bool upper, const Condition& condition) {
  return {axis, upper, {}, {}, condition};
}

ARENITE_COLD Walls walls_of(std::initializer_list<const Wall*> walls) {
  Walls all;
  all.list.reserve(walls.size());
  for (const Wall* const wall : walls) all.list.push_back(*wall);
  return all;
}

/// Blocks the nodes of one wall.
template <int D>
ARENITE_COLD void catch_nodes(const Wall& wall, BoundaryNodes<D>& nodes) {
  using V = Vec<double, D>;
  using Kind = Condition::Kind;
  const Condition& c = wall.condition;
  require(wall.axis < 0 || !nodes.is_periodic(wall.axis), "Wall.axis", wall.axis,
          "is periodic: the mesh has no face there");
  const V direction = Walls::check<D>(wall);
  Index caught = 0;
  const auto take = [&](Index i) {
    for (int k = 0; k < D; ++k)
      if (c.kind == Kind::all || (c.kind == Kind::face_normal && k == wall.axis) ||
          (c.kind == Kind::all_but && direction[k] == 0)) {
        V axis = zeros<V>();
        axis[k] = 1;
        nodes.block(i, axis);
      }
    if (c.kind == Kind::normal) nodes.block(i, direction);
    ++caught;
  };
  if (!wall.set.empty()) {
    const std::vector<Index>* const set = nodes.node_set(wall.set);
    if (set == nullptr)
      throw error(joined_text(
          {"Wall.set = ", wall.set, ": a Cartesian grid has no node sets; use faces or where(test)"}));
    for (const Index i : *set) take(i);
  } else {
    for (Index i = 0; i < nodes.size(); ++i) {
      if (!nodes.is_used(i)) continue;
      const V& x = nodes.position(i);
      if (wall.axis >= 0) {
        const double face = (wall.upper ? nodes.upper() : nodes.lower())[wall.axis];
        if (std::abs(x[wall.axis] - face) <= nodes.tolerance()) take(i);
      } else {
        if (wall.test(in_space(x))) take(i);
      }
    }
  }
  require(caught > 0 || nodes.is_part(), "Wall.nodes", caught,
          "the wall must catch at least one node of the mesh");
}

}  // namespace detail

template <int D>
ARENITE_COLD void Walls::constrain(BoundaryNodes<D>& nodes) const {
  for (std::size_t k = 0; k < list.size(); ++k) {
    nodes.set_wall(k);
    detail::catch_nodes(list[k], nodes);
  }
}

#define ARENITE_INSTANCES(D)                               \
  template void Walls::constrain(BoundaryNodes<D>&) const; \
  template Vec<double, D> Walls::check(const Wall&);
ARENITE_FOR_DIMENSIONS(ARENITE_INSTANCES)
#undef ARENITE_INSTANCES

}  // namespace arenite::inline ARENITE_INSTRUCTION_SET

#endif  // ARENITE_HAS_COLD
