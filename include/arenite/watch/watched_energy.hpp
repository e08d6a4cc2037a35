// The energy of a run that a `Watch` follows: energy gained from nothing, and energy lost.
#pragma once
// SPDX-License-Identifier: BSD-3-Clause

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>

#include <arenite/core/cold.hpp>
#include <arenite/observe/energy.hpp>

namespace arenite::inline ARENITE_INSTRUCTION_SET {

/// Edge of a mean cell of the whole mesh, m.
template <class Scene>
double mean_cell(const Scene& scene) {
  const auto owns = scene.cell_owner();
  double volume = 0, cells = 0;
  for (Index c = 0; c < scene.mesh.cell_count(); ++c)
    if (owns(c)) {
      volume += static_cast<double>(scene.mesh.volume(c));
      ++cells;
    }
  sum_over(scene.communicator(), volume, cells);
  return std::pow(volume / cells, 1.0 / Scene::D);
}

/// Follows the energy of one scene from check to check.
class WatchedEnergy {
 public:
  /// Fractions of the energy put in: the gain since the lowest check (without `TrackEnergy`: since the
  /// first); with `TrackEnergy` the loss in the transfer since the first, and the magnitude of the residual
  /// of the balance. Not known if the previous step was not seen.
  struct Found {
    bool known = false;
    double gain = 0, transfer = 0, residual = 0;
  };

  /// After each step, without `TrackEnergy`: adds up the work of a scene's acceleration before that changes.
  template <class Scene>
  void follow(const Scene& scene) {
    if (acceleration_ != acceleration_of(scene)) record_work(scene);
  }

  /// Stores the configurational energy of this step and of the previous one.
  template <class Scene>
  void remember(const Scene& scene) {
    if (held_step_ == scene.steps) return;
    record_work(scene);
    const std::size_t now = changes(scene);
    follows_ = held_step_ + 1 == scene.steps && held_changes_ == now;
    held_changes_ = now;
    held_before_ = std::exchange(held_, held(scene));
    held_step_ = scene.steps;
  }

  /// Checks a scene after a step. Without `TrackEnergy` it must have seen the previous step (`remember`) or
  /// no step.
  template <class Scene>
  Found look(const Scene& scene) {
    if constexpr (!tracks_energy<Scene>) {
      remember(scene);
      if (!follows_ && scene.steps > 0) return {};
    }
    const Balance now = balance(scene);
    double initial = now.stored;
    if constexpr (tracks_energy<Scene>)
      initial = std::max(initial, scene.template part<TrackEnergy>().initial());
    floor_ = std::max(floor_, allowed_drift(scene));
    return judge(now, changes(scene), initial, tracks_energy<Scene>);
  }

  template <class F>
  void visit_state(F&& f) {
    f("start/stored", start_.stored);
    f("start/external", start_.external);
    f("start/brought", start_.brought);
    f("start/gained", start_.gained);
    f("start/transfer", start_.transfer);
    f("start/residual", start_.residual);
    f("put_in", put_in_);
    f("moved", moved_);
    f("floor", floor_);
    f("gain", gain_);
    f("lowest", lowest_);
    f("before", before_);
    f("held/strain", held_.strain);
    f("held/ahead", held_.ahead);
    f("held/potential", held_.potential);
    f("held_before/strain", held_before_.strain);
    f("held_before/ahead", held_before_.ahead);
    f("held_before/potential", held_before_.potential);
    f("held_step", held_step_);
    f("follows", follows_);
    f("started", started_);
    f("changes", changes_);
    f("acceleration", acceleration_);
    f("moment", moment_);
    f("work", work_);
    f("held_changes", held_changes_);
  }

 private:
  /// Points lost, inserted and removed since the start.
  template <class Scene>
  static std::size_t changes(const Scene& scene) {
    auto n = static_cast<double>(scene.lost_points());
    scene.for_each_body([&](const auto& body, const auto&) {
      n += static_cast<double>(body.inserted.count + body.removed.count);
    });
    sum_over(scene.communicator(), n);
    return static_cast<std::size_t>(n);
  }

  /// Acceleration of the scene in the next step, m/s2.
  template <class Scene>
  static std::array<double, 3> acceleration_of(const Scene& scene) {
    std::array<double, 3> all{};
    const auto a = scene.acceleration();
    for (int k = 0; k < Scene::D; ++k) all[static_cast<std::size_t>(k)] = static_cast<double>(a[k]);
    return all;
  }

  /// Adds the work of the acceleration since the last call: acceleration times the change of sum m x. `judge`
  /// leaves out the contribution of points that were lost or inserted: it starts again.
  template <class Scene>
  void record_work(const Scene& scene) {
    const auto before = std::exchange(moment_, {});
    scene.for_each_body([&](const auto& body, const auto&) {
      const auto& p = body.points;
      const auto moment = moment_of_mass(p.size(), p.mass.data(), Scene::D, column_data(p.position));
      for (std::size_t k = 0; k < 3; ++k) moment_[k] += moment[k];
    });
    sum_over(scene.communicator(), moment_);
    for (std::size_t k = 0; k < 3; ++k) work_ += acceleration_[k] * (moment_[k] - before[k]);
    acceleration_ = acceleration_of(scene);
  }

  /// Configurational energy, J: strain and potential. `ahead`: the part of the strain energy whose stresses
  /// are not those of the middle of the step, as velocities are.
  struct Held {
    double strain = 0, ahead = 0, potential = 0;
    double sum() const { return strain + potential; }
  };
  template <class Scene>
  Held held(const Scene& scene) const {
    Held h;
    scene.for_each_body([&](const auto& body, const auto& field) {
      const double strain = strain_energy(body);
      h.strain += strain;
      if (!field.centred) h.ahead += strain;
    });
    sum_over(scene.communicator(), h.strain, h.ahead);
    h.potential = -work_;
    return h;
  }

  /// Energies, J: kinetic and strain energy; external work, energy of inserted points, energy gained from
  /// nothing, energy lost in the transfer and residual of the balance since some time.
  struct Balance {
    double stored = 0, external = 0, brought = 0, gained = 0, transfer = 0, residual = 0;
  };
  /// `initial`: energy at the start, J.
  Found judge(const Balance& now, std::size_t changes, double initial, bool tracks);
  template <class Scene>
  Balance balance(const Scene& scene) const {
    Balance b;
    if constexpr (tracks_energy<Scene>) {
      const Energies e = energies(scene);
      b.stored = e.kinetic + e.strain + e.stored;
      b.external = e.external;
      // Dissipation that is negative is energy made: by a law, or in contact.
      b.transfer = e.transfer;
      b.residual = e.residual - e.lag;
      b.gained =
          e.residual - e.transfer - e.walls - e.lag - std::min(e.plastic, 0.0) - std::min(e.contact, 0.0);
    } else {
      const PartEnergy parts = energy_of_parts(scene, is_reporter(scene));
      double kinetic = 0, external = parts.external;
      scene.for_each_body([&](const auto& body, const auto&) { kinetic += kinetic_energy(body); });
      kinetic += parts.kinetic + parts.stored;
      sum_over(scene.communicator(), kinetic, external);
      b.stored = kinetic + held_.strain;
      b.external = external - held_.potential;
      b.gained = kinetic + held_.sum() - external;
      // Velocities belong to the middle of a step, positions to its end: the energy oscillates by a share of
      // (frequency x step) unless its configurational part is taken half a step earlier, or later with USF.
      // Centred stresses belong to the middle already.
      if (follows_) b.gained -= (held_.potential - held_before_.potential) / 2;
      if (follows_)
        b.gained -= (held_.ahead - held_before_.ahead) / (Scene::NumericsType::strains_first ? -2 : 2);
    }
    // The kinetic energy in the velocity gradients of points returns to their velocities. With AFLIP the
    // velocities keep their share of what is also in the gradients.
    double all_spread = 0;
    scene.for_each_body([&](const auto& body, const auto&) {
      b.brought += body.inserted.kinetic_energy + body.inserted.strain_energy;
      double spread = gradient_kinetic_energy<typename Scene::Shape>(scene.mesh, scene.blocks, body);
      if constexpr (requires { scene.numerics.transfer.fraction; })
        spread *= 1 - static_cast<double>(scene.numerics.transfer.fraction);
      all_spread += spread;
    });
    sum_over(scene.communicator(), b.brought, all_spread);
    b.stored += all_spread;
    b.gained += all_spread;
    return b;
  }

  /// Work of gravity on all points in a fall by a hundredth of a cell, J: below it a scene counts as at rest.
  template <class Scene>
  static double allowed_drift(const Scene& scene) {
    double all = 0;
    scene.for_each_body([&](const auto& body, const auto&) { all += mass(body); });
    sum_over(scene.communicator(), all);
    const auto g = acceleration_of(scene);
    return 0.01 * mean_cell(scene) * all * std::sqrt(g[0] * g[0] + g[1] * g[1] + g[2] * g[2]);
  }

  Balance start_{};              // at the first check; without TrackEnergy: when points were last lost
  double put_in_ = 0;            // kinetic and strain energy at the first check, and of points since, J
  double moved_ = 0;             // greatest external work since then, J
  double floor_ = 0;             // least energy of a scene that is not at rest, J
  double gain_ = 0;              // at the last check, J
  double lowest_ = 0;            // least gain at a check, J; without TrackEnergy: 0
  double before_ = 0;            // gain until points were last lost, J
  Held held_{}, held_before_{};  // after step held_step_ and the previous one
  std::size_t held_step_ = std::numeric_limits<std::size_t>::max() / 2;  // none
  bool follows_ = false;                                                 // whether the previous one is known
  bool started_ = false;                                                 // whether there was a check
  std::array<double, 3> acceleration_{}, moment_{};  // in the step after `record_work`, m/s2; then, kg m
  double work_ = 0;                                  // of the acceleration since the first call, J
  std::size_t changes_ = 0, held_changes_ = 0;       // of the points: at the last check; at held_step_
};

}  // namespace arenite::inline ARENITE_INSTRUCTION_SET

#if ARENITE_HAS_COLD

namespace arenite::inline ARENITE_INSTRUCTION_SET {

ARENITE_COLD WatchedEnergy::Found WatchedEnergy::judge(const Balance& now, std::size_t changes,
                                                       double initial, bool tracks) {
  if (!started_) {
    started_ = true;
    start_ = now;
    put_in_ = initial;
    changes_ = changes;
  } else if (!tracks && changes_ != changes) {
    // The energy of the points lost or inserted is not known: start again.
    put_in_ += now.brought - start_.brought;
    start_ = now;
    before_ = gain_;
    changes_ = changes;
  }
  gain_ = before_ + now.gained - start_.gained;
  moved_ = std::max(moved_, std::abs(now.external - start_.external));
  if (tracks) lowest_ = std::min(lowest_, gain_);
  const auto fraction = [&](double energy) {
    const double all = put_in_ + moved_ + now.brought - start_.brought;
    const double f = energy == 0 ? 0 : energy / std::max(all, floor_);
    return f > 0 || std::isnan(f) ? f : 0;
  };
  return {true, fraction(gain_ - lowest_), fraction(now.transfer - start_.transfer),
          fraction(std::abs(now.residual - start_.residual))};
}

}  // namespace arenite::inline ARENITE_INSTRUCTION_SET

#endif  // ARENITE_HAS_COLD
