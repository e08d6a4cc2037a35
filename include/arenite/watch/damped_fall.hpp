// Damped fall: matter that moves freely while local damping, which is made for static states, is on.
#pragma once
// SPDX-License-Identifier: BSD-3-Clause

#include <cmath>
#include <limits>

#include <arenite/load/damping.hpp>
#include <arenite/watch/watched_energy.hpp>

namespace arenite::inline ARENITE_INSTRUCTION_SET {

/// Follows a scene from check to check while its local damping is on.
class DampedFall {
 public:
  /// Share of the work of gravity that local damping dissipated, -, once matter has fallen by more than a
  /// cell on average and a twentieth of that work or more is kinetic energy; else 0, as in slow settling (of
  /// a column, or under a footing that is pressed down).
  template <class Scene>
  double look(const Scene& scene) {
    const auto& damping = scene.template part<LocalDamping>();
    double damped = damping.count_energy().dissipated, all = 0, kinetic = 0, along = 0;
    const Vec<double, Scene::D> g = scene.acceleration().template cast<double>();
    scene.for_each_body([&](const auto& body, const auto&) {
      all += mass(body);
      kinetic += kinetic_energy(body);
      along += momentum(body).dot(g);
    });
    sum_over(scene.communicator(), damped, all, kinetic, along);
    const double power = along > 0 ? along : 0;       // of gravity, W
    if (!damping.is_on() || !(scene.time > time_)) {  // at the first check too
      damped_ = damped;
      work_ = 0;
      cell_ = mean_cell(scene);
    } else {
      work_ += (power + power_) / 2 * (scene.time - time_);
    }
    power_ = power;
    time_ = scene.time;
    if (!(work_ > all * g.norm() * cell_) || kinetic < 0.05 * work_) return 0;
    return (damped - damped_) / work_;
  }

  template <class F>
  void visit_state(F&& f) {
    f("time", time_);
    f("power", power_);
    f("cell", cell_);
    f("work", work_);
    f("damped", damped_);
  }

 private:
  double time_ = std::numeric_limits<double>::infinity();  // of the last check, s
  double power_ = 0;                                       // then, W
  double cell_ = 0;                                        // edge of a mean cell, m
  double work_ = 0, damped_ = 0;  // of gravity since damping is on, and dissipated by it before, J
};

}  // namespace arenite::inline ARENITE_INSTRUCTION_SET
