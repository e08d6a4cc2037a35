// FLIP and PIC.
#pragma once
// SPDX-License-Identifier: BSD-3-Clause

#include <cmath>
#include <limits>

#include <arenite/core/checked.hpp>
#include <arenite/transfer/node_field.hpp>
#include <arenite/transfer/velocity_field.hpp>

namespace arenite::inline ARENITE_INSTRUCTION_SET {

/// PIC and FLIP in any blend: v_p = fraction (v_p + sum w (v_i^new - v_i^old)) + (1 - fraction) sum w
/// v_i^new. FLIP (fraction 1; Brackbill and Ruppel 1986, doi:10.1016/0021-9991(86)90211-1) keeps energy and
/// noise, PIC (fraction 0; Harlow 1964) damps both, at a rate that grows with the number of steps. With a
/// time constant the fraction of a step dt is fraction exp(-dt / time), so that what points keep of
/// their own velocity decays in time, whatever the step.
struct Flip {
  static constexpr bool affine = false;
  struct FractionRule {
    static constexpr const char* name = "Flip.fraction";
    static constexpr const char* bounds = "must lie in [0, 1]";
    static bool holds(double fraction) { return fraction >= 0 && fraction <= 1; }
  };
  struct TimeRule {
    static constexpr const char* name = "Flip.time";
    static constexpr const char* bounds = "must be positive";
    static bool holds(double time) { return time > 0; }
  };
  Checked<FractionRule> fraction = 1.0;  ///< FLIP fraction, -, in [0, 1]; 0: PIC
  /// Time constant of the fraction, s, positive; infinite: the fraction is that of each step.
  Checked<TimeRule> time = std::numeric_limits<double>::infinity();
  template <class Shape>
  static constexpr bool fits = true;

  /// The transfer of a step dt, s.
  Flip in_step(double dt) const {
    if (std::isinf(double(time))) return *this;
    return {.fraction = fraction * std::exp(-dt / time), .time = time};
  }

  /// P2G with the point's velocity: momentum_i += m w_i v_p.
  template <class Point>
  auto particle_field(const Point& p) const {
    return VelocityField{p.velocity()};
  }

  /// Both are linear in the nodes' velocities: v_p = fraction v_p + sum w d with d_i = v_i^new - fraction
  /// v_i^old.
  template <class T, class Rows>
  struct Gathered {
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
  auto gather(const Cell& cell, const Nodes& nodes) const {
    using T = typename Cell::T;
    Gathered<T, CellVectors<T, Cell::D, Cell::size>> gathered;
    gathered.fraction = static_cast<T>(fraction);
    repeat<Cell::size>([&](std::size_t i) { gathered.velocity.set(i, increment_at(nodes, cell.nodes[i])); });
    return gathered;
  }
  /// d_i of one node, as a pack.
  template <class Nodes>
  auto increment_at(const Nodes& nodes, Index i) const {
    const auto v = nodes.velocity.pack(i);
    using V = std::remove_const_t<decltype(v)>;
    using T = std::remove_cvref_t<decltype(v[0])>;
    return V(v - V(static_cast<T>(fraction)) * nodes.start.pack(i));
  }
};

}  // namespace arenite::inline ARENITE_INSTRUCTION_SET
