// Relocation of a scene: each point in its cell, and with the scene that owns it.
#pragma once
// SPDX-License-Identifier: BSD-3-Clause

#include <numeric>

#include <arenite/core/warning.hpp>
#include <arenite/parallel/communicator.hpp>
#include <arenite/scene/migrate.hpp>

namespace arenite::inline ARENITE_INSTRUCTION_SET {

/// Throws `run_error` if the last point has left the mesh; warns when one body of several has lost its last: of
/// the whole, where the mesh is cut.
/// Points that moved to cells of others go there before the lists of cells are renewed.
template <class Scene>
void relocate(Scene& scene) {
  constexpr int width = Scene::NumericsType::template width<typename Scene::T>;
  scene.for_each_body([&](auto& body, auto&) { find_cells<width>(body, scene.mesh, scene.blocks); });
  auto had = by_body<double, Scene::body_count>(scene.number_of_bodies());  // points
  std::size_t number = 0;
  scene.for_each_body([&](auto& body, auto&) { had[number++] = static_cast<double>(body.points.size()); });
  migrate(scene);
  bool regrouped = false;
  scene.for_each_body([&](auto& body, auto&) {
    check_outside(scene, body);
    lose_outside(body);
    regrouped = regroup(body, scene.blocks) || regrouped;
  });
  if (regrouped) scene.balance_threads();
  auto has = had;
  number = 0;
  scene.for_each_body([&](auto& body, auto&) { has[number++] = static_cast<double>(body.points.size()); });
  auto lost = static_cast<double>(scene.lost_points());
  sum_over(scene.communicator(), had, has, lost);
  if (lost > 0 && std::accumulate(has.begin(), has.end(), 0.0) == 0)
    throw run_error(joined_text({"t = ", scene.time, " s: all ", static_cast<std::size_t>(lost),
                                 " points of the scene have left the mesh"}));
  for (std::size_t b = 0; b < has.size(); ++b)
    if (had[b] > 0 && has[b] == 0 && is_reporter(scene))
      warn(joined_text({"t = ", scene.time, " s: all points of body ", Scene::body_name(b),
                        " have left the mesh; the run goes on without it"}));
}

}  // namespace arenite::inline ARENITE_INSTRUCTION_SET
