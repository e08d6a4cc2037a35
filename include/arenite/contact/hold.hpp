// Hold: how the mapped velocities of MUSL keep what contact enforced.
#pragma once

#include <arenite/core/tensor.hpp>

namespace arenite::inline ARENITE_INSTRUCTION_SET {

/// What is taken from a mapped relative velocity, m/s, and what that dissipates beside what the exchange
/// booked, J.
template <class T, int D>
struct Held {
  Vec<T, D> removed;
  double dissipation;
};

/// Holds the mapped velocities of MUSL, from which strains are taken, to what contact enforced where it gave
/// an impulse: along the normal, or altogether if the two stick. In both directions: an impulse does no work
/// only if the strain velocities agree where it acts. Left as they are mapped they part during a rebound at
/// nodes where contact still pushes, and the impulse times that velocity is energy that nothing put in. No
/// impulse: these velocities live for one strain increment. The points of FLIP gain (impulse + dt force)
/// (start + mapped) / 2 at each node, their strains take dt force times the held velocity: with both,
/// contact's share of the balance is exact, up to the order of the time step. `apart`: the mapped relative
/// velocity; `twice`: twice the mean velocity with which points take the impulse, less that with which the
/// exchange booked it; `force`: the force between the two, N.
template <class T, int D>
Held<T, D> hold(const Vec<T, D>& apart, const Vec<T, D>& twice, const Vec<T, D>& normal, bool sticks,
                const Vec<T, D>& impulse, const Vec<T, D>& force, T dt) {
  const Vec<T, D> removed = sticks ? apart : Vec<T, D>(apart.dot(normal) * normal);
  return {removed, -static_cast<double>(impulse.dot(twice) / 2 + dt * force.dot(removed))};
}

}  // namespace arenite::inline ARENITE_INSTRUCTION_SET
