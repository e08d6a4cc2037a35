// Cold functions of new_scene_warnings.hpp.
#pragma once
// SPDX-License-Identifier: BSD-3-Clause

#include <algorithm>
#include <cmath>
#include <span>

#include <arenite/core/warning.hpp>
#include <arenite/scene/new_scene_warnings.hpp>

namespace arenite::inline ARENITE_INSTRUCTION_SET::detail {

ARENITE_COLD void warn_bounds(const MeshBox& mesh, std::size_t dimensions, const NewScene::OfBody& region) {
  if (!region.has_bounds) return;
  double within = 1;
  bool beyond = false;
  for (std::size_t k = 0; k < dimensions; ++k) {
    const double from = std::isinf(region.lower[k]) ? mesh.lower[k] : region.lower[k];
    const double to = std::isinf(region.upper[k]) ? mesh.upper[k] : region.upper[k];
    beyond = beyond || std::max(mesh.lower[k] - from, to - mesh.upper[k]) > 0.01 * mesh.least;
    within *= (std::min(to, mesh.upper[k]) - std::max(from, mesh.lower[k])) / (to - from);
  }
  if (!beyond) return;
  warn(joined_text({"body ", region.name, ": ", std::round(1000 * (1 - within)) / 10,
                    " % of its region lies outside of the mesh, which reaches from ",
                    vector_text(std::span(mesh.lower).first(dimensions)), " to ",
                    vector_text(std::span(mesh.upper).first(dimensions)), " m, and is not filled"}));
}

ARENITE_COLD void warn_volume(const std::string& name, std::size_t points, double density, double filled,
                              double region) {
  if (std::abs(filled - region) <= 0.02 * region || points == 0) return;
  warn(joined_text(
      {"body ", name, ": its points have ", density * filled, " kg, its region ", density * region,
       " kg: a point stands for all of its sub-cell, if the middle of that lies in the region; let "
       "the region end on sub-cells, or say FillOptions.exact_volume"}));
}

/// Points of a body that lie in the region of another.
template <class T, int D>
ARENITE_COLD std::size_t points_within(const BodySummary<T, D>& body, const BodySummary<T, D>& other) {
  std::size_t count = 0;
  if (other.region->test) {
    for (const auto& x : *body.position) count += other.region->contains(x);
  } else if (!other.cells.empty()) {
    for (const Index c : *body.cell) count += static_cast<std::size_t>(other.cells[c]);
  }
  return count;
}

template <class T, int D>
ARENITE_COLD void count_bodies(std::span<const BodySummary<T, D>> bodies, NewScene& to) {
  for (const auto& body : bodies) {
    to.bodies.push_back({body.name, body.region->has_bounds, body.region->lower, body.region->upper,
                         static_cast<double>(body.cell->size()), body.initial_volume, body.region_volume,
                         body.density});
    for (const auto& other : bodies)
      to.within.push_back(&other == &body ? 0.0 : static_cast<double>(points_within(body, other)));
  }
}

ARENITE_COLD void warn_of(const NewScene& scene) {
  const auto& bodies = scene.bodies;
  const auto whole = [](double count) { return static_cast<std::size_t>(count); };
  for (std::size_t b = 0; b < bodies.size(); ++b) {
    warn_bounds(scene.mesh, scene.dimension, bodies[b]);
    for (std::size_t a = 0; a < b; ++a) {
      const std::size_t in_b = whole(scene.within[a * bodies.size() + b]),
                        in_a = whole(scene.within[b * bodies.size() + a]);
      if (in_b + in_a == 0) continue;
      warn(joined_text({"body ", bodies[a].name, " and body ", bodies[b].name, " lie in one place: ", in_b,
                        " of the ", whole(bodies[a].points), " points of body ", bodies[a].name,
                        " are in the region of body ", bodies[b].name, ", and ", in_a, " of ",
                        whole(bodies[b].points), " the other way"}));
    }
  }
  for (const auto& body : bodies) {
    const std::size_t count = whole(body.points);
    warn_volume(body.name, count, body.density, body.initial_volume, body.region_volume);
    if (count == 0 || count > scene.dimension) continue;
    warn(joined_text({"body ", body.name, " has ", count, count == 1 ? " point" : " points", ": fewer than ",
                      scene.dimension + 1,
                      " cannot strain as a body; is its region, or the mesh's cell, of the size that was "
                      "meant?"}));
  }
  if (scene.falls)
    warn(joined_text({"gravity ", scene.gravity,
                      " m/s2 acts, but no wall and no rigid body holds along it: everything falls"}));
}

template <class T, int D>
ARENITE_COLD bool holds_gravity(const std::vector<Constraint<T, D>>& constraints, const Vec<T, D>& gravity) {
  const T magnitude = gravity.norm();
  if (!(magnitude > 0)) return true;
  for (const auto& c : constraints) {
    Vec<T, D> blocked = gravity;
    for (int i = 0; i < D; ++i)
      for (int k = 0; k < D; ++k) blocked[i] -= c.projector(i, k) * gravity[k];
    if (blocked.norm() > 1e-6 * magnitude) return true;
  }
  return false;
}

#define ARENITE_INSTANCES(T, D)                                              \
  template void count_bodies(std::span<const BodySummary<T, D>>, NewScene&); \
  template bool holds_gravity(const std::vector<Constraint<T, D>>&, const Vec<T, D>&);
ARENITE_FOR_NUMBERS_AND_DIMENSIONS(ARENITE_INSTANCES)
#undef ARENITE_INSTANCES

}  // namespace arenite::inline ARENITE_INSTRUCTION_SET::detail
