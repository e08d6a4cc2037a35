// One step of the material point method, explicit in time. Read `step` and you have read the method.
#pragma once
// SPDX-License-Identifier: BSD-3-Clause

#include <type_traits>

#include <arenite/scene/finish.hpp>
#include <arenite/scene/stable_step.hpp>
#include <arenite/scene/stages.hpp>

namespace arenite::inline ARENITE_INSTRUCTION_SET {

/// Takes a scene through one step of length dt, s. Throws `error` unless dt is positive and finite, and
/// `run_error` if the state turns into NaN or the mesh inside out, naming time, place and cause. Warns, once
/// a scene, of a dt above the stable step. Scenes over the portions of one mesh (`on_portion`) take the same
/// step at the same time.
template <class Scene>
void step(Scene& scene, double dt) {
  scene.step_check(
      dt, scene.time, scene.steps, [&] { return scene.communicator().least(stable_step(scene)); },
      is_reporter(scene));
  relocate(scene);                 // find the cell of each point
  p2g(scene, dt);                  // P2G: mass, momentum, internal force
  update_stress_first(scene, dt);  // USF: strains and stresses before the forces
  add_forces(scene, dt);           // springs, tractions, ..
  centre_stress(scene, dt);        // elastic bodies, MUSL on simplices: forces of the middle of the step
  update_grid(scene, dt);          // nodal momentum balance
  constrain(scene, dt);            // fixities, rollers, symmetry planes
  contact_impulses(scene, dt);     // body against body, rigid body against bodies: impulses that cancel
  smooth_light_nodes(scene, dt);   // nodes at a body's edge that have force and hardly any mass
  correct_nodes(scene, dt);        // XPIC, FMPM: nodal velocities, corrected for the lumped mass
  map_back(scene, dt);             // MUSL: nodal velocities for the strains, mapped back from the points
  g2p(scene, dt);                  // G2P: velocities, strains, positions; stresses by the law of each body
  follow(scene, dt);               // what moves with the matter: the mesh, springs, ..
  finish(scene, dt);               // time, and the check that nothing has become NaN
}

/// Of a scene that the compiler has refused.
template <class... Parts>
void step(RefusedScene<Parts...>&, double) {}

/// Refused by the compiler: a scene that cannot change.
template <class Scene>
void step(const Scene&, double) {
  static_assert(!std::is_object_v<Scene>,
                "step: the scene is stepped in place: it must be a variable that is not const");
}

/// In `namespace arenite`: the step of scenes of this type is compiled in this unit (`ARENITE_STEP(, Type);`), or in another one
/// (`ARENITE_STEP(extern, Type);`), which may take more of the optimiser.
#define ARENITE_STEP(EXTERN, ...)                  \
  EXTERN template void step(__VA_ARGS__&, double); \
  EXTERN template double stable_step(const __VA_ARGS__&)

}  // namespace arenite::inline ARENITE_INSTRUCTION_SET
