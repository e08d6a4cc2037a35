// A rigid body that passes a wall of the mesh, which holds the matter alone, or leaves the mesh: what `run` tells.
#pragma once
// SPDX-License-Identifier: BSD-3-Clause

#include <string>

#include <arenite/boundary/wall_sides.hpp>
#include <arenite/core/cold.hpp>
#include <arenite/rigid/body/pose.hpp>
#include <arenite/rigid/body/signed_distance.hpp>

namespace arenite::inline ARENITE_INSTRUCTION_SET::detail {

/// At the start: a side that the body crosses there is a plane of symmetry, or has it stand out on purpose, and a body outside of the
/// mesh has not left it.
template <int D>
WatchedRigid first_look(const AnyDistance& distance, const Pose<D>& pose, const MeshSides<D>& mesh);

/// What there is to say of the body now; empty: nothing. Each is said once.
template <int D>
std::string look_at_walls(WatchedRigid& body, const AnyDistance& distance, const Pose<D>& pose,
                          const MeshSides<D>& mesh);

}  // namespace arenite::inline ARENITE_INSTRUCTION_SET::detail

#ifndef ARENITE_COLD_LIBRARY
#include <arenite/rigid/body/past_walls_cold.hpp>
#endif
