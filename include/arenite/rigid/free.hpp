// Free: a rigid body that moves and turns under gravity, contact, springs, forces and moments.
#pragma once
// SPDX-License-Identifier: BSD-3-Clause

#include <array>
#include <limits>

#include <arenite/boundary/place_function.hpp>
#include <arenite/rigid/anchor.hpp>
#include <arenite/rigid/contact_balance.hpp>
#include <arenite/rigid/inertia.hpp>

namespace arenite::inline ARENITE_INSTRUCTION_SET {

/// A mass that moves and turns freely: in the plane with three degrees of freedom, in space with six, in
/// axisymmetry along the axis alone. Vectors are {x, y, z}; in the plane spins and moments have a z alone.
struct Free {
  static constexpr double not_given = std::numeric_limits<double>::quiet_NaN();
  double mass = not_given;  ///< kg: that of what the scene models (a slice, a metre, the full circle)
  Inertia inertia{};        ///< about the centre of mass, kg m2; not needed in axisymmetry
  std::array<double, 3> centre{not_given, not_given, 0};  ///< of mass, at the start, m
  std::array<double, 3> velocity{};                       ///< of the centre at the start, m/s
  std::array<double, 3> spin{};                           ///< angular velocity at the start, rad/s
  Anchor anchor{};                                        ///< springs and dashpots to the world
  VectorFunction force{0, 0, 0};                          ///< on the centre, N; of time
  VectorFunction moment{0, 0, 0};                         ///< N m; of time
};

/// A free body in D dimensions over scalar T.
template <class T, int D>
class BoundFree {
 public:
  static constexpr int N = D + rotations<D>;
  using V = Vec<double, D>;
  using S = Spin<double, D>;
  using U = Twist<double, D>;
  using Velocity = Twist<T, D>;
  using State = RigidState<T, D, N>;
  static constexpr bool has_mass = true, rotates = true;
  double mass;        ///< kg
  double damped = 0;  ///< by the anchor's dashpots since the start, J

  /// `hoop`: in axisymmetry the body moves along the axis.
  explicit BoundFree(const Free& f, bool hoop = false);

  /// Of mass, at the start, m.
  const V& centre() const { return centre_; }
  /// About the centre of mass, kg m2/s.
  const S& angular_momentum() const { return momentum_; }
  Velocity start() const;

  /// Adds forces and moments of the start of the step; dashpots by the velocity that they leave.
  Velocity free_velocity(const State& body, const Velocity& before, const Vec<T, D>& acceleration, T time,
                         T dt);
  template <class Communicator = const Serial>
  Velocity velocity_in_contact(const State& body, const Velocity& free_velocity,
                               Communicator& comm = serial) const {
    return balanced(body, free_velocity, comm);
  }
  Velocity after(const Velocity& contact_velocity, const Velocity& free_velocity, const Velocity& total,
                 const Vec<T, 2>& exchanged);
  Velocity mean(const Velocity& before, const Velocity& after) const;

  /// For the contact of rigid bodies (`RigidContact`). Change of the twist by an impulse and its moment, once
  /// `free_velocity` was asked for; `added`: how the impulse of the matter opposes the twist, as an inertia.
  Mat<double, N> mobility(const Mat<double, N>& added) const;
  /// Takes an impulse of another rigid body with its moment, before `after`.
  void push(const U& impulse);
  /// The orientation at the end of a step with this twist.
  Orientation<D> turned(Orientation<D> orientation, const U& u, double dt) const;

  /// Of gravity, forces and moments, J; that of dashpots is booked as `damped`.
  double work(const Velocity&, const Velocity&, const Velocity& mean, const Velocity&);

  /// Turns the body through the step; returns its velocity and spin there.
  Velocity turn(Orientation<D>& orientation, const Velocity& velocity, T dt) const;

  double kinetic_energy(const Velocity& v) const;
  double stored_energy(const State& body) const;
  bool holds(const Vec<T, D>& g) const;
  template <class F>
  void visit_state(F&& f) {
    f("angular_momentum", momentum_);
    f("damped", damped);
  }

 private:
  using Inertias = Mat<double, rotations<D>>;

  Velocity balanced(const State& body, const Velocity& free_velocity, SumOver sum) const;
  Mat<double, N> whole_inertia() const;
  Inertias inertia_in_space(const Orientation<D>& orientation) const;
  /// 1 for each component of the velocity that may change.
  U moves() const;

  bool hoop_;
  BoundAnchor<D> anchor_;
  VectorFunction force_, moment_;
  V centre_, velocity_;
  S spin_;
  Inertias inertia_ = zeros<Inertias>();  // in the body's frame
  S momentum_;
  // Of the step.
  Inertias in_space_;
  S free_momentum_ = zeros<S>();
  U gained_, of_springs_, of_dashpots_;  // impulses without contact
};

template <class Traits>
auto bind_part(const Free& motion, const Traits&) {
  return BoundFree<typename Traits::T, Traits::D>(motion, Traits::Kinematics::hoop);
}

}  // namespace arenite::inline ARENITE_INSTRUCTION_SET

#ifndef ARENITE_COLD_LIBRARY
#include <arenite/rigid/free_cold.hpp>
#endif
