// Driven walls: nodes that move as prescribed.
#pragma once
// SPDX-License-Identifier: BSD-3-Clause

#include <string>
#include <utility>

#include <arenite/boundary/walls.hpp>
#include <arenite/functions/place_function.hpp>

namespace arenite::inline ARENITE_INSTRUCTION_SET {

/// A wall whose nodes have a prescribed velocity, m/s, along the directions that the wall blocks: with
/// `roller` only along the normal, so that matter slides along the moving wall; with `fixed` along all. See
/// `driven`.
struct Driven {
  Wall wall;
  VectorFunction velocity;
};

/// `driven(top(roller), {0, -0.1})`, a velocity in time `driven(top(roller), {0, -1}, Ramp{..})`, or any
/// function of time, or of place and time, that returns (x, y, z). It moves the velocities of nodes, not the
/// nodes: on a fixed mesh matter enters or leaves through the wall, which is accurate while the motion is
/// small compared with a cell. The work is recorded in `Energies::external`.
inline Driven driven(Wall wall, VectorFunction velocity) { return {std::move(wall), std::move(velocity)}; }
inline Driven driven(Wall wall, const Triple& direction, const ScalarFunction& speed) {
  return {std::move(wall), VectorFunction(direction, speed)};
}

/// A driven wall in a scene: a part that constrains and drives.
template <class T, int D>
struct BoundDriven {
  static constexpr bool reads_start_state = false;
  Walls walls;
  VectorFunction velocity;
  std::string name;

  const std::vector<Wall>& walls_here() const { return walls.list; }
  template <class Nodes>
  void constrain(Nodes& nodes) const {
    walls.constrain(nodes);
  }
  Vec<T, D> driven_velocity(const Vec<T, D>& position, double time) const {
    return value_at(velocity, position, time, name);
  }
};

template <class Traits>
BoundDriven<typename Traits::T, Traits::D> bind_part(const Driven& driven, const Traits&) {
  return {{{driven.wall}}, driven.velocity, joined_text({"velocity of the wall ", driven.wall.name()})};
}

}  // namespace arenite::inline ARENITE_INSTRUCTION_SET
