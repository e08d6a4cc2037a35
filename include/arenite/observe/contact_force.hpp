// Force of contact on a body, rigid or not.
#pragma once
// SPDX-License-Identifier: BSD-3-Clause

#include <cstddef>

#include <arenite/scene/scene.hpp>

namespace arenite::inline ARENITE_INSTRUCTION_SET {

/// Mean force [D] that contact put on a body or rigid body in the last step, N:
/// `contact_force<"cone">(scene)`. On a body it sums what each part that exchanges impulses says it gave: its
/// member `contact_impulse(field)`, N s, if it has one. Zero before the first step.
template <Name which, class Scene>
typename Scene::V contact_force(const Scene& scene) {
  if constexpr (Scene::template has_rigid<which>) {
    return scene.template rigid<which>().force;
  } else {
    static_assert(
        Scene::Needs::own_fields || Scene::body_count == 1,
        "contact_force: the bodies move in one velocity field, which tells no force on one of them; "
        "give the scene a contact: Coulomb{..}");
    constexpr std::size_t field = Scene::field_of(Scene::template body_number<which>());
    typename Scene::V sum = Scene::V::Zero();
    if (!(scene.time_step > 0)) return sum;
    scene.for_each_part([&](const auto& part) {
      if constexpr (requires { part.contact_impulse(field); }) sum += part.contact_impulse(field);
    });
    return sum / static_cast<typename Scene::T>(scene.time_step);
  }
}

}  // namespace arenite::inline ARENITE_INSTRUCTION_SET
