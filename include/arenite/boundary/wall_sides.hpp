// Sides of the box around a mesh at which walls constrain the matter: planes that rigid bodies may pass.
#pragma once
// SPDX-License-Identifier: BSD-3-Clause

#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

#include <arenite/boundary/constraints.hpp>
#include <arenite/parallel/communicator.hpp>

namespace arenite::inline ARENITE_INSTRUCTION_SET {

/// One side: number 2 axis, or 2 axis + 1 at the upper end (`place_name`).
struct WallSide {
  double at = 0;          ///< position on its axis, m
  bool holds = false;     ///< whether walls, also frictional ones, constrain all of its nodes across it
  bool is_smooth = true;  ///< whether some of them may move along it, as at a plane of symmetry
};

/// The box around a mesh, to check the positions of rigid bodies.
template <int D>
struct MeshSides {
  std::array<WallSide, 2 * D> sides{};
  double cell = 0;  ///< edge of the smallest cell, m
};

/// State of the checks of one rigid body.
struct WatchedRigid {
  std::array<bool, 6> crossed{};                      ///< [sides] at the first check
  bool tells_of_walls = true, tells_of_mesh = false;  ///< whether still to be reported
};

/// The sides of the box around the whole mesh. Nodes that a part moves do not count as constrained.
template <class Scene>
auto wall_sides(const Scene& scene) {
  constexpr int D = Scene::D;
  constexpr unsigned every_axis = (1u << D) - 1, rough = 1u << D;
  typename Scene::Nodes nodes(scene.mesh);
  if constexpr (Scene::is_portion) nodes.set_whole(scene.portion().lower, scene.portion().upper);
  std::vector<unsigned> held(nodes.size(), 0);  // a bit an axis, and one for friction
  for (const auto& c : scene.constraints) {
    for (int k = 0; k < D; ++k) {
      bool across = true;
      for (int i = 0; i < D; ++i) across = across && std::abs(c.projector(i, k)) <= 1e-6;
      held[c.node] |= across ? 1u << k : 0;
    }
    if (held[c.node] == every_axis) held[c.node] |= rough;
  }
  if constexpr (Scene::Needs::drives)
    for (const auto& drive : scene.drives) held[drive.node] = 0;
  scene.for_each_part([&](const auto& part) {
    if constexpr (requires { part.visit_wall_nodes([](Index, const auto&) {}); })
      part.visit_wall_nodes([&](Index i, const auto& normal) {
        for (int k = 0; k < D; ++k) held[i] |= std::abs(normal[k]) > 1e-3 ? 1u << k | rough : 0;
      });
  });
  std::array<WallSide, 2 * D> sides{};
  for (int s = 0; s < 2 * D; ++s) {
    auto& side = sides[static_cast<std::size_t>(s)];
    const int axis = s / 2;
    side.at = (s % 2 == 1 ? nodes.upper() : nodes.lower())[axis];
    double some = 0, open = 0, slip = 0;
    for (Index i = 0; i < nodes.size(); ++i) {
      if (!nodes.is_used(i) || !(std::abs(nodes.position(i)[axis] - side.at) <= nodes.tolerance())) continue;
      ++some;
      open += (held[i] & 1u << axis) == 0;
      slip += (held[i] & rough) == 0;
    }
    sum_over(scene.communicator(), some, open, slip);
    side.holds = some > 0 && open == 0 && !nodes.is_periodic(axis);
    side.is_smooth = slip > 0;
  }
  return sides;
}

}  // namespace arenite::inline ARENITE_INSTRUCTION_SET
