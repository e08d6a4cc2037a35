// APIC: affine particle-in-cell.
#pragma once
// SPDX-License-Identifier: BSD-3-Clause

#include <arenite/transfer/velocity_field.hpp>

namespace arenite::inline ARENITE_INSTRUCTION_SET {

/// Affine particle-in-cell (Jiang et al. 2015, doi:10.1145/2766996): a point computes B = sum w v_i (x_i -
/// x_p)^T, carries C = B D^-1, D = sum w (x_i - x_p)(x_i - x_p)^T, and returns w (v_p + C (x_i - x_p)).
/// Conserves angular momentum to round-off if D is the same everywhere: not in the outermost cells of a grid.
struct Apic {
  static constexpr bool affine = true;
  static constexpr bool reads_start_state = false;
  /// D is singular for a point at a node of a linear simplex.
  template <class Shape>
  static constexpr bool fits = !Shape::constant_gradient;

  template <class Point>
  auto particle_field(const Point& p) const {
    return VelocityField{p.velocity(), p.velocity_gradient()};
  }

  /// The point keeps the quotient C = B D^-1 of B and D at one position x, not B: near a face D falls to
  /// zero, and B of the position before over D of the next would give huge velocities.
  struct Gathered {
    static constexpr bool needs_moments = true;
    Nothing velocity{};

    template <class Cell, class Point, class X, class Sums>
    auto operator()(const Cell& cell, const Point& p, const X& x, const Sums& sums) const {
      constexpr std::size_t D = Point::D;
      const auto inverse = cell.inverse_inertia(x);
      std::array<typename Point::P, D * D> c;
      for (std::size_t a = 0; a < D; ++a)
        for (std::size_t d = 0; d < D; ++d) c[a * D + d] = sums.moments()[a][d] * inverse[a];
      p.set_velocity_gradient(c);
      p.set_velocity(sums.value);
      return VelocityField{sums.value, c};
    }
  };
  template <class Cell, class Nodes>
  auto gather(const Cell&, const Nodes&) const {
    return Gathered{};
  }
};

}  // namespace arenite::inline ARENITE_INSTRUCTION_SET
