// Points that move from one portion of a mesh to another. For the `migrate` of a communicator.
#pragma once
// SPDX-License-Identifier: BSD-3-Clause

#include <cstdint>
#include <string>
#include <vector>

#include <arenite/particles/exchange_points.hpp>
#include <arenite/scene/scene.hpp>

namespace arenite::inline ARENITE_INSTRUCTION_SET {

/// Takes the points out of a scene that are in ghost cells, after `find_cells`: calls `send(body, to, point,
/// cell)` with the number of their body (a `std::integral_constant`), the portion that owns the cell, the
/// point as a value, and the cell's number in the whole mesh.
template <class Scene, class Send>
void take_foreign(Scene& scene, Send&& send) {
  const auto& portion = scene.portion();
  [&]<std::size_t... I>(std::index_sequence<I...>) {
    const auto of_body = [&](auto number) {
      auto& body = std::get<number>(scene.bodies);
      auto& points = body.points;
      double mass = 0;
      for (const Index p : body.cells.all_unsorted()) {  // the moved points are among these
        const Index c = points.cell[p];
        if (c == none || portion.owns_cell(c)) continue;
        mass += static_cast<double>(points.mass[p]);
        send(number, portion.owner[c], points[p], portion.whole_cell[c]);
        points.cell[p] = none;
        body.moved = body.dropped = true;
      }
      body.initial_volume -= mass / body.law.density();
    };
    (of_body(std::integral_constant<std::size_t, I>{}), ...);
  }
  (std::make_index_sequence<Scene::body_count>{});
}

/// Puts points that come from other portions into body number `Body`; `cell`: their cells' numbers in the
/// whole mesh. They stand behind all others in the order given.
template <std::size_t Body, class Scene, class Point>
void take_in(Scene& scene, const std::vector<Point>& points, const std::vector<std::uint64_t>& cell) {
  auto& body = std::get<Body>(scene.bodies);
  std::vector<Index> here;
  for (const auto c : cell) here.push_back(scene.portion().cell_here(c));
  const auto totals = append_points(body, points, here, [](const auto& point) { return point.id; });
  body.initial_volume += totals.mass / body.law.density();
}

/// Throws `run_error` for a point that jumped over the ghost cells: it is not counted as lost, so nothing else would report it.
template <class Scene, class Body>
void check_outside(const Scene& scene, const Body& body) {
  if constexpr (Scene::is_portion)
    for (const Index p : body.outside)
      if (scene.portion().is_beyond_ghosts(scene.mesh, body.points.position[p]))
        throw run_error(
            joined_text({"t = ", scene.time, " s: point ", p, " at ", vector_text(body.points.position[p]),
                         " m left portion ", scene.portion().number,
                         " of the mesh beyond its ghost cells: the step is too long"}));
}

}  // namespace arenite::inline ARENITE_INSTRUCTION_SET
