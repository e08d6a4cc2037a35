// Energy of a scene, balanced: what was put in, where it is, and what the numerics lost.
#pragma once

#include <functional>
#include <string_view>

#include <arenite/core/alone.hpp>
#include <arenite/scene/scene.hpp>

namespace arenite::inline ARENITE_INSTRUCTION_SET {

/// A part that keeps the energy balance of a scene: works of stresses and accelerations are summed at
/// each step. Without it they are not computed. Energies in J.
struct TrackEnergy {
  using OnlyOne = TrackEnergy;
  static constexpr std::string_view state_name = "energy";
  static constexpr bool reads_start_state = false;
  double initial_kinetic = 0;  ///< of bodies and parts
  double initial_strain = 0;   ///< recoverable, from initial stresses
  double initial_stored = 0;   ///< recoverable, in parts
  double initial_shared = 0;   ///< of both, in parts that several scenes share
  double stress_work = 0;      ///< work of the stresses: stored or used up plastically
  double gravity_work = 0;     ///< of the accelerations on the bodies

  template <class Scene>
  void connect(const Scene& scene) {
    scene.for_each_body([&](const auto& body, const auto&) {
      initial_kinetic += kinetic_energy(body);
      initial_strain += strain_energy(body);
    });
    const PartEnergy parts = energy_of_parts(scene), own = energy_of_parts(scene, false);
    initial_kinetic += parts.kinetic;
    initial_stored += parts.stored;
    initial_shared = parts.kinetic + parts.stored - own.kinetic - own.stored;
  }
  /// Energy that there was, J.
  double initial() const { return initial_kinetic + initial_strain + initial_stored; }
  void take_stress_work(double work) { stress_work += work; }
  template <class Scene>
  void follow_motion(const Scene& scene, double dt) {
    const auto acceleration = scene.acceleration();
    const auto owns = scene.node_owner();
    for (const auto& field : scene.fields)
      gravity_work += parallel_reduce(
          field.size(), 0.0,
          [&](std::size_t begin, std::size_t end) {
            double work = 0;
            for (std::size_t i = begin; i < end; ++i)
              if (owns(static_cast<Index>(i)))
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
    f("initial_shared", initial_shared);
    f("stress_work", stress_work);
    f("gravity_work", gravity_work);
  }
};

/// What the parts of a scene count. `shared`: those too whose numbers several scenes share.
template <class Scene>
PartEnergy energy_of_parts(const Scene& scene, bool shared = true) {
  PartEnergy sum{.external = scene.driving_work};
  scene.for_each_part([&](const auto& part) {
    using P = std::remove_cvref_t<decltype(part)>;
    if constexpr (counts_energy<P, Scene>)
      if (shared || !requires { P::is_shared; }) sum += part.count_energy();
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

/// Needs a scene with `TrackEnergy`. Of a scene over a portion of a mesh: of all portions, through `others`.
template <class Scene, class Others = const Alone>
Energies energies(const Scene& scene, [[maybe_unused]] Others& others = no_others) {
  static_assert(tracks_energy<Scene>, "energies: name TrackEnergy{} among the scene's parts");
  const auto& balance = scene.template part<TrackEnergy>();
  bool shared = true;
  if constexpr (!Others::alone) shared = others.first();
  const PartEnergy parts = energy_of_parts(scene, shared);
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
  if (!shared) e.residual += balance.initial_shared;
  sum_over(others, e.kinetic, e.strain, e.stored, e.plastic, e.contact, e.external, e.inserted, e.residual);
  return e;
}

}  // namespace arenite::inline ARENITE_INSTRUCTION_SET
