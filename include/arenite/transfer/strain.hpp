// Strain of a step from velocities, and the motion of the points: pieces that G2P of all families shares.
#pragma once
// SPDX-License-Identifier: BSD-3-Clause

#include <arenite/law/law.hpp>
#include <arenite/transfer/point_pack.hpp>
#include <arenite/transfer/volumetric_average.hpp>

namespace arenite::inline ARENITE_INSTRUCTION_SET {

/// Strain and spin of one step from the velocity gradient times dt, whose columns are `derivative(j)`[i] =
/// dv_i/dx_j dt; no strain out of plane.
template <class P, std::size_t D, class Columns>
StrainStep<P, static_cast<int>(D)> in_plane_step(Columns&& derivative) {
  StrainStep<P, static_cast<int>(D)> step;
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

/// The same for all lanes of P.
template <class P, class T, int D>
StrainStep<P, D> in_all_lanes(const StrainStep<T, D>& one) {
  StrainStep<P, D> step;
  repeat<Sym<T, D>::size>([&](std::size_t k) { step.strain[k] = P(one.strain[k]); });
  repeat<step.spin.size()>([&](std::size_t k) { step.spin[k] = P(one.spin[k]); });
  return step;
}

/// A strain with the trace of its cell's average in place of its own, where the numerics average.
template <class N, class P, int D, class Average>
Sym<P, D> averaged(const Sym<P, D>& strain, const Average& average, Index c) {
  if constexpr (N::AntiLocking::averages_strain)
    return add_isotropic(strain, P((P(average.cell_strain[c]) - trace(strain)) * P(1.0 / 3)));
  else
    return strain;
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
