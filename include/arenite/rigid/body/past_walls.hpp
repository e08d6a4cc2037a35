// Messages for `run` on a rigid body that passes a wall, which stops only matter, or leaves the mesh.
#pragma once
// SPDX-License-Identifier: BSD-3-Clause

#include <string>

#include <arenite/boundary/wall_sides.hpp>
#include <arenite/core/cold.hpp>
#include <arenite/geometry/signed_distance.hpp>
#include <arenite/rigid/body/pose.hpp>

namespace arenite::inline ARENITE_INSTRUCTION_SET::detail {

/// State at the start: a side that the body crosses then is a plane of symmetry, or the body extends beyond
/// it on purpose, and a body outside of the mesh has not left it.
template <int D>
WatchedRigid first_look(const AnyDistance& distance, const Pose<D>& pose, const MeshSides<D>& mesh);

/// Message on the body's present pose; empty if there is none. Each message is given once.
template <int D>
std::string look_at_walls(WatchedRigid& body, const AnyDistance& distance, const Pose<D>& pose,
                          const MeshSides<D>& mesh);

}  // namespace arenite::inline ARENITE_INSTRUCTION_SET::detail

#ifndef ARENITE_COLD_LIBRARY
#include <arenite/rigid/body/past_walls_cold.hpp>
#endif
