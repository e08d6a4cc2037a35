// FLIP and PIC.
#pragma once

#include <arenite/core/checked.hpp>
#include <arenite/transfer/node_field.hpp>
#include <arenite/transfer/velocity_field.hpp>

namespace arenite::inline ARENITE_INSTRUCTION_SET {

/// PIC and FLIP in any blend: v_p = fraction (v_p + sum w (v_i^new - v_i^old)) + (1 - fraction) sum w
/// v_i^new. FLIP (fraction 1; Brackbill and Ruppel 1986, doi:10.1016/0021-9991(86)90211-1) keeps energy and
/// noise, PIC (fraction 0; Harlow 1964) damps both, at a rate that grows with the number of steps.
struct Flip {
  static constexpr bool affine = false;
  struct FractionRule {
    static constexpr const char* name = "Flip.fraction";
    static constexpr const char* bounds = "must lie in [0, 1]";
    static bool holds(double fraction) { return fraction >= 0 && fraction <= 1; }
  };
  Checked<FractionRule> fraction = 1.0;  ///< FLIP fraction, 0 to 1
  template <class Shape>
  static constexpr bool fits = true;

  /// A point hands over its velocity: momentum_i += m w_i v_p.
  template <class Point>
  auto hand(const Point& p) const {
    return VelocityField{p.velocity()};
  }

  /// Both are linear in the nodes' velocities: v_p = fraction v_p + sum w d with d_i = v_i^new - fraction
  /// v_i^old.
  template <class T, class Rows>
  struct Taken {
    static constexpr bool needs_moments = false;
    T fraction;
    Rows velocity;  ///< d_i, m/s

    template <class Cell, class Point, class X, class Sums>
    auto operator()(const Cell&, const Point& p, const X&, const Sums& sums) const {
      auto v = sums.value;
      const auto own = p.velocity();
      repeat<v.size()>([&](std::size_t d) { v[d] += typename Point::P(fraction) * own[d]; });
      p.set_velocity(v);
      return VelocityField{v};
    }
  };
  template <class Cell, class Nodes>
  auto take(const Cell& cell, const Nodes& nodes) const {
    using T = typename Cell::T;
    using V = NodePack<T, Cell::D>;
    Taken<T, NodeRows<T, Cell::D, Cell::size>> taken;
    taken.fraction = static_cast<T>(fraction);
    const V kept(taken.fraction);
    repeat<Cell::size>([&](std::size_t i) {
      taken.velocity.set(i, nodes.velocity.pack(cell.nodes[i]) - kept * nodes.start.pack(cell.nodes[i]));
    });
    return taken;
  }
};

}  // namespace arenite::inline ARENITE_INSTRUCTION_SET
