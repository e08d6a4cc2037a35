// Hold: how the mapped velocities of MUSL keep what contact enforced.
#pragma once

#include <arenite/core/tensor.hpp>

namespace arenite::inline ARENITE_INSTRUCTION_SET {

/// The part removed from a mapped relative velocity, m/s, and the dissipation of that beyond what the
/// exchange has booked, J.
template <class T, int D>
struct Held {
  Vec<T, D> removed;
  double dissipation;
};

/// Holds the mapped velocities of MUSL, from which strains are taken, to what contact enforced where it gave
/// an impulse: along the normal, or in all directions if the two stick. Both opening and closing are held: an
/// impulse does no work only if the strain velocities agree where it acts. Without the hold they part during
/// a rebound at nodes where contact still pushes, and the impulse times that velocity is energy from nothing.
/// The hold is no impulse: the mapped velocities serve one strain increment only. The points of FLIP gain
/// (impulse + dt force) (start + mapped) / 2 at each node, their strains take dt force times the held
/// velocity: with both, contact's share of the balance is exact, up to the order of the time step. `apart`:
/// the mapped relative velocity; `twice`: twice the mean velocity with which points take the impulse, less
/// that with which the exchange booked it; `force`: the force between the two, N.
template <class T, int D>
Held<T, D> hold(const Vec<T, D>& apart, const Vec<T, D>& twice, const Vec<T, D>& normal, bool sticks,
                const Vec<T, D>& impulse, const Vec<T, D>& force, T dt) {
  const Vec<T, D> removed = sticks ? apart : Vec<T, D>(apart.dot(normal) * normal);
  return {removed, -static_cast<double>(impulse.dot(twice) / 2 + dt * force.dot(removed))};
}

}  // namespace arenite::inline ARENITE_INSTRUCTION_SET
