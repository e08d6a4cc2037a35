// State of a rigid body, and the nodes that it touches: all of it that depends on neither surface nor motion.
#pragma once
// SPDX-License-Identifier: BSD-3-Clause

#include <concepts>
#include <cstddef>
#include <span>
#include <vector>

#include <arenite/contact/coulomb.hpp>
#include <arenite/core/cold.hpp>
#include <arenite/parallel/communicator.hpp>
#include <arenite/rigid/pose.hpp>

namespace arenite::inline ARENITE_INSTRUCTION_SET {

/// One touched node of one field.
template <class T, int D>
struct TouchedNode {
  using V = Vec<T, D>;
  std::size_t field;
  Index node;
  bool inside;
  T mass;        ///< of the field at the node, kg
  T mass_ratio;  ///< what an impulse has to move, as a share of `mass`: 1, or m_rigid / (m_rigid + mass)
  V start;       ///< velocity of the field before contact, m/s
  V normal;      ///< out of the body
  bool sticks = false;     ///< to the body: no relative motion at all
  V impulse = zeros<V>();  ///< on the field, N s
  V after = zeros<V>();    ///< velocity of the field with the impulse
  V arm = zeros<V>();      ///< from the centre of a body that rotates, m
};

/// Impulses of a body on the fields in a step.
template <class T, int D, int N>
struct GivenImpulses {
  Twist<T, D, N> total = zeros<Twist<T, D, N>>();  ///< N s, with their moments
  T gained = 0;                              ///< impulses times the fields' mean velocities over the step, J
  Vec<T, 2> exchanged = zeros<Vec<T, 2>>();  ///< sums of their magnitudes and of those of their moments
};

/// Sums numbers over the scenes that share a body, whatever their type; nothing where a scene is alone.
class SumOver {
 public:
  template <class Communicator>
  requires(!std::same_as<Communicator, SumOver>) SumOver([[maybe_unused]] Communicator& comm) {
    if constexpr (!Communicator::is_serial) {
      comm_ = &comm;
      sum_ = [](void* all, std::span<double> values) { static_cast<Communicator*>(all)->sum(values); };
    }
  }
  template <class... V>
  void operator()(V&... value) const {
    if (sum_ != nullptr) sum_over(*this, value...);
  }

  static constexpr bool is_serial = false;
  void sum(std::span<double> values) const { sum_(comm_, values); }

 private:
  void* comm_ = nullptr;
  void (*sum_)(void*, std::span<double>) = nullptr;
};

/// State of a rigid body. `N`: components of its velocity (`Twist`).
template <class T, int D, int N>
struct RigidState {
  using V = Vec<T, D>;
  using Velocity = Twist<T, D, N>;
  using TouchedNode = arenite::TouchedNode<T, D>;

  Friction friction;
  V velocity;                     ///< of the centre, m/s
  V displacement = zeros<V>();    ///< since the start, m
  V force = zeros<V>();           ///< mean contact force on the body during the last step, N
  V impulse = zeros<V>();         ///< contact impulse on the body since the start, N s
  double driving_work = 0;        ///< work of gravity, load or the prescribed motion's drive, J
  double dissipated = 0;          ///< by contact, since the start, J
  std::size_t contact_nodes = 0;  ///< nodes that pushed on the body in the last step
  /// Nodes inside the body that carried mass in the last step; `PointContact` does not look for them.
  std::size_t inside_nodes = 0;
  Spin<T, D> spin;                                   ///< angular velocity, rad/s
  Orientation<D> orientation{};                      ///< against the start
  Spin<T, D> torque = zeros<Spin<T, D>>();           ///< mean moment of contact about the centre, N m
  Spin<T, D> angular_impulse = zeros<Spin<T, D>>();  ///< of contact since the start, N m s
  /// Of the last step; with `PointContact` those that took an impulse, without normals.
  std::vector<TouchedNode> touched_nodes{};

  RigidState(const Friction& of_all, const Velocity& start);

  /// Velocity, or velocity and spin.
  Velocity whole_velocity() const;
  /// On a field in the last step, N s.
  V contact_impulse(std::size_t field) const;
  /// Velocity of the body at a touched node if it moves with v, m/s.
  V surface_velocity(const TouchedNode& t, const Velocity& v) const { return velocity_at<T, D, N>(v, t.arm); }
  /// Impulse on the field at a touched node, N s, if the body moves with velocity v.
  V impulse_at(const TouchedNode& t, const Velocity& v) const;
  /// Finds the impulses on all touched nodes if the body moves with velocity v; the fields' gain is left open.
  GivenImpulses<T, D, N> find_impulses(const Velocity& v);
  /// Books the impulses of a step on the fields.
  void take_impulse(const Velocity& total, T dt);
  /// Sets the velocity and, if the body rotates, the spin.
  void set_velocity(const Velocity& v);
  template <class F>
  void visit_state(F&& f) {
    f("velocity", velocity);
    f("displacement", displacement);
    f("force", force);
    f("impulse", impulse);
    f("driving_work", driving_work);
    f("dissipated", dissipated);
    f("contact_nodes", contact_nodes);
    f("inside_nodes", inside_nodes);
    if constexpr (N > D) {
      f("spin", spin);
      f("torque", torque);
      f("angular_impulse", angular_impulse);
      orientation.visit_state(f);
    }
  }
};

}  // namespace arenite::inline ARENITE_INSTRUCTION_SET

#ifndef ARENITE_COLD_LIBRARY
#include <arenite/rigid/rigid_state_cold.hpp>
#endif
