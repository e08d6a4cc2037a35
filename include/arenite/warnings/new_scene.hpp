// Warnings about a new scene: what is allowed but hardly meant.
#pragma once
// SPDX-License-Identifier: BSD-3-Clause

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <span>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include <arenite/boundary/constraints.hpp>
#include <arenite/core/cold.hpp>
#include <arenite/parallel/communicator.hpp>
#include <arenite/part/parts.hpp>
#include <arenite/part/roles.hpp>
#include <arenite/particles/body.hpp>

namespace arenite::inline ARENITE_INSTRUCTION_SET::shared_detail {

/// A body as the warnings read it.
template <class T, int D>
struct BodySummary {
  const AnyRegion* region;
  const VectorColumns<T, D>* position;
  const std::vector<Index>* cell;
  std::vector<char>
      cells{};  // [cells of a simplex mesh] which belong to a region that is no test of positions
  double initial_volume, region_volume, density;
};

template <class L, class T, int D, ExtraColumns E>
BodySummary<T, D> summary_of(const Body<L, T, D, E>& body, const AnyRegion& region) {
  return {&region,
          &body.points.position,
          &body.points.cell,
          {},
          body.initial_volume,
          body.region_volume,
          body.law.density()};
}

/// The box around a mesh.
struct MeshBox {
  std::array<double, 3> lower, upper;  // m
  double least;                        // edge of a cell, m
};

/// Data for the warnings about a new scene; over a portion of a mesh those of the portion.
struct NewScene {
  std::size_t dimension;
  MeshBox mesh;
  std::string gravity;                    // m/s2
  bool falls;                             // it acts, and nothing gives support
  std::string (*name)(std::size_t body);  // in messages
  std::vector<double> lower{}, upper{};   // [bodies x 3] of their regions, m
  std::vector<double> points{}, initial_volume{}, region_volume{}, density{};  // [bodies] -, m3, kg/m3
  std::vector<double> within{};  // [bodies x bodies] points of one in the region of another
};
template <class M>
MeshBox box_around(const M& mesh) {
  constexpr std::size_t D = M::dimension;
  MeshBox box{};
  const auto at = [](const auto& x, std::size_t k) { return static_cast<double>(x[static_cast<int>(k)]); };
  if constexpr (is_simplex_mesh<M>) {
    box.lower = box.upper = in_space(mesh.origin(0));
    for (Index c = 0; c < mesh.cell_count(); ++c)
      for (const Index i : mesh.nodes(c))
        for (std::size_t k = 0; k < D; ++k) {
          box.lower[k] = std::min(box.lower[k], at(mesh.position(i), k));
          box.upper[k] = std::max(box.upper[k], at(mesh.position(i), k));
        }
  } else {
    for (std::size_t k = 0; k < D; ++k) {
      box.lower[k] = at(mesh.lower(), k);
      box.upper[k] = static_cast<double>(mesh.upper(static_cast<int>(k)));
    }
  }
  box.least = std::numeric_limits<double>::infinity();
  for (Index c = 0; c < mesh.cell_count(); ++c) {
    const auto size = static_cast<double>(mesh.size(c));
    if (size < box.least) box.least = size;
  }
  return box;
}

/// Warns
/// - if a region with bounds (members `lower` and `upper`, m) reaches beyond the box around the mesh by more
///   than a hundredth of a cell: no points are made there. An infinite bound means all that there is. Other
///   regions have no bounds to compare;
/// - of bodies that overlap: one has points in the region of the other;
/// - of points whose total volume is not that of the region in the mesh;
/// - of a body with fewer points than span a volume: it cannot strain as a body does.
/// - if gravity acts and nothing gives support: no constraint blocks a component of it, and no part supports
///   matter except those that fall themselves.
void warn_of(const NewScene& scene);

/// Counts what bodies have.
template <class T, int D>
void count_bodies(std::span<const BodySummary<T, D>> bodies, NewScene& to);

/// Warns of points whose total volume, `filled`, is not that of the region in the mesh.
void warn_volume(const std::string& name, std::size_t points, double density, double filled, double region);

/// Whether a constraint blocks a component of gravity.
template <class T, int D>
bool holds_gravity(const std::vector<Constraint<T, D>>& constraints, const Vec<T, D>& gravity);

/// Whether gravity acts and nothing gives support.
template <class Scene>
bool all_falls(const Scene& scene) {
  const auto g = scene.acceleration();
  bool held = holds_gravity<typename Scene::T, Scene::D>(scene.constraints, g);
  scene.for_each_part([&](const auto& part) {
    using P = std::remove_cvref_t<decltype(part)>;
    if constexpr (holds_against<P, Scene>)
      held = held || part.holds_against(g);
    else
      held = held || adds_force<P, Scene> || (applies_impulses<P, Scene> && contact_order<P> > 0);
  });
  return !held;
}

/// Reads a new scene and the recipes of its bodies.
template <class Scene, class Recipe>
NewScene new_scene(const Scene& scene, const Recipe& recipe) {
  auto bodies = by_body<BodySummary<typename Scene::T, Scene::D>, Scene::body_count>(recipe.size());
  std::size_t next = 0;
  recipe.for_each([&](const auto& fill) { bodies[next++].region = &fill.region; });
  next = 0;
  scene.for_each_body([&](const auto& body, const auto&) {
    bodies[next] = summary_of(body, *bodies[next].region);
    ++next;
  });
  if constexpr (is_simplex_mesh<typename Scene::Mesh>)
    for (auto& body : bodies)
      if (!body.region->test && bodies.size() > 1) {
        body.cells.assign(scene.mesh.cell_count(), 0);
        const auto numbers = region_numbers(scene.mesh, *body.region);
        for (Index c = 0; c < scene.mesh.cell_count(); ++c)
          if (scene.mesh.is_in(c, numbers)) body.cells[c] = 1;
      }
  NewScene found{Scene::D, box_around(scene.mesh), vector_text(scene.acceleration()), all_falls(scene),
                 &Scene::body_name};
  count_bodies<typename Scene::T, Scene::D>(bodies, found);
  return found;
}

/// All warnings about a new scene; scenes over the portions of one mesh ask at once.
template <class Scene>
void warn_about_new_scene(const Scene& scene, NewScene found) {
  scene.for_each_part([&](const auto& part) {
    if constexpr (requires { part.look_at_new(scene); }) part.look_at_new(scene);
  });
  if constexpr (Scene::is_portion) {
    const auto& comm = scene.communicator();
    sum_over(comm, found.points, found.initial_volume, found.region_volume, found.within);
    found.mesh.lower = in_space(scene.portion().lower);
    found.mesh.upper = in_space(scene.portion().upper);
    found.mesh.least = comm.least(found.mesh.least);
    found.falls = comm.least(found.falls ? 1 : 0) == 1;
  }
  if (is_reporter(scene)) warn_of(found);
}

}  // namespace arenite::inline ARENITE_INSTRUCTION_SET::shared_detail

#if ARENITE_HAS_COLD

#include <cmath>

#include <arenite/core/warning.hpp>

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

#endif  // ARENITE_HAS_COLD
