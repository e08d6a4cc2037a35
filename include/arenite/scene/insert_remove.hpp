// Points inserted into a scene and removed from it, between two steps.
#pragma once
// SPDX-License-Identifier: BSD-3-Clause

#include <span>
#include <string>
#include <utility>
#include <vector>

#include <arenite/parallel/communicator.hpp>
#include <arenite/particles/exchange_points.hpp>
#include <arenite/particles/point_ids.hpp>
#include <arenite/scene/cell_of_all.hpp>
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

/// `insert_points` for a given body of the scene.
template <class Scene, class B>
auto insert_into(Scene& scene, B& body, const std::vector<typename B::Point>& points) {
  const auto totals =
      add_points(body, scene.mesh, points, [&](const auto& p) { return detail::id_for(scene, p); });
  scene.at_rest.clear();
  body.inserted += totals;
  body.initial_volume += totals.mass / body.law.density();
  if (regroup(body, scene.blocks)) scene.balance_threads();
  return totals;
}

/// `insert_into` of points that the scenes over all portions of a mesh are given: each takes those of its cells.
template <class Scene, class B>
auto insert_given(Scene& scene, B& body, const std::vector<typename B::Point>& points) {
  if constexpr (!Scene::is_portion) {
    return insert_into(scene, body, points);
  } else {
    std::vector<Index> cell;
    std::vector<double> takers;  // of each point
    for (std::size_t k = 0; k < points.size(); ++k) {
      check_point(body, points[k], k);
      cell.push_back(scene.mesh.search(points[k].position));
      takers.push_back(cell[k] != none && scene.portion().owns_cell(cell[k]));
    }
    scene.communicator().sum(std::span<double>(takers));
    std::vector<typename B::Point> here;
    for (std::size_t k = 0; k < points.size(); ++k) {
      if (takers[k] != 1)  // on a cut, or outside
        require(find_owner_cell(scene, cell[k]), {"point ", k, " to be added: position"},
                vector_text(points[k].position), "must lie in the mesh");
      if (cell[k] != none && scene.portion().owns_cell(cell[k])) here.push_back(points[k]);
    }
    return insert_into(scene, body, here);
  }
}

/// Inserts the points of a `fill`, as a new scene would have them; `name`: of the body, for a warning.
template <class Scene, class B, class F>
auto insert_fill(Scene& scene, B& body, const F& fill, const std::string& name) {
  Ground ground{.time = scene.time};
  if (fill.options.stress && fill.options.stress->geostatic())
    ground.gravity = shared_detail::gravity_of_ground(scene, scene.time);
  const auto made = make_body<typename Scene::Kinematics, Scene::extra_columns>(scene.mesh, fill,
                                                                                scene.cell_owner(), ground);
  auto count = static_cast<double>(made.points.size());
  double filled = made.initial_volume, region = made.region_volume;
  sum_over(scene.communicator(), count, filled, region);
  if (is_reporter(scene))
    shared_detail::warn_volume(name, static_cast<std::size_t>(count), made.law.density(), filled, region);
  std::vector<typename B::Point> points;
  points.reserve(made.points.size());
  for (std::size_t p = 0; p < made.points.size(); ++p) points.push_back(made.points[p]);
  return insert_into(scene, body, points);
}

/// `remove_points` for a given body, by number: point p is removed if `leaves(p)` is true.
template <class Scene, class B, class Leaves>
auto remove_from(Scene& scene, B& body, const Leaves& leaves) {
  const auto totals = take_out(body, scene.mesh.cell_count(), leaves, [](const auto&) {});
  scene.at_rest.clear();
  body.removed += totals;
  body.initial_volume -= totals.mass / body.law.density();
  if (regroup(body, scene.blocks)) scene.balance_threads();
  return totals;
}

/// Adds points to a body, by name or number: `insert_points<"sand">(scene, {{.position = {0.5, 1.2}, .volume
/// = 1e-4}})`. A point's mass is that of its volume unless given. Throws `error`, with the scene as it was,
/// for a point outside of the mesh or one that is not finite. Energy balances count what the points bring as
/// put in. Returns what they brought. The scenes over all portions of a mesh are given the same points, at once,
/// and each returns what its own points brought.
template <Name which = "", class Scene>
auto insert_points(Scene& scene,
                   const std::vector<typename std::remove_cvref_t<
                       decltype(std::declval<Scene&>().template body<which>())>::Point>& points) {
  return insert_given(scene, scene.template body<which>(), points);
}

/// Removes the points of a body, by name or number, that lie in a region, or where `leaves(point)` is true,
/// with a `MaterialPoint`: `remove_points<"sand">(scene, Box{{0, 1}, {2, 1.5}})` or `.. [](const auto& point)
/// { return point.stress[1] > 0; })`. Energy balances count what they take with them as taken out. Returns
/// that.
template <Name which = "", class Scene, class Leaves>
auto remove_points(Scene& scene, const Leaves& leaves) {
  auto& body = scene.template body<which>();
  return remove_from(scene, body, [&](Index p) -> bool {
    if constexpr (region_type<Leaves, Scene::D>)
      return leaves.contains(Vec<double, Scene::D>(body.points.position[p].template cast<double>()));
    else
      return leaves(std::as_const(body.points)[p]);
  });
}

/// Fills a region with points of a body of a running scene, as `fill` does when a scene is made:
/// `insert_points<"fill">(scene, Box{{0, 1}, {2, 1.5}}, {.per_cell = 4})`. The region should be empty:
/// points that are there stay. `options.velocity`, `.stress` and `.history` are those of the new points.
/// Throws `error`, with the scene as it was, where `fill` would. Returns what they brought.
template <Name which = "", class Scene, class Region>
requires region_type<Region, Scene::D>
auto insert_points(Scene& scene, Region region, const FillOptions& options = {}) {
  auto& body = scene.template body<which>();
  return insert_fill(scene, body,
                     fill(std::move(region), body.law, options).template type_erased<typename Scene::Mesh>(),
                     Scene::body_name(Scene::template body_number<which>()));
}

}  // namespace arenite::inline ARENITE_INSTRUCTION_SET
