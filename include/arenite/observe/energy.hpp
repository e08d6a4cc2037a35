// Energy of a scene, balanced: what was put in, where it is, and what the numerics lost.
#pragma once

#include <arenite/scene/scene.hpp>

namespace arenite::inline ARENITE_INSTRUCTION_SET {

/// J. `residual` = kinetic + strain + plastic + contact - (initial + external): what transfers, walls and
/// time steps took (negative) or added. Lost points take their energy with them.
struct Energies {
  double kinetic = 0;   ///< bodies and rigid bodies
  double strain = 0;    ///< recoverable
  double plastic = 0;   ///< work of the stresses that is not recoverable
  double contact = 0;   ///< dissipated by friction and by inelastic contact
  double external = 0;  ///< work of gravity, loads and prescribed motions
  double residual = 0;
};

/// Needs a scene with `TrackEnergy`.
template <class Scene>
Energies energies(const Scene& scene) {
  static_assert(Scene::tracks_energy, "energies: name TrackEnergy{} among the scene's parts");
  const Ledger& ledger = scene.ledger;
  Energies e;
  scene.for_each_body([&](const auto& body, const auto&) {
    e.kinetic += kinetic_energy(body);
    e.strain += strain_energy(body);
  });
  e.external = ledger.gravity_work;
  scene.for_each_rigid([&](const auto& body) {
    e.kinetic += body.kinetic_energy();
    e.external += body.driving_work;
  });
  e.plastic = ledger.stress_work - (e.strain - ledger.initial_strain);
  e.contact = ledger.contact_dissipation;
  e.residual = e.kinetic + e.strain + e.plastic + e.contact - ledger.initial_kinetic - ledger.initial_strain -
               e.external;
  return e;
}

}  // namespace arenite::inline ARENITE_INSTRUCTION_SET
