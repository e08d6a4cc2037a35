// Damping: parts that bring a scene to rest, for static states by dynamic relaxation.
#pragma once
// SPDX-License-Identifier: BSD-3-Clause

#include <cmath>
#include <limits>

#include <arenite/core/checked.hpp>
#include <arenite/load/node_force.hpp>
#include <arenite/parallel/parallel.hpp>
#include <arenite/part/contact_tally.hpp>
#include <arenite/part/part_energy.hpp>

namespace arenite::inline ARENITE_INSTRUCTION_SET {

/// Viscous damping: velocities decay as exp(-rate t), whatever the step. Critical for a mode of angular
/// frequency w at rate = 2 w; below that the mode oscillates. It opposes all motion, free fall too.
struct ViscousDamping {
  struct RateRule {
    static constexpr const char* name = "ViscousDamping.rate";
    static constexpr const char* bounds = "must be given, and not negative";
    static bool holds(double rate) { return rate >= 0 && rate < std::numeric_limits<double>::infinity(); }
  };
  Checked<RateRule> rate;  ///< 1/s; required, >= 0
};

/// Local damping (Cundall 1987): at each node and along each axis a force of `factor` times the force out of
/// balance there, against the velocity. It does not slow a steady motion down, but a free one: matter falls
/// with 1 - factor of gravity. It needs no frequency: each mode loses the share 4 factor /
/// (1 + factor)^2 of its energy in a cycle. The force out of balance is that of the whole step, impulses of
/// contact and walls included: a body in quasi-static equilibrium, such as a slowly pushed footing, is not damped.
struct LocalDamping {
  struct FactorRule {
    static constexpr const char* name = "LocalDamping.factor";
    static constexpr const char* bounds = "must lie in [0, 1)";
    static bool holds(double factor) { return factor >= 0 && factor < 1; }
  };
  Checked<FactorRule> factor = 0.7;  ///< share of the force out of balance, -, in [0, 1)
};

/// Base of dampings: they can be switched off, and record the work of their forces as dissipated.
template <class T, int D>
class Damping : public FieldForces<T, D> {
 public:
  /// Damps no more, or again.
  void switch_off() { on_ = false; }
  void switch_on() { on_ = true; }
  bool is_on() const { return on_; }

  PartEnergy count_energy() const { return {.dissipated = dissipated_}; }
  template <class F>
  void visit_state(F&& f) {
    f("dissipated", dissipated_);
    f("on", on_);
  }

 protected:
  double dissipated_ = 0;  // since the start, J
  bool on_ = true;
};

/// Viscous damping in a mesh: a part that adds forces.
template <class T, int D>
class BoundViscousDamping : public Damping<T, D> {
 public:
  explicit BoundViscousDamping(const ViscousDamping& d) : rate_{d.rate} {}

  template <class Scene>
  void add_force(Scene& scene, double dt) {
    if (!this->on_) return;
    const auto factor = static_cast<T>(std::expm1(-rate_ * dt) / dt);
    for (std::size_t k = 0; k < scene.fields.size(); ++k) {
      const auto& field = scene.fields[k];
      auto& force = this->forces_[k].force;
      parallel_chunks(field.size(), [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) force[i] = factor * field.sums[i].momentum();
      });
    }
    this->add_to(scene);
  }
  template <class Scene>
  void follow_motion(const Scene& scene, double dt) {
    if (this->on_) this->dissipated_ -= this->work(scene, dt);
  }

 private:
  double rate_;
};

/// Local damping in a mesh: a part that changes velocities once all other parts have.
template <class T, int D>
class BoundLocalDamping : public Damping<T, D> {
 public:
  explicit BoundLocalDamping(const LocalDamping& d) : factor_{static_cast<T>(d.factor)} {}

  template <class Scene>
  ContactTally apply_impulses(Scene& scene, double dt) {
    if (this->on_)
      for (std::size_t k = 0; k < scene.fields.size(); ++k)
        damp(scene.fields[k], static_cast<T>(dt), this->forces_[k].force);
    return {};
  }
  template <class Scene>
  void after_grid(const Scene& scene, double dt) {
    if (this->on_) this->dissipated_ -= this->work_of_impulses(scene, dt);
  }

 private:
  template <class Field, class Forces>
  void damp(Field& field, T dt, Forces& force) const {
    parallel_chunks(field.size(), [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i) {
        Vec<T, D> taken = zeros<Vec<T, D>>();
        const Vec<T, D> before = field.start[i], change = field.velocity[i] - before;
        if (field.mass[i] > 0)
          for (int d = 0; d < D; ++d) {
            const T size = factor_ * std::abs(change[d]);
            taken[d] = before[d] > 0 ? size : before[d] < 0 ? -size : T(0);
          }
        field.velocity[i] -= taken;
        force[i] = -field.mass[i] / dt * taken;
      }
    });
  }

  T factor_;
};

template <class Traits>
auto bind_part(const ViscousDamping& d, const Traits&) {
  return BoundViscousDamping<typename Traits::T, Traits::D>(d);
}
template <class Traits>
auto bind_part(const LocalDamping& d, const Traits&) {
  return BoundLocalDamping<typename Traits::T, Traits::D>(d);
}

}  // namespace arenite::inline ARENITE_INSTRUCTION_SET
