// Hold: contact constraints on the mapped velocities of MUSL.
#pragma once
// SPDX-License-Identifier: BSD-3-Clause

#include <type_traits>

#include <arenite/core/tensor.hpp>

namespace arenite::inline ARENITE_INSTRUCTION_SET {

/// The part removed from a mapped relative velocity, m/s, and the energy that this dissipates, J.
template <class T, int D>
struct Held {
  Vec<T, D> removed;
  double dissipation;
};

/// Constrains the mapped velocities of MUSL, from which strains are computed, as contact does where it gave
/// an impulse: along the normal, or in all directions if the two stick. Both opening and closing are
/// removed: an impulse does no work only if the strain velocities agree where it acts. Otherwise they
/// differ during a rebound at nodes where contact still pushes, and the impulse times that difference is
/// spurious energy. The constraint is no impulse: the mapped velocities serve one strain increment only.
/// FLIP points gain (impulse + dt force) (start + mapped) / 2 at each node, their strains absorb dt force
/// times the constrained velocity: the difference is dissipated; the impulse is counted apart
/// (`rest_of_dissipation`).
/// `apart`: the mapped relative velocity; `force`: the force between the two, N.
template <class T, int D>
Held<T, D> hold(const Vec<T, D>& apart, const Vec<T, D>& normal, bool sticks, const Vec<T, D>& force, T dt) {
  const Vec<T, D> removed = sticks ? apart : Vec<T, D>(apart.dot(normal) * normal);
  return {removed, -static_cast<double>(dt * force.dot(removed))};
}

/// Constrains the mapped velocities of MUSL at nodes touched by a rigid body or a wall (see `hold`); a
/// touched node has `field`, `node`, the unit `normal`, the `impulse`, N s, and whether it `sticks`. Returns
/// the energy that this dissipates, J.
template <class Touched, class Fields, class T>
double hold_touched(const Touched& touched, Fields& fields, T dt) {
  double dissipation = 0;
  for (const auto& t : touched) {
    if (t.impulse.squaredNorm() == 0) continue;
    using V = std::remove_cvref_t<decltype(t.normal)>;
    auto& field = fields[t.field];
    auto& v = field.mapped[t.node];
    const auto held = hold<T, V::RowsAtCompileTime>(v - field.velocity[t.node], t.normal, t.sticks,
                                                    field.sums[t.node].force(), dt);
    dissipation += held.dissipation;
    v -= held.removed;
  }
  return dissipation;
}

/// Contact computes its dissipation with the velocities right after it. Walls, later contacts at the same node and
/// MUSL change them. Returns the correction, J, with the mean velocities of the step (`mean_velocity`).
template <class Touched, class Fields>
double rest_of_dissipation(const Touched& touched, const Fields& fields) {
  double dissipation = 0;
  for (const auto& t : touched) {
    if (t.impulse.squaredNorm() == 0) continue;
    const auto& field = fields[t.field];
    auto off = field.mean_velocity(t.node);
    for (int k = 0; k < off.size(); ++k) off[k] -= (field.start[t.node][k] + t.after[k]) / 2;
    dissipation -= static_cast<double>(t.impulse.dot(off));
  }
  return dissipation;
}

}  // namespace arenite::inline ARENITE_INSTRUCTION_SET
