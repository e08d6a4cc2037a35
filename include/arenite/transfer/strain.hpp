// Strain of a step from velocities, and the motion of the points: pieces that G2P of all families shares.
#pragma once
// SPDX-License-Identifier: BSD-3-Clause

#include <arenite/law/law.hpp>
#include <arenite/transfer/point_pack.hpp>

namespace arenite::inline ARENITE_INSTRUCTION_SET {

/// The columns of G + squares / 2 G^2, from those of G [D x D] (`MidpointStrain`).
template <int squares, class P, std::size_t D, class Columns>
std::array<std::array<P, D>, D> with_half_square(const Columns& columns) {
  std::array<std::array<P, D>, D> g{}, sum{};
  repeat<D>([&](std::size_t column) {
    const auto given = columns(column);
    repeat<D>([&](std::size_t row) { g[column][row] = given[row]; });
  });
  const P half(0.5 * squares);
  repeat<D>([&](std::size_t column) {
    repeat<D>([&](std::size_t row) {
      P square = g[0][row] * g[column][0];
      repeat<D - 1>([&](std::size_t k) { square += g[k + 1][row] * g[column][k + 1]; });
      sum[column][row] = g[column][row] + half * square;
    });
  });
  return sum;
}

/// Strain and spin of one step from the velocity gradient times dt, whose columns are `derivative(j)`[i] =
/// dv_i/dx_j dt; no strain out of the plane. `squares`: see `Numerics`.
template <class P, int D, int squares = 0, class Columns>
StrainStep<P, D> strain_step_of(Columns&& derivative) {
  if constexpr (squares != 0) {
    const auto whole = with_half_square<squares, P, static_cast<std::size_t>(D)>(derivative);
    return strain_step_of<P, D>([&](std::size_t b) -> const auto& { return whole[b]; });
  }
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
template <class K, int squares = 0, class P, int D, class Vector, class T>
void set_hoop_strain(StrainStep<P, D>& step, const Vector& v, const Vector& x, T dt) {
  if constexpr (K::hoop) {
    step.strain[2] = P(dt) * v[0] * reciprocal(x[0]);
    if constexpr (squares != 0) step.strain[2] += P(0.5 * squares) * step.strain[2] * step.strain[2];
  }
}

/// Strain and spin of a step dt, s, of points at x [D], m, where the velocity that strains is v [D], m/s, and
/// its gradient has the columns `gradient` [D][D], 1/s.
template <class K, int squares = 0, class P, std::size_t D, class T>
StrainStep<P, static_cast<int>(D)> strain_step_of(const std::array<std::array<P, D>, D>& gradient,
                                                  const std::array<P, D>& v, const std::array<P, D>& x,
                                                  T dt) {
  auto step = strain_step_of<P, static_cast<int>(D), squares>([&](std::size_t b) {
    auto column = gradient[b];
    for (P& component : column) component = component * P(dt);
    return column;
  });
  set_hoop_strain<K, squares>(step, v, x, dt);
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
