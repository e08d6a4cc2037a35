// Cold functions of rigid_state.hpp.
#pragma once
// SPDX-License-Identifier: BSD-3-Clause

#include <arenite/rigid/rigid_state.hpp>

namespace arenite::inline ARENITE_INSTRUCTION_SET {

namespace detail {
/// Impulse on the field at a touched node if the body moves with velocity v.
template <class T, int D, int N>
CoulombImpulse<T, D> contact_at(const TouchedNode<T, D>& t, const Vec<T, N>& v, const Friction& friction) {
  const Vec<T, D> approach = t.start - velocity_at<T, D, N>(v, t.arm);
  if (t.inside) return stick<T, D>(approach, t.mass_ratio * t.mass);
  return coulomb<T, D>(approach, t.normal, t.mass_ratio * t.mass, friction);
}
}  // namespace detail

template <class T, int D, int N>
ARENITE_COLD RigidState<T, D, N>::RigidState(const Friction& of_all, const Velocity& start)
    : friction{of_all}, velocity{linear_part<D>(start)}, spin{angular_part<D>(start)} {}

template <class T, int D, int N>
ARENITE_COLD auto RigidState<T, D, N>::whole_velocity() const -> Velocity {
  if constexpr (N == D)
    return velocity;
  else
    return twist<T, D>(velocity, spin);
}

template <class T, int D, int N>
ARENITE_COLD auto RigidState<T, D, N>::contact_impulse(std::size_t field) const -> V {
  V sum = V::Zero();
  for (const auto& t : touched_nodes)
    if (t.field == field) sum += t.impulse;
  return sum;
}

template <class T, int D, int N>
ARENITE_COLD auto RigidState<T, D, N>::impulse_at(const TouchedNode& t, const Velocity& v) const -> V {
  return detail::contact_at<T, D, N>(t, v, friction).impulse;
}

template <class T, int D, int N>
ARENITE_COLD GivenImpulses<T, D, N> RigidState<T, D, N>::find_impulses(const Velocity& v) {
  GivenImpulses<T, D, N> given;
  contact_nodes = 0;
  for (auto& t : touched_nodes) {
    const auto contact = detail::contact_at<T, D, N>(t, v, friction);
    const V& j = contact.impulse;
    if (j.squaredNorm() == 0) continue;
    t.impulse = j;
    t.sticks = contact.sticks;
    given.total += with_moment<N>(t.arm, j);
    given.exchanged += Vec<T, 2>(j.norm(), j.norm() * t.arm.norm());
    ++contact_nodes;
  }
  return given;
}

template <class T, int D, int N>
ARENITE_COLD void RigidState<T, D, N>::take_impulse(const Velocity& total, T dt) {
  const V given = linear_part<D>(total);
  const Spin<T, D> turned = angular_part<D>(total);
  for (int k = 0; k < D; ++k) {
    force[k] = -given[k] / dt;
    impulse[k] -= given[k];
  }
  for (int k = 0; k < rotations<D>; ++k) {
    torque[k] = -turned[k] / dt;
    angular_impulse[k] -= turned[k];
  }
}

template <class T, int D, int N>
ARENITE_COLD void RigidState<T, D, N>::set_velocity(const Velocity& v) {
  velocity = linear_part<D>(v);
  if constexpr (N > D) spin = angular_part<D>(v);
}

#define ARENITE_INSTANCES(T, D)        \
  template struct RigidState<T, D, D>; \
  template struct RigidState<T, D, D + rotations<D>>;
ARENITE_FOR_NUMBERS_AND_DIMENSIONS(ARENITE_INSTANCES)
#undef ARENITE_INSTANCES

}  // namespace arenite::inline ARENITE_INSTRUCTION_SET
