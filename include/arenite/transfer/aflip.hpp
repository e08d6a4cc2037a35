// AFLIP: affine FLIP.
#pragma once
// SPDX-License-Identifier: BSD-3-Clause

#include <arenite/transfer/apic.hpp>
#include <arenite/transfer/flip.hpp>

namespace arenite::inline ARENITE_INSTRUCTION_SET {

/// Affine FLIP (Fei, Guo, Wu, Huang and Gao 2021, ACM Trans. Graph. 40(4)): the velocity of FLIP in any
/// blend, v_p = s (v_p + sum w (v_i^new - v_i^old)) + (1 - s) sum w v_i^new, and the velocity gradient of
/// APIC.
struct Aflip {
  static constexpr bool affine = true;
  Checked<Flip::FractionRule> fraction = 1.0;  ///< FLIP fraction s, -, in [0, 1]
  template <class Shape>
  static constexpr bool fits = Apic::fits<Shape>;

  template <class Point>
  auto particle_field(const Point& p) const {
    return VelocityField{p.velocity(), p.velocity_gradient()};
  }

  template <class T, class Rows>
  struct Gathered : Apic::Gathered {
    T fraction;
    Rows second;  ///< s v_i^old, m/s

    template <class Cell, class Point, class X, class Sums>
    auto operator()(const Cell& cell, const Point& p, const X& x, const Sums& sums) const {
      auto v = sums.value;
      const auto own = p.velocity();
      repeat<v.size()>([&](std::size_t d) { v[d] += typename Point::P(fraction) * own[d] - sums.second[d]; });
      const auto field = Apic::Gathered::operator()(cell, p, x, sums);
      p.set_velocity(v);
      return VelocityField{v, field.gradient};
    }
  };
  template <class Cell, class Nodes>
  auto gather(const Cell& cell, const Nodes& nodes) const {
    using T = typename Cell::T;
    Gathered<T, CellVectors<T, Cell::D, Cell::size>> gathered;
    gathered.fraction = static_cast<T>(fraction);
    repeat<Cell::size>([&](std::size_t i) {
      const auto v = nodes.start.pack(cell.nodes[i]);
      gathered.second.set(i, std::remove_const_t<decltype(v)>(gathered.fraction) * v);
    });
    return gathered;
  }
};

}  // namespace arenite::inline ARENITE_INSTRUCTION_SET
