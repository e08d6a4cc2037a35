// Cold functions of walls.hpp.
#pragma once
// SPDX-License-Identifier: BSD-3-Clause

#include <cmath>

#include <arenite/boundary/constraints_cold.hpp>
#include <arenite/boundary/walls.hpp>

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
