// Force of contact on a body, rigid or not.
#pragma once
// SPDX-License-Identifier: BSD-3-Clause

#include <cstddef>

#include <arenite/scene/scene.hpp>

namespace arenite::inline ARENITE_INSTRUCTION_SET {

/// Mean force [D] that contact put on body `k` in the last step, N: the sum of what each part that exchanges
/// impulses says it gave: its member `contact_impulse(field)`, N s, if it has one. Zero before the first step.
template <class Scene>
typename Scene::V contact_force(const Scene& scene, std::size_t k) {
  static_assert(Scene::Needs::own_fields || Scene::body_count == 1,
                "contact_force: the bodies move in one velocity field, which tells no force on one of them; "
                "give the scene a contact: Coulomb{..}");
  require(k < scene.number_of_bodies(), "contact_force: body", k, "must be less than number_of_bodies()");
  typename Scene::V sum = Scene::V::Zero();
  if (!(scene.time_step > 0)) return sum;
  scene.for_each_part([&](const auto& part) {
    if constexpr (requires { part.contact_impulse(k); }) sum += part.contact_impulse(Scene::field_of(k));
  });
  sum_over(scene.communicator(), sum);
  return sum / static_cast<typename Scene::T>(scene.time_step);
}

/// On a body or rigid body by name: `contact_force<"cone">(scene)`.
template <Name which, class Scene>
typename Scene::V contact_force(const Scene& scene) {
  if constexpr (Scene::template has_rigid<which>)
    return scene.template rigid<which>().force;
  else
    return contact_force(scene, Scene::template body_number<which>());
}

}  // namespace arenite::inline ARENITE_INSTRUCTION_SET
