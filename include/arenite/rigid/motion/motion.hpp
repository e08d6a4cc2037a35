// Motion of a rigid body: the concepts. Motions are `Guided`, `Prescribed`, `Free` and `PrescribedPose`, or
// one of a user's own.
#pragma once
// SPDX-License-Identifier: BSD-3-Clause

#include <concepts>

#include <arenite/core/tensor.hpp>
#include <arenite/rigid/body/pose.hpp>

namespace arenite::inline ARENITE_INSTRUCTION_SET {

/// Whether a motion turns its body: it says so by `static constexpr bool rotates = true`.
template <class M>
inline constexpr bool rotates = [] {
  if constexpr (requires { M::rotates; })
    return M::rotates;
  else
    return false;
}();

/// A motion without rotation, once bound to a scene (a recipe may have a `bind_part`). V: a vector [D] of the
/// scene; velocities in m/s, impulses in N s. In a step contact asks for the velocity that the body would
/// have without contact, for the one with which impulses are found, and, once they are given, for the one
/// after them.
///
/// - `has_mass`: whether impulses change the motion; such a motion has `mass`, kg;
/// - `start()`: initial velocity, m/s;
/// - `free_velocity(before, acceleration, time, dt)`: velocity at the end of the step, `time`, without
///   contact;
/// - `velocity_in_contact(body, free_velocity)`: velocity of the surface in contact; `body.impulse_at(node,
///   v)` for a node of `body.touched_nodes` is the impulse on the matter if the body moves with v;
///   on several tiles each then has the touched nodes of all;
/// - `after(contact_velocity, free_velocity, total, magnitudes)`: velocity at the end of the step;
///   `contact_velocity`: the velocity in contact, `total`: impulse on the matter, `magnitudes`: sum of the
///   magnitudes of the impulses;
/// - `mean(before, after)`: velocity with which the impulses did work;
/// - `work(before, free_velocity, mean, total)`: work of gravity, load or drive in the step, J;
/// - `kinetic_energy(v)`: J;
/// - `holds(acceleration)`: whether the body would not fall with the matter.
template <class M, class V>
concept rigid_motion = !rotates<M> && requires(const M motion, const V v, typename V::Scalar t) {
  { M::has_mass } -> std::convertible_to<bool>;
  { motion.start() } -> std::convertible_to<V>;
  { motion.free_velocity(v, v, t, t) } -> std::convertible_to<V>;
  { motion.after(v, v, v, t) } -> std::convertible_to<V>;
  { motion.mean(v, v) } -> std::convertible_to<V>;
  { motion.work(v, v, v, v) } -> std::convertible_to<double>;
  { motion.kinetic_energy(v) } -> std::convertible_to<double>;
  { motion.holds(v) } -> std::convertible_to<bool>;
};

/// A motion with rotation, `rotates`. Its velocities are twists, velocity of the centre and spin, and its
/// impulses are followed by their moment about the centre (`Twist`). Beside the members above:
///
/// - `centre()`: the point of the body whose velocity is given, at the start, m;
/// - `free_velocity(body, before, acceleration, time, dt)`: with the body, whose `displacement` and
///   `orientation` are those of the start of the step;
/// - `after(contact_velocity, free_velocity, total, magnitudes)`: `magnitudes` are the sums of the magnitudes
///   of impulses and of their moments;
/// - `turn(orientation, velocity, dt)`: turns the orientation through the step and returns the twist there;
/// - optional `stored_energy(body)`, J, and `damped`, J since the start: of springs and dashpots.
template <class M, class T, int D>
concept rotating_motion = rotates<M> &&
    requires(M motion, const Twist<T, D> u, const Vec<T, D> v, const Vec<T, 2> e, Orientation<D> o, T t) {
  { M::has_mass } -> std::convertible_to<bool>;
  { motion.start() } -> std::convertible_to<Twist<T, D>>;
  { motion.centre() } -> std::convertible_to<Vec<double, D>>;
  { motion.after(u, u, u, e) } -> std::convertible_to<Twist<T, D>>;
  { motion.turn(o, u, t) } -> std::convertible_to<Twist<T, D>>;
  { motion.mean(u, u) } -> std::convertible_to<Twist<T, D>>;
  { motion.work(u, u, u, u) } -> std::convertible_to<double>;
  { motion.kinetic_energy(u) } -> std::convertible_to<double>;
  { motion.holds(v) } -> std::convertible_to<bool>;
};

}  // namespace arenite::inline ARENITE_INSTRUCTION_SET
