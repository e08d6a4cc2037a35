// Points that move from one portion of a mesh to another.
#pragma once
// SPDX-License-Identifier: BSD-3-Clause

#include <cstdint>
#include <string>
#include <string_view>
#include <type_traits>

#include <arenite/core/bytes.hpp>
#include <arenite/parallel/communicator.hpp>
#include <arenite/scene/scene.hpp>

namespace arenite::inline ARENITE_INSTRUCTION_SET {

namespace detail {

/// Calls `f(body, number)` for each body of a scene.
template <class Scene, class F>
void for_each_numbered_body(Scene& scene, F&& f) {
  std::uint64_t number = 0;
  scene.for_each_body([&](auto& body, auto&) { f(body, number++); });
}

/// Takes the points out of a scene that are in ghost cells, into a message to the owner of the cell: number of
/// the body, number of the cell in the whole mesh, and the columns.
template <class Scene>
auto pack_leavers(Scene& scene) {
  const auto& portion = scene.portion();
  typename std::remove_cvref_t<decltype(scene.communicator())>::Messages messages;
  for_each_numbered_body(scene, [&](auto& body, std::uint64_t number) {
    auto& points = body.points;
    double mass = 0;
    for (const Index p : body.cells.all_unsorted()) {  // the moved points are among these
      const Index c = points.cell[p];
      if (c == none || portion.owns_cell(c)) continue;
      mass += static_cast<double>(points.mass[p]);
      auto& to = messages[portion.owner[c]];
      append_bytes(to, number);
      append_bytes(to, portion.whole_cell[c]);
      points.for_each_column([&](const auto& column) { append_bytes(to, column[p]); });
      points.cell[p] = none;
      body.moved = body.dropped = true;
    }
    body.initial_volume -= mass / body.law.density();
  });
  return messages;
}

/// Appends the points of a message to those of the bodies, in its order.
template <class Scene>
void unpack_points(Scene& scene, std::string_view message) {
  while (!message.empty()) {
    const auto to = read_bytes<std::uint64_t>(message);
    for_each_numbered_body(scene, [&](auto& body, std::uint64_t number) {
      if (number != to) return;
      auto& points = body.points;
      const Index cell = scene.portion().cell_here(read_bytes<std::uint64_t>(message));
      points.for_each_column([&](auto& column) {
        column.push_back(read_bytes<typename std::remove_cvref_t<decltype(column)>::value_type>(message));
      });
      points.cell.back() = cell;
      body.cells.admit_new(static_cast<Index>(points.size() - 1));
      body.initial_volume += static_cast<double>(points.mass.back()) / body.law.density();
      body.moved = true;
    });
  }
}

}  // namespace detail

/// Points of a scene over a portion that are in ghost cells go to the scenes that own them, after `find_cells`.
template <class Scene>
void migrate([[maybe_unused]] Scene& scene) {
  if constexpr (Scene::is_portion) {
    for (const auto& [from, message] : scene.communicator().exchange(detail::pack_leavers(scene)))
      detail::unpack_points(scene, message);
    scene.for_each_body([](auto& body, auto&) {
      body.points.reserve_spare();
      body.cells.reserve(body.points.size());
    });
  }
}

/// Throws `run_error` for a point that jumped over the ghost cells: it is not counted as lost, so nothing else
/// would report it.
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
