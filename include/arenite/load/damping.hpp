// Damping: parts that bring a scene to rest, for static states by dynamic relaxation.
#pragma once

#include <cmath>
#include <limits>

#include <arenite/core/checked.hpp>
#include <arenite/core/part_energy.hpp>
#include <arenite/load/node_force.hpp>

namespace arenite::inline ARENITE_INSTRUCTION_SET {

/// Viscous damping: velocities decay as exp(-rate t), whatever the step. Critical for a mode of angular
/// frequency w at rate = 2 w; with less the mode swings on. It opposes all motion, a free fall too.
struct ViscousDamping {
  struct RateRule {
    static constexpr const char* name = "ViscousDamping.rate";
    static constexpr const char* bounds = "must be given, and not negative";
    static bool holds(double rate) { return rate >= 0 && rate < std::numeric_limits<double>::infinity(); }
  };
  Checked<RateRule> rate;  ///< 1/s
};

/// Local damping (Cundall 1987): at each node and along each axis a force of `factor` times the force out of
/// balance there, against the velocity. It does not slow a steady motion down, and needs no frequency: each
/// mode loses about the share 4 factor / (1 + factor) of its energy in a cycle. Gravity and the forces of
/// parts named before this one are counted as forces, so name it last.
struct LocalDamping {
  struct FactorRule {
    static constexpr const char* name = "LocalDamping.factor";
    static constexpr const char* bounds = "must lie in [0, 1)";
    static bool holds(double factor) { return factor >= 0 && factor < 1; }
  };
  Checked<FactorRule> factor = 0.7;
};

/// Force of viscous damping on a node, N: of the step dt, s, mass m, kg, and momentum at its begin, kg m/s.
template <class T, int D>
Vec<T, D> damping_force(const ViscousDamping& d, const Vec<T, D>& momentum, const Vec<T, D>&, double dt) {
  return static_cast<T>(std::expm1(-d.rate * dt) / dt) * momentum;
}
/// The same of local damping; `out_of_balance`: the force on the node, N.
template <class T, int D>
Vec<T, D> damping_force(const LocalDamping& d, const Vec<T, D>& momentum, const Vec<T, D>& out_of_balance,
                        double) {
  Vec<T, D> force;
  for (int k = 0; k < D; ++k) {
    const T size = static_cast<T>(d.factor) * std::abs(out_of_balance[k]);
    force[k] = momentum[k] > 0 ? -size : momentum[k] < 0 ? size : T(0);
  }
  return force;
}

/// Either in a mesh: a part that adds forces, and books what they take as dissipated.
template <class T, int D, class Damping>
class BoundDamping {
 public:
  explicit BoundDamping(const Damping& d) : damping_{d} {}

  template <class Scene>
  void connect(Scene& scene) {
    forces_.connect(scene);
  }
  /// Damps no more, or again.
  void switch_off() { on_ = false; }
  void switch_on() { on_ = true; }

  template <class Scene>
  void add_force(Scene& scene, double dt) {
    if (!on_) return;
    const Vec<T, D> acceleration = scene.acceleration();
    for (std::size_t k = 0; k < forces_.field.size(); ++k) {
      const auto& field = scene.fields[k];
      auto& force = forces_.field[k].force;
      parallel_chunks(field.size(), [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
          const auto& at = field.collected[i];
          force[i].setZero();
          if (at.mass() > 0)
            force[i] = damping_force<T, D>(damping_, at.momentum(),
                                           Vec<T, D>(at.force() + at.mass() * acceleration), dt);
        }
      });
    }
    forces_.add_to(scene);
  }
  template <class Scene>
  void follow_motion(Scene& scene, double dt) {
    if (on_) dissipated_ -= forces_.work(scene, dt);
  }
  PartEnergy count_energy() const { return {.dissipated = dissipated_}; }
  bool holds_against(const Vec<T, D>&) const { return false; }
  template <class F>
  void visit_state(F&& f) {
    f("dissipated", dissipated_);
    f("on", on_);
  }

 private:
  Damping damping_;
  FieldForces<T, D> forces_;
  double dissipated_ = 0;  // since the start, J
  bool on_ = true;
};

template <class Site>
auto bind_part(const ViscousDamping& d, const Site&) {
  return BoundDamping<typename Site::T, Site::D, ViscousDamping>(d);
}
template <class Site>
auto bind_part(const LocalDamping& d, const Site&) {
  return BoundDamping<typename Site::T, Site::D, LocalDamping>(d);
}

}  // namespace arenite::inline ARENITE_INSTRUCTION_SET
