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

#if ARENITE_HAS_COLD

#include <algorithm>
#include <cmath>
#include <limits>

#include <arenite/boundary/walls.hpp>
#include <arenite/geometry/box.hpp>

namespace arenite::inline ARENITE_INSTRUCTION_SET::detail {

template <int D>
Box<std::size_t{D}> box_of(const AnyDistance& distance, const Pose<D>& pose) {
  return moved_box<D>(distance.bounds<D>(), pose.rotation,
                      pose.centre + pose.displacement - pose.rotation * pose.centre);
}

/// Least distance from the body's surface, m, of places on the plane x[axis] = at within the mesh, and such a
/// place.
template <int D>
struct OnPlane {
  double distance = std::numeric_limits<double>::infinity();
  Vec<double, D> place = Vec<double, D>::Zero();
};
template <int D>
OnPlane<D> nearest_on_plane(const AnyDistance& distance, const Pose<D>& pose, const MeshSides<D>& mesh,
                            std::size_t axis, double at) {
  constexpr int places = D == 2 ? 65 : 17;  // along each axis
  const auto box = box_of(distance, pose);
  OnPlane<D> found;
  if (!(box.lower[axis] < at && at < box.upper[axis])) return found;
  Vec<double, D> from, step = Vec<double, D>::Zero();
  for (std::size_t k = 0; k < D; ++k) {
    const auto i = static_cast<int>(k);
    from[i] = at;
    if (k == axis) continue;
    from[i] = std::max(box.lower[k], mesh.sides[2 * k].at);
    step[i] = (std::min(box.upper[k], mesh.sides[2 * k + 1].at) - from[i]) / (places - 1);
    if (!(step[i] >= 0)) return found;
  }
  const auto first = static_cast<int>(axis == 0), second = static_cast<int>(axis <= 1 ? 2 : 1);
  for (int a = 0; a < places; ++a)
    for (int b = 0; b < (D == 2 ? 1 : places); ++b) {
      Vec<double, D> x = from;
      x[first] += a * step[first];
      if constexpr (D == 3) x[second] += b * step[second];
      const auto own = in_space<double, D>(pose.to_body(x));
      double d;
      distance.at({&own, 1}, &d);
      if (d < found.distance) found = {d, x};
    }
  return found;
}

/// Whether no part of the body is within the mesh.
template <int D>
bool is_outside(const AnyDistance& distance, const Pose<D>& pose, const MeshSides<D>& mesh) {
  const auto box = box_of(distance, pose);
  for (std::size_t k = 0; k < D; ++k)
    if (box.upper[k] < mesh.sides[2 * k].at || box.lower[k] > mesh.sides[2 * k + 1].at) return true;
  return false;
}

template <int D>
ARENITE_COLD WatchedRigid first_look(const AnyDistance& distance, const Pose<D>& pose,
                                     const MeshSides<D>& mesh) {
  WatchedRigid body;
  for (std::size_t s = 0; s < 2 * D; ++s)
    body.crossed[s] =
        nearest_on_plane(distance, pose, mesh, s / 2, mesh.sides[s].at).distance < -1e-3 * mesh.cell;
  body.tells_of_mesh = !is_outside(distance, pose, mesh);
  return body;
}

template <int D>
ARENITE_COLD std::string look_at_walls(WatchedRigid& body, const AnyDistance& distance, const Pose<D>& pose,
                                       const MeshSides<D>& mesh) {
  if (body.tells_of_mesh && is_outside(distance, pose, mesh)) {
    body.tells_of_mesh = body.tells_of_walls = false;
    return joined_text({" has left the mesh: its centre is at ",
                        vector_text(Vec<double, D>(pose.centre + pose.displacement)),
                        " m, and no matter meets it there"});
  }
  if (!body.tells_of_walls) return {};
  const double quarter = mesh.cell / 4;
  for (std::size_t s = 0; s < 2 * D; ++s) {
    const auto& side = mesh.sides[s];
    if (!side.holds || body.crossed[s]) continue;
    const bool upper = s % 2 == 1;
    const auto found = nearest_on_plane(distance, pose, mesh, s / 2, side.at + (upper ? quarter : -quarter));
    if (!(found.distance < 0)) continue;
    body.tells_of_walls = false;
    return joined_text(
        {" has passed the wall at the ", place_name(static_cast<int>(s / 2), upper, ""), " by ", quarter,
         " m, a quarter of a cell, at ", vector_text(found.place),
         " m: walls hold matter alone; RigidContact.walls = Friction(..) holds rigid bodies, too"});
  }
  return {};
}

#define ARENITE_INSTANCES(D)                                                                 \
  template WatchedRigid first_look(const AnyDistance&, const Pose<D>&, const MeshSides<D>&); \
  template std::string look_at_walls(WatchedRigid&, const AnyDistance&, const Pose<D>&, const MeshSides<D>&);
ARENITE_FOR_DIMENSIONS(ARENITE_INSTANCES)
#undef ARENITE_INSTANCES

}  // namespace arenite::inline ARENITE_INSTRUCTION_SET::detail

#endif  // ARENITE_HAS_COLD
