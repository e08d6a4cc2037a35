// Twist: velocity and spin of a rigid body, or an impulse on it and its moment; what they mean at a point.
#pragma once
// SPDX-License-Identifier: BSD-3-Clause

#include <algorithm>

#include <arenite/core/tensor.hpp>

namespace arenite::inline ARENITE_INSTRUCTION_SET {

/// Components of a rotation: one in the plane, about z; three in space.
template <int D>
inline constexpr int rotations = D == 2 ? 1 : 3;

/// Angular velocity, rad/s, angular momentum or moment of force, [1] in the plane, [3] in space.
template <class T, int D>
using Spin = Vec<T, rotations<D>>;

/// Velocity of a rigid body's centre, m/s, followed by its angular velocity, rad/s; or impulse, N s, followed
/// by the angular impulse about the centre, N m s. [3] in the plane, [6] in space.
template <class T, int D>
using Twist = Vec<T, D + rotations<D>>;

template <class T, int D>
Twist<T, D> twist(const Vec<T, D>& linear, const Spin<T, D>& angular) {
  Twist<T, D> both;
  both << linear, angular;
  return both;
}

// A body that does not rotate has a velocity and an impulse of D components. The functions below take either:
// N = D, with no spin and no moment, or the N components of a twist.

/// Velocity of the centre, m/s; or impulse, N s.
template <int D, class T, int N>
Vec<T, D> linear_part(const Vec<T, N>& u) {
  return u.template head<D>();
}
/// Angular velocity, rad/s; or angular impulse about the centre, N m s.
template <int D, class T, int N>
Spin<T, D> angular_part([[maybe_unused]] const Vec<T, N>& u) {
  if constexpr (N == D)
    return Spin<T, D>::Zero();
  else
    return u.template tail<rotations<D>>();
}
/// The first components of u, or u followed by zeros: [M] of [N].
template <int M, class T, int N>
Vec<T, M> resized(const Vec<T, N>& u) {
  constexpr int common = std::min(M, N);
  Vec<T, M> v = Vec<T, M>::Zero();
  v.template head<common>() = u.template head<common>();
  return v;
}

/// Velocity, m/s, of a body's point at `arm`, m, from its centre.
template <class T, int D, int N>
Vec<T, D> velocity_at(const Vec<T, N>& body, [[maybe_unused]] const Vec<T, D>& arm) {
  if constexpr (N == D)
    return body;
  else if constexpr (D == 2)
    return {body[0] - body[2] * arm[1], body[1] + body[2] * arm[0]};
  else
    return linear_part<D>(body) + angular_part<D>(body).cross(arm);
}
/// W with W u = `velocity_at(u, arm)`, [D x N]; its transpose takes an impulse at the point to one on the
/// body.
template <int D, int N>
Eigen::Matrix<double, D, N> velocity_map(const Vec<double, D>& arm) {
  Eigen::Matrix<double, D, N> w;
  for (int k = 0; k < N; ++k) {
    Vec<double, N> unit = zeros<Vec<double, N>>();
    unit[k] = 1;
    const Vec<double, D> v = velocity_at<double, D>(unit, arm);
    for (int d = 0; d < D; ++d) w(d, k) = v[d];
  }
  return w;
}

/// Moment of a force or impulse that acts at `arm` from the centre.
template <class T, int D>
Spin<T, D> moment(const Vec<T, D>& arm, const Vec<T, D>& force) {
  if constexpr (D == 2)
    return Spin<T, D>(arm[0] * force[1] - arm[1] * force[0]);
  else
    return arm.cross(force);
}
/// An impulse, N s, that acts at `arm`, m, from the centre, with its moment, N m s, where N is not D.
template <int N, class T, int D>
Vec<T, N> with_moment(const Vec<T, D>& impulse, [[maybe_unused]] const Vec<T, D>& arm) {
  if constexpr (N == D)
    return impulse;
  else
    return twist<T, D>(impulse, moment<T, D>(arm, impulse));
}

}  // namespace arenite::inline ARENITE_INSTRUCTION_SET
