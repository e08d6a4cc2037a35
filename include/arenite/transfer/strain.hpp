// Strain of a step from velocities, and the motion of the points: pieces that G2P of all families shares.
#pragma once
// SPDX-License-Identifier: BSD-3-Clause

#include <arenite/law/law.hpp>
#include <arenite/transfer/point_pack.hpp>

namespace arenite::inline ARENITE_INSTRUCTION_SET {

/// Strain and spin of one step from the velocity gradient times dt, whose columns are `derivative(j)`[i] =
/// dv_i/dx_j dt; no strain out of the plane.
template <class P, int D, class Columns>
StrainStep<P, D> strain_step_of(Columns&& derivative) {
  StrainStep<P, D> step;
  auto& e = step.strain;
  const P half(0.5);
  const auto x = derivative(0), y = derivative(1);
  e[0] = x[0];
  e[1] = y[1];
  e[3] = (y[0] + x[1]) * half;
  step.spin[0] = (y[0] - x[1]) * half;
  if constexpr (D == 3) {
    const auto z = derivative(2);
    e[2] = z[2];
    e[4] = (z[1] + y[2]) * half;
    e[5] = (x[2] + z[0]) * half;
    step.spin[1] = (z[1] - y[2]) * half;
    step.spin[2] = (x[2] - z[0]) * half;
  } else {
    e[2] = P(0);
  }
  return step;
}

/// The hoop strain of axisymmetry, dt v_r / r, of points at x [D], m, with the velocity v [D], m/s.
template <class K, class P, int D, class Vector, class T>
void set_hoop_strain(StrainStep<P, D>& step, const Vector& v, const Vector& x, T dt) {
  if constexpr (K::hoop) step.strain[2] = P(dt) * v[0] * reciprocal(x[0]);
}

/// Strain and spin of a step dt, s, of points at x [D], m, where the velocity that strains is v [D], m/s, and
/// its gradient has the columns `gradient` [D][D], 1/s.
template <class K, class P, std::size_t D, class T>
StrainStep<P, static_cast<int>(D)> strain_step_of(const std::array<std::array<P, D>, D>& gradient,
                                                  const std::array<P, D>& v, const std::array<P, D>& x,
                                                  T dt) {
  auto step = strain_step_of<P, static_cast<int>(D)>([&](std::size_t b) {
    auto column = gradient[b];
    for (P& component : column) component = component * P(dt);
    return column;
  });
  set_hoop_strain<K>(step, v, x, dt);
  return step;
}

/// A strain step that is one for all lanes of P.
template <class P, class T, int D>
StrainStep<P, D> in_all_lanes(const StrainStep<T, D>& one) {
  StrainStep<P, D> step;
  repeat<Sym<T, D>::size>([&](std::size_t k) { step.strain[k] = P(one.strain[k]); });
  repeat<step.spin.size()>([&](std::size_t k) { step.spin[k] = P(one.spin[k]); });
  return step;
}

/// Gives a strain step what its cell c makes of the strain, where there is an average. In place: by value
/// this took 7 to 18 % of a whole step.
template <class P, int D, class Average>
void apply_average(StrainStep<P, D>& step, [[maybe_unused]] const Average& average,
                   [[maybe_unused]] Index c) {
  if constexpr (!std::same_as<Average, Nothing>) step.strain = average.average(step.strain, c);
}

/// Moves a pack of points from x by dt times the velocity v. Returns the sums of their new coordinates,
/// finite as long as these are.
template <class Pack, class P, std::size_t D, class T>
P move_points(const Pack& p, std::array<P, D> x, const std::array<P, D>& v, T dt) {
  repeat<D>([&](std::size_t d) { x[d] += P(dt) * v[d]; });
  p.set_position(x);
  P sum = x[0] + x[1];
  if constexpr (D == 3) sum += x[2];
  return select(lanes_from<P>(p.count), P(0), sum);
}

}  // namespace arenite::inline ARENITE_INSTRUCTION_SET
