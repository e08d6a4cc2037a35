// State: all that a scene carries from one step to the next, for whoever saves, compares or sends it.
#pragma once
// SPDX-License-Identifier: BSD-3-Clause

#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <string>
#include <tuple>
#include <type_traits>
#include <utility>
#include <vector>

#include <arenite/core/state_value.hpp>
#include <arenite/part/parts.hpp>
#include <arenite/part/roles.hpp>

namespace arenite::inline ARENITE_INSTRUCTION_SET {

namespace detail {

/// Whether a part of the scene may read what the nodes had in the step before.
template <class S, class... P>
constexpr bool reads_last_nodes(std::type_identity<std::tuple<P...>>) {
  return ((adds_force<P, S> || bounds_step<P, S>) || ...);
}

/// Path of each part: its `state_name`, or "rigids/" and its name or number among them, or its number among
/// all parts; numbered where several have the same.
template <class... P>
std::array<std::string, sizeof...(P)> part_paths(std::type_identity<std::tuple<P...>>) {
  std::size_t number = 0, rigid = 0;
  const auto path = [&]<class Q>(std::type_identity<Q>) {
    const std::size_t place = number++;
    if constexpr (shared_detail::is_rigid<Q>) {
      const std::size_t among = rigid++;
      return Q::name.word().empty() ? joined_text({"rigids/", among})
                                    : joined_text({"rigids/", Q::name.word()});
    } else if constexpr (requires { std::string_view(Q::state_name); }) {
      return std::string(Q::state_name);
    } else {
      return joined_text({"parts/", place});
    }
  };
  const std::array<std::string, sizeof...(P)> wanted{path(std::type_identity<P>{})...};
  auto paths = wanted;
  for (std::size_t k = 0; k < wanted.size(); ++k)
    if (std::ranges::count(wanted, wanted[k]) > 1)
      paths[k] = joined_text({wanted[k], "/", std::count(wanted.begin(), wanted.begin() + k, wanted[k])});
  return paths;
}

template <class Body, class F>
void visit_body(Body& body, const F& f) {
  f("lost", body.lost);
  f("lost_mass", body.lost_mass);
  f("lost_kinetic", body.lost_kinetic);
  f("lost_strain", body.lost_strain);
  f("initial_volume", body.initial_volume);
  f("opened_volume", body.opened_volume);
  body.inserted.visit_state(StateUnder(f, "inserted"));
  body.removed.visit_state(StateUnder(f, "removed"));
  StateUnder points(f, "points");
  body.points.visit_state(points);
  StateUnder cells(f, "cells");
  body.cells.visit_state(cells);
}

template <class Scene, class F>
void visit_scene(Scene& scene, const F& f) {
  f("time", scene.time);
  f("time_step", scene.time_step);
  f("steps", scene.steps);
  f("limited", scene.limited);
  f("limited_momentum", scene.limited_momentum);
  f("wall_impulse", scene.wall_impulse);
  f("driving_work", scene.driving_work);
  auto& tally = scene.contact_tally;
  f("contact_tally/dissipation", tally.dissipation);
  f("contact_tally/nodes", tally.nodes);
  f("contact_tally/limited", tally.limited);
  f("contact_tally/limited_momentum", tally.limited_momentum);
  std::size_t number = 0;
  scene.for_each_body([&](auto& body, auto&) {
    visit_body(body, StateUnder(f, joined_text({"bodies/", Scene::body_name(number++)})));
  });
  if constexpr (reads_last_nodes<Scene>(std::type_identity<typename Scene::Parts>{}))
    for (std::size_t k = 0; k < scene.fields.size(); ++k) {
      StateUnder nodes(f, scene.fields.size() > 1 ? joined_text({"nodes/", Scene::body_name(k)}) : "nodes");
      nodes("mass", std::span(scene.fields[k].mass.data(), scene.fields[k].mass.size()));
      nodes("velocity", scene.fields[k].velocity.numbers());
    }
  const auto paths = part_paths(std::type_identity<typename Scene::Parts>{});
  number = 0;
  scene.for_each_part([&](auto& part) {
    const std::size_t k = number++;
    if constexpr (owns_state<std::remove_reference_t<decltype(part)>, Scene>)
      part.visit_state(StateUnder(f, paths[k]));
  });
}

}  // namespace detail

/// Calls `f(name, value)` for all that a step reads, or a run changes, and that does not follow from the
/// rest. `name` (a `std::string_view`) is unique, and the same in each scene of one recipe: a path such as
/// "bodies/sand/points/stress/xx", with a number only where nothing has a name. `value` is a `state_value`:
/// a number, or numbers side by side; of a scene that is const they are constants.
///
/// To restore a state make the scene of the same recipe, `resize` each `resizable_state_array` and write all
/// values, then call `follow_state`: the run continues with the same bits, on any number of threads. What
/// follows from the state is not in it: the sums and velocities of nodes (but masses and velocities where a
/// part adds forces or bounds the step, for it may read those of the step before), the moved mesh, which
/// unsorted point is in which cell, colours. Observers that carry something have their own `visit_state`
/// (`visit_state_of`). Without types: `state_slots`.
template <class Scene, class F>
void for_each_state(Scene& scene, F&& f) {
  constexpr bool constant = std::is_const_v<Scene>;
  const StateUnder<std::remove_reference_t<F>, constant> top(f, "");
  detail::visit_scene(state_owner(scene), top);
}

/// The list of the state of a scene and of observers, "observers/0", ..
template <class Scene, class... Observers>
std::vector<StateSlot> state_slots(Scene& scene, Observers&... observers) {
  StateSlots list;
  for_each_state(scene, list);
  [[maybe_unused]] std::size_t number = 0;
  (visit_state_of(observers, joined_text({"observers/", number++}), list), ...);
  return std::move(list.slots);
}

namespace detail {

/// Throws `error` where the columns of a body are no points: of unequal length, or nowhere, or of no mass.
template <class Body>
void check_points(Body& body, const std::string& path) {
  StateSlots columns;
  StateUnder points(columns, path);
  body.points.visit_state(points);
  for (const StateSlot& column : columns.slots)
    require(column.count == body.points.size(), column.name, joined_text({column.count, " numbers"}),
            {"must be as many as points have a mass, ", body.points.size()});
  for (std::size_t p = 0; p < body.points.size(); ++p) {
    const auto x = body.points.position[p];
    const auto name_of = [&](const char* name) { return joined_text({path, "/", name, "[", p, "]"}); };
    if (!x.allFinite()) require(false, name_of("position"), vector_text(x), "must be finite (m)");
    if (const auto m = body.points.mass[p]; !(m > 0 && std::isfinite(m)))
      require(false, name_of("mass"), m, "must be positive (kg)");
    if (const auto v = body.points.volume[p]; !std::isfinite(v))
      require(false, name_of("volume"), v, "must be finite (m3)");
  }
}

}  // namespace detail

/// Renews what follows from the state, if it is one of this scene, and throws `error` if it is not.
template <class Scene>
void renew_from_state(Scene& scene) {
  scene.for_each_body([&](auto& body, auto&) {
    body.cells.follow_state(body.points.cell, scene.mesh.cell_count());
    body.cells.reserve(body.points.size());
    body.points.reserve_spare();
  });
  scene.for_each_part([&](auto& part) {
    if constexpr (follows_state<std::remove_reference_t<decltype(part)>, Scene>) part.follow_state(scene);
  });
  scene.balance_threads();
}

/// Renews what follows from the state of a scene, once a visitor has written it. Throws `error` if it is not
/// a state of this scene: columns of unequal length, points without a place or mass, a list of cells that
/// does not fit, or what a part refuses. The scene must not step then.
template <class Scene>
void follow_state(Scene& scene) {
  std::size_t number = 0;
  scene.for_each_body([&](auto& body, auto&) {
    detail::check_points(body, joined_text({"state: bodies/", Scene::body_name(number++), "/points"}));
  });
  renew_from_state(scene);
}

}  // namespace arenite::inline ARENITE_INSTRUCTION_SET
