// Relocation of a scene: each point in its cell, and with the scene that owns it.
#pragma once
// SPDX-License-Identifier: BSD-3-Clause

#include <arenite/scene/migrate.hpp>

namespace arenite::inline ARENITE_INSTRUCTION_SET {

/// Throws `run_error` if the last point has left the mesh; warns when one body of several has lost its last.
/// Points that moved to cells of others go there before the lists of cells are renewed.
template <class Scene>
void relocate(Scene& scene) {
  constexpr int width = Scene::NumericsType::template width<typename Scene::T>;
  scene.for_each_body([&](auto& body, auto&) { find_cells<width>(body, scene.mesh, scene.blocks); });
  auto had_points = by_body<bool, Scene::body_count>(scene.number_of_bodies());
  std::size_t number = 0;
  scene.for_each_body([&](auto& body, auto&) { had_points[number++] = body.points.size() > 0; });
  migrate(scene);
  bool regrouped = false;
  scene.for_each_body([&](auto& body, auto&) {
    check_outside(scene, body);
    lose_outside(body);
    regrouped = regroup(body, scene.blocks) || regrouped;
  });
  if (regrouped) scene.balance_threads();
  if constexpr (!Scene::is_portion) {
    if (scene.lost_points() > 0 && scene.point_count() == 0)
      throw run_error(joined_text(
          {"t = ", scene.time, " s: all ", scene.lost_points(), " points of the scene have left the mesh"}));
    number = 0;
    scene.for_each_body([&](auto& body, auto&) {
      if (had_points[number] && body.points.size() == 0)
        warn(joined_text({"t = ", scene.time, " s: all points of body ", Scene::body_name(number),
                          " have left the mesh; the run goes on without it"}));
      ++number;
    });
  }
}

}  // namespace arenite::inline ARENITE_INSTRUCTION_SET
