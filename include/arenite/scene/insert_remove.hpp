// Points inserted into a scene and removed from it, between two steps.
#pragma once

#include <utility>
#include <vector>

#include <arenite/particles/exchange_points.hpp>
#include <arenite/particles/point_ids.hpp>
#include <arenite/scene/scene.hpp>

namespace arenite::inline ARENITE_INSTRUCTION_SET {

namespace detail {

/// Id of a point that joins a scene: its own, or the next one.
template <class Scene, class Point>
std::uint64_t id_for([[maybe_unused]] Scene& scene, const Point& point) {
  if constexpr (Scene::template has_part<PointIds>)
    if (point.id == no_id) return scene.template part<PointIds>().first++;
  return point.id;
}

}  // namespace detail

/// Adds points to a body, by name or number: `insert_points<"sand">(scene, {{.position = {0.5, 1.2}, .volume
/// = 1e-4}})`. A point's mass is that of its volume unless given. Throws `error`, with the scene as it was,
/// for a point outside of the mesh or one that is not finite. Energy balances count what the points bring as
/// put in. Returns what they brought.
template <Name which = "", class Scene>
auto insert_points(Scene& scene,
                   const std::vector<typename std::remove_cvref_t<
                       decltype(std::declval<Scene&>().template body<which>())>::Point>& points) {
  auto& body = scene.template body<which>();
  const auto totals =
      add_points(body, scene.mesh, points, [&](const auto& p) { return detail::id_for(scene, p); });
  body.inserted += totals;
  body.initial_volume += totals.mass / body.law.density();
  if (regroup(body, scene.blocks)) scene.balance_threads();
  return totals;
}

/// Removes the points of a body, by name or number, for which `leaves(point)` holds, with a `MaterialPoint`:
/// `remove_points<"sand">(scene, [](const auto& point) { return point.position[1] > 2; })`. Energy balances
/// count what they take with them as taken out. Returns that.
template <Name which = "", class Scene, class Leaves>
auto remove_points(Scene& scene, Leaves&& leaves) {
  auto& body = scene.template body<which>();
  const auto totals = take_out(
      body, scene.mesh.cell_count(), [&](Index p) -> bool { return leaves(std::as_const(body.points)[p]); },
      [](const auto&) {});
  body.removed += totals;
  body.initial_volume -= totals.mass / body.law.density();
  if (regroup(body, scene.blocks)) scene.balance_threads();
  return totals;
}

}  // namespace arenite::inline ARENITE_INSTRUCTION_SET
