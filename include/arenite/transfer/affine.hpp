// Affine part of a point's velocity field: the gradient that APIC and TPIC take from the nodes, and hand back
// to them beside the point's own velocity.
#pragma once

#include <arenite/core/lanes.hpp>
#include <arenite/transfer/transfer.hpp>

namespace arenite::inline ARENITE_INSTRUCTION_SET {

/// Velocity gradient B D^-1 of APIC [D x D], column by column, 1/s, from the columns of B = sum w v (x_i -
/// x)^T, m2/s, both taken at x. The point keeps the quotient, not B: near a face D falls to nothing, and the
/// B of the place that it came from, over the D of the place where it is, would make of any velocity a huge
/// one.
template <class Cell, class P, std::size_t D>
std::array<P, D * D> apic_gradient(const Cell& cell, const std::array<std::array<P, D>, D>& b,
                                   const std::array<P, D>& x) {
  const auto inverse = cell.inverse_inertia(x);
  std::array<P, D * D> motion;
  for (std::size_t a = 0; a < D; ++a)
    for (std::size_t d = 0; d < D; ++d) motion[a * D + d] = b[a][d] * inverse[a];
  return motion;
}

/// Velocity gradient L = sum v (grad w)^T of TPIC [D x D], column by column, 1/s.
template <class P, std::size_t D, class Cell, class Rows>
std::array<P, D * D> taken_gradient(const Cell& cell, const Rows& velocity) {
  std::array<P, D * D> motion;
  for (std::size_t a = 0; a < D; ++a)
    for (std::size_t d = 0; d < D; ++d) {
      auto sum = velocity[0][d] * cell.gradient(static_cast<int>(a), 0);
      for (std::size_t i = 1; i < Cell::size; ++i)
        sum += velocity[i][d] * cell.gradient(static_cast<int>(a), static_cast<int>(i));
      motion[a * D + d] = P(sum);
    }
  return motion;
}

}  // namespace arenite::inline ARENITE_INSTRUCTION_SET
