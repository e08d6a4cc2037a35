// One step of the material point method, explicit in time. Read `step` and you have read the method.
#pragma once

#include <arenite/scene/stages.hpp>

namespace arenite {

/// Takes a scene through one step of length dt, s. Throws `run_error` if the state turns into NaN or the mesh
/// inside out, naming time, place and cause.
template <class Scene>
void step(Scene& scene, double dt) {
  relocate(scene);     // find the cell of each point
  scatter(scene);      // P2G: mass, momentum, internal force
  advance(scene, dt);  // nodal momentum balance
  constrain(scene);    // fixities, rollers, symmetry planes
  collide(scene, dt);  // body against body, rigid body against bodies: impulses that cancel
  gather(scene);       // G2P: velocities (and, for MUSL, back to the nodes for the strains)
  deform(scene, dt);   // strains, stresses by the law of each body, positions
  move(scene, dt);     // the mesh, if it moves
  finish(scene, dt);   // time, and the check that nothing has become NaN
}

}  // namespace arenite
