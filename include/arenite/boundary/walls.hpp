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

#ifndef ARENITE_COLD_LIBRARY
#include <arenite/boundary/walls_cold.hpp>
#endif
