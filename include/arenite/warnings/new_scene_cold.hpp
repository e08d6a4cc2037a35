// Cold functions of new_scene_warnings.hpp.
#pragma once
// SPDX-License-Identifier: BSD-3-Clause

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>

#include <arenite/core/warning.hpp>
#include <arenite/warnings/new_scene.hpp>

namespace arenite::inline ARENITE_INSTRUCTION_SET::shared_detail {

ARENITE_COLD void warn_bounds(const NewScene& scene, std::size_t body) {
  const MeshBox& mesh = scene.mesh;
  double within = 1;
  bool beyond = false;
  for (std::size_t k = 0; k < scene.dimension; ++k) {
    const double lower = scene.lower[3 * body + k], upper = scene.upper[3 * body + k];
    const double from = std::isinf(lower) ? mesh.lower[k] : lower;
    const double to = std::isinf(upper) ? mesh.upper[k] : upper;
    beyond = beyond || std::max(mesh.lower[k] - from, to - mesh.upper[k]) > 0.01 * mesh.least;
    within *= (std::min(to, mesh.upper[k]) - std::max(from, mesh.lower[k])) / (to - from);
  }
  if (!beyond) return;
  warn(joined_text({"body ", scene.name(body), ": ", std::round(1000 * (1 - within)) / 10,
                    " % of its region lies outside of the mesh, which reaches from ",
                    vector_text(std::span(mesh.lower).first(scene.dimension)), " to ",
                    vector_text(std::span(mesh.upper).first(scene.dimension)), " m, and is not filled"}));
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
    constexpr double all = std::numeric_limits<double>::infinity();
    for (std::size_t k = 0; k < 3; ++k) {
      to.lower.push_back(body.region->has_bounds ? body.region->lower[k] : -all);
      to.upper.push_back(body.region->has_bounds ? body.region->upper[k] : all);
    }
    to.points.push_back(static_cast<double>(body.cell->size()));
    to.initial_volume.push_back(body.initial_volume);
    to.region_volume.push_back(body.region_volume);
    to.density.push_back(body.density);
    for (const auto& other : bodies)
      to.within.push_back(&other == &body ? 0.0 : static_cast<double>(points_within(body, other)));
  }
}

ARENITE_COLD void warn_of(const NewScene& scene) {
  const std::size_t count = scene.points.size();
  const auto whole = [](double number) { return static_cast<std::size_t>(number); };
  for (std::size_t b = 0; b < count; ++b) {
    warn_bounds(scene, b);
    for (std::size_t a = 0; a < b; ++a) {
      const std::size_t in_b = whole(scene.within[a * count + b]), in_a = whole(scene.within[b * count + a]);
      if (in_b + in_a == 0) continue;
      warn(joined_text({"body ", scene.name(a), " and body ", scene.name(b), " lie in one place: ", in_b,
                        " of the ", whole(scene.points[a]), " points of body ", scene.name(a),
                        " are in the region of body ", scene.name(b), ", and ", in_a, " of ",
                        whole(scene.points[b]), " the other way"}));
    }
  }
  for (std::size_t b = 0; b < count; ++b) {
    const std::size_t points = whole(scene.points[b]);
    warn_volume(scene.name(b), points, scene.density[b], scene.initial_volume[b], scene.region_volume[b]);
    if (points == 0 || points > scene.dimension) continue;
    warn(joined_text({"body ", scene.name(b), " has ", points, points == 1 ? " point" : " points",
                      ": fewer than ", scene.dimension + 1,
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

}  // namespace arenite::inline ARENITE_INSTRUCTION_SET::shared_detail
