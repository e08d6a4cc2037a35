// Energy of a scene, balanced: what was put in, where it is, and what the numerics lost.
#pragma once

#include <functional>
#include <string_view>

#include <arenite/scene/scene.hpp>

namespace arenite::inline ARENITE_INSTRUCTION_SET {

/// A part that keeps the energy energy balance of a scene: works of stresses and accelerations are summed at
/// each step. Without it they are not computed. Energies in J.
struct TrackEnergy {
  using OnlyOne = TrackEnergy;
  static constexpr std::string_view state_name = "energy";
  double initial_kinetic = 0;  ///< of bodies and parts
  double initial_strain = 0;   ///< recoverable, from initial stresses
  double initial_stored = 0;   ///< recoverable, in parts
  double stress_work = 0;      ///< work of the stresses: stored or used up plastically
  double gravity_work = 0;     ///< of the accelerations on the bodies

  template <class Scene>
  void connect(const Scene& scene) {
    scene.for_each_body([&](const auto& body, const auto&) {
      initial_kinetic += kinetic_energy(body);
      initial_strain += strain_energy(body);
    });
    const PartEnergy parts = energy_of_parts(scene);
    initial_kinetic += parts.kinetic;
    initial_stored += parts.stored;
  }
  /// Energy that there was, J.
  double initial() const { return initial_kinetic + initial_strain + initial_stored; }
  void take_stress_work(double work) { stress_work += work; }
  template <class Scene>
  void follow_motion(const Scene& scene, double dt) {
    const auto acceleration = scene.acceleration();
    for (const auto& field : scene.fields)
      gravity_work += parallel_reduce(
          field.size(), 0.0,
          [&](std::size_t begin, std::size_t end) {
            double work = 0;
            for (std::size_t i = begin; i < end; ++i)
              work += dt * static_cast<double>(field.mass[i] * acceleration.dot(field.velocity[i]));
            return work;
          },
          std::plus<>{});
  }
  template <class F>
  void visit_state(F&& f) {
    f("initial_kinetic", initial_kinetic);
    f("initial_strain", initial_strain);
    f("initial_stored", initial_stored);
    f("stress_work", stress_work);
    f("gravity_work", gravity_work);
  }
};

/// What the parts of a scene count.
template <class Scene>
PartEnergy energy_of_parts(const Scene& scene) {
  PartEnergy sum{.external = scene.driving_work};
  scene.for_each_part([&](const auto& part) {
    if constexpr (counts_energy<std::remove_cvref_t<decltype(part)>, Scene>) sum += part.count_energy();
  });
  return sum;
}

/// Whether a scene keeps the balance.
template <class Scene>
inline constexpr bool tracks_energy = Scene::template has_part<TrackEnergy>;

/// J. `residual` = kinetic + strain + stored + plastic + contact - (initial + external + inserted): what
/// transfers, walls and time steps took (negative) or added. Lost points take their energy with them.
struct Energies {
  double kinetic = 0;   ///< bodies and parts
  double strain = 0;    ///< recoverable
  double stored = 0;    ///< recoverable, in parts
  double plastic = 0;   ///< work of the stresses that is not recoverable
  double contact = 0;   ///< dissipated by friction, by inelastic contact and by other parts
  double external = 0;  ///< work of gravity, loads and prescribed motions
  double inserted = 0;  ///< of points inserted, less that of points removed
  double residual = 0;
};

/// Needs a scene with `TrackEnergy`.
template <class Scene>
Energies energies(const Scene& scene) {
  static_assert(tracks_energy<Scene>, "energies: name TrackEnergy{} among the scene's parts");
  const auto& balance = scene.template part<TrackEnergy>();
  const PartEnergy parts = energy_of_parts(scene);
  Energies e;
  double inserted_strain = 0;
  scene.for_each_body([&](const auto& body, const auto&) {
    inserted_strain += body.inserted.strain_energy - body.removed.strain_energy;
    e.inserted += body.inserted.kinetic_energy - body.removed.kinetic_energy;
    e.kinetic += kinetic_energy(body);
    e.strain += strain_energy(body);
  });
  e.inserted += inserted_strain;
  e.kinetic += parts.kinetic;
  e.stored = parts.stored;
  e.external = balance.gravity_work + parts.external;
  e.plastic = balance.stress_work - (e.strain - balance.initial_strain - inserted_strain);
  e.contact = parts.dissipated;
  e.residual = e.kinetic + e.strain + e.stored + e.plastic + e.contact - balance.initial_kinetic -
               balance.initial_strain - balance.initial_stored - e.external - e.inserted;
  return e;
}

}  // namespace arenite::inline ARENITE_INSTRUCTION_SET
