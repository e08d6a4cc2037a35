// State: all that a scene carries from one step to the next, for whoever saves, compares or sends it.
#pragma once

#include <arenite/scene/scene.hpp>

namespace arenite::inline ARENITE_INSTRUCTION_SET {

/// Calls `f(value)` for each number, vector and column of a scene's state: clock and sums, the bodies'
/// points, and what parts own (`owns_state`). Lists of which cell holds which point follow from the points,
/// up to their order.
template <class Scene, class F>
void for_each_state(Scene& scene, F&& f) {
  f(scene.time);
  f(scene.time_step);
  f(scene.steps);
  f(scene.limited);
  f(scene.limited_momentum);
  f(scene.wall_impulse);
  f(scene.driving_work);
  scene.for_each_body([&](auto& body, auto&) {
    f(body.lost);
    f(body.lost_mass);
    f(body.initial_volume);
    f(body.opened_volume);
    body.points.for_each_column(f);
  });
  scene.for_each_part([&](auto& part) {
    if constexpr (owns_state<std::remove_reference_t<decltype(part)>, Scene>) part.visit_state(f);
  });
}

}  // namespace arenite::inline ARENITE_INSTRUCTION_SET
