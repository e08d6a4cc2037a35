// Hold: how the mapped velocities of MUSL keep what contact enforced.
#pragma once

#include <type_traits>

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

/// Holds the mapped velocities of MUSL to what nodes were given by a rigid body or a wall (see `hold`); a
/// touched node has `field`, `node`, the unit `normal`, the `impulse`, N s, and whether it `sticks`. Returns
/// the energy that this dissipates, J. `Centred`: what is mapped is the mean over the step already.
template <bool Centred, class Touched, class Fields, class T>
double hold_touched(const Touched& touched, Fields& fields, T dt) {
  double dissipation = 0;
  for (const auto& t : touched) {
    if (t.impulse.squaredNorm() == 0) continue;
    using V = std::remove_cvref_t<decltype(t.normal)>;
    auto& field = fields[t.field];
    auto& v = field.mapped[t.node];
    const V apart = v - field.velocity[t.node];
    V twice = apart;
    if constexpr (Centred) twice += v - field.start[t.node];
    const auto held = hold<T, V::RowsAtCompileTime>(apart, twice, t.normal, t.sticks, t.impulse,
                                                    field.collected[t.node].force(), dt);
    dissipation += held.dissipation;
    v -= held.removed;
  }
  return dissipation;
}

}  // namespace arenite::inline ARENITE_INSTRUCTION_SET
