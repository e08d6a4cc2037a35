// Guided: a rigid body that slides along one axis under forces.
#pragma once
// SPDX-License-Identifier: BSD-3-Clause

#include <array>
#include <cmath>
#include <limits>

#include <arenite/boundary/place_function.hpp>
#include <arenite/core/tensor.hpp>
#include <arenite/rigid/contact_balance.hpp>

namespace arenite::inline ARENITE_INSTRUCTION_SET {

/// A mass that slides along one axis without friction, under gravity, a load and the contact forces (the
/// paper's eqs. 1 to 4).
struct Guided {
  double mass = std::numeric_limits<double>::quiet_NaN();  ///< kg: that of what the scene models (a slice, a
                                                           ///< metre, the full circle)
  std::array<double, 3> axis{0, 1, 0};                     ///< direction of the guide; any length
  double velocity = 0;                                     ///< initial velocity along the axis, m/s
  ScalarFunction load = 0.0;                               ///< external force along the axis, N; of time
};

/// A guided motion in D dimensions over scalar T.
template <class T, int D>
struct BoundGuided {
  using V = Vec<T, D>;
  static constexpr bool has_mass = true;
  double mass;          ///< kg
  ScalarFunction load;  ///< N
  V axis;               ///< unit vector of the guide
  T speed;              ///< at the start, m/s

  /// `hoop`: in axisymmetry the guide is the axis.
  explicit BoundGuided(const Guided& g, bool hoop = false);

  V start() const { return speed * axis; }
  /// With the load at the start of the step.
  V free_velocity(const V& before, const V& acceleration, T time, T dt) const;
  template <class Body, class Communicator = const Serial>
  V velocity_in_contact(const Body& body, const V& free_velocity,
                        [[maybe_unused]] Communicator& comm = serial) const {
    if constexpr (Body::coupling_through_centre)
      return free_velocity;  // `after` corrects it: eq. (4)
    else
      return detail::balance_speed<T, D>(body, axis, free_velocity.dot(axis), static_cast<T>(mass), comm) *
             axis;
  }
  V after(const V& contact_velocity, const V& free_velocity, const V& total,
          const Vec<T, 2>& exchanged) const;
  V mean(const V& before, const V& after) const { return (before + after) / 2; }
  /// For the contact of rigid bodies (`RigidContact`): change of the velocity by an impulse; `added`: how the
  /// impulse of the matter opposes the velocity, as a mass.
  Mat<double, D> mobility(const Mat<double, D>& added) const;
  double work(const V& before, const V& free_velocity, const V& mean, const V&) const;
  double kinetic_energy(const V& v) const { return 0.5 * mass * static_cast<double>(v.squaredNorm()); }
  bool holds(const V& g) const { return std::abs(axis.dot(g)) <= 1e-6 * g.norm(); }
};

template <class Traits>
auto bind_part(const Guided& motion, const Traits&) {
  return BoundGuided<typename Traits::T, Traits::D>(motion, Traits::Kinematics::hoop);
}

}  // namespace arenite::inline ARENITE_INSTRUCTION_SET

#ifndef ARENITE_COLD_LIBRARY
#include <arenite/rigid/guided_cold.hpp>
#endif
