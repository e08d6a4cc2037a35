// Affine part of a point's velocity field: what APIC and TPIC hand to the nodes beside the point's own
// velocity, and the gradient that TPIC takes from them.
#pragma once

#include <arenite/core/lanes.hpp>
#include <arenite/transfer/transfer.hpp>

namespace arenite::inline ARENITE_INSTRUCTION_SET {

/// Velocity gradient [D x D], column by column, 1/s, that a point at x hands to the nodes: B D^-1 for APIC, L
/// for TPIC.
template <class Transfer, class Cell, class P, std::size_t D>
std::array<P, D * D> handed_gradient(const Cell& cell, std::array<P, D * D> motion,
                                     const std::array<P, D>& x) {
  if constexpr (std::same_as<Transfer, Apic>) {
    const auto inverse = cell.inverse_inertia(x);
    for (std::size_t a = 0; a < D; ++a)
      for (std::size_t d = 0; d < D; ++d) motion[a * D + d] = motion[a * D + d] * inverse[a];
  }
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
