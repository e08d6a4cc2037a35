// Balance of contact: the velocity and spin of a rigid body at which its impulses and those of all nodes that
// it touches balance.
#pragma once
// SPDX-License-Identifier: BSD-3-Clause

#include <limits>

#include <arenite/rigid/rigid_state.hpp>

namespace arenite::inline ARENITE_INSTRUCTION_SET::detail {

/// Speed along the guide that balances the impulses: f(s) = M (s - trial) + axis . sum J(s) = 0. f is made of
/// pieces that are straight (or nearly so, with friction in three dimensions), whose slopes may differ by as
/// much as soil and body: Newton steps on the pieces, inside a bracket that is halved where they leave it or
/// do not get ahead. The sums are taken over the touches of all scenes that share the body.
template <class T, int D>
T balance_speed(const RigidState<T, D, D>& body, const Vec<T, D>& axis, T trial, T mass, SumOver sum);

/// Solves f(u) = M (u - free) + sum_i W_i^T J_i(W_i u) = 0 for the twist u of a body, W_i u its velocity at
/// node i. f is made of pieces that are straight, or nearly so; without friction it is the gradient of a
/// convex function. Newton steps on the pieces, each followed along its direction to where f no longer points
/// ahead, reach the solution in a few steps, whatever the masses. Components are scaled by the square root of
/// the mass that they move. The sums are taken over the touches of all scenes that share the body.
/// `inertia`: M; `moves`: 1 for each component of the twist that may change, else 0.
template <class T, int D>
Twist<double, D> balance_twist(const RigidState<T, D, D + rotations<D>>& body, const Twist<double, D>& free,
                               const Mat<double, D + rotations<D>>& inertia, const Twist<double, D>& moves,
                               SumOver sum);

/// How the impulses of the matter on a body with this velocity oppose it, as an inertia [N x N]. Without
/// `coupling` friction that slips does not grow with the normal impulse: the resistance is then symmetric and
/// nowhere negative.
template <class T, int D, int N>
Mat<double, N> resistance_of_matter(const RigidState<T, D, N>& body, const Vec<T, N>& velocity, bool coupling,
                                    SumOver sum);

/// Whether some impulse would gain energy by the change of velocity that it makes. Components that cannot move
/// have rows of zeros.
template <int N>
bool gains_energy(const Mat<double, N>& mobility);

/// Whether what a balance leaves is the round-off of its impulses: the remainder is given to the body unless
/// it is, for it would give a very light body a large velocity. `exchanged`: sum of the impulses' magnitudes.
template <class T, class Number>
bool is_round_off(Number left, T exchanged, int units) {
  return !(left > static_cast<T>(units) * std::numeric_limits<T>::epsilon() * exchanged);
}

}  // namespace arenite::inline ARENITE_INSTRUCTION_SET::detail

#ifndef ARENITE_COLD_LIBRARY
#include <arenite/rigid/contact_balance_cold.hpp>
#endif
