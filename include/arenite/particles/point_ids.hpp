// Ids of points: numbers that a point keeps as it moves from place to place in its columns, from body to body
// and from machine to machine.
#pragma once
// SPDX-License-Identifier: BSD-3-Clause

#include <cstdint>
#include <string_view>

#include <arenite/particles/material_point.hpp>

namespace arenite::inline ARENITE_INSTRUCTION_SET {

/// A part that gives each point of a scene an id of 64 bits, in `points.id`; without it none are stored. The
/// points that there are get `first`, .., body by body, in the order in which cells were filled; those
/// inserted later the next ones, unless they bring one. Scenes that share a mesh begin at different numbers.
struct PointIds {
  struct NumberOfPoints;
  using OnlyOne = NumberOfPoints;
  static constexpr bool needs_point_ids = true;
  static constexpr std::string_view state_name = "point_ids";

  std::uint64_t first = 0;  ///< of the next point
  template <class Scene>
  void connect(Scene& scene) {
    scene.for_each_body([&](auto& body, const auto&) {
      for (auto& id : body.points.id) id = first++;
    });
  }
  template <class F>
  void visit_state(F&& f) {
    f("next", first);
  }
};

}  // namespace arenite::inline ARENITE_INSTRUCTION_SET
