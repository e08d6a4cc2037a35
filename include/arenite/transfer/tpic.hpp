// TPIC: Taylor particle-in-cell.
#pragma once
// SPDX-License-Identifier: BSD-3-Clause

#include <arenite/transfer/node_field.hpp>
#include <arenite/transfer/velocity_field.hpp>

namespace arenite::inline ARENITE_INSTRUCTION_SET {

/// Taylor particle-in-cell: a point carries the velocity gradient L and returns w (v_p + L (x_i - x_p))
/// (Wallstedt and Guilkey 2007, doi:10.1016/j.jcp.2007.08.023, their velocity projection). No inertia tensor
/// to invert.
struct Tpic {
  static constexpr bool affine = true;
  static constexpr bool reads_start_state = false;
  template <class Shape>
  static constexpr bool fits = Shape::constant_gradient;
  /// sum w_j v_j + L (x_i - x_p) is v_i wherever the point lies in a linear simplex.
  template <class Shape>
  static constexpr bool returns_unchanged = Shape::constant_gradient;

  template <class Point>
  auto particle_field(const Point& p) const {
    return VelocityField{p.velocity(), p.velocity_gradient()};
  }

  template <class T, std::size_t D>
  struct Gathered {
    static constexpr bool needs_moments = false;
    std::array<T, D * D> gradient;  ///< L = sum v_i (grad w_i)^T, column by column, 1/s
    Nothing velocity{};

    template <class Cell, class Point, class X, class Sums>
    auto operator()(const Cell&, const Point& p, const X&, const Sums& sums) const {
      std::array<typename Point::P, D * D> l;
      repeat<D * D>([&](std::size_t k) { l[k] = typename Point::P(gradient[k]); });
      p.set_velocity_gradient(l);
      p.set_velocity(sums.value);
      return VelocityField{sums.value, l};
    }
  };
  template <class Cell, class Nodes>
  auto gather(const Cell& cell, const Nodes& nodes) const {
    using T = typename Cell::T;
    constexpr std::size_t D = Cell::D;
    Gathered<T, D> gathered;
    repeat<D>([&](std::size_t a) {
      const auto part = [&](std::size_t i) {
        return nodes.velocity.pack(cell.nodes[i]) *
               NodePack<T, Cell::D>(cell.gradient(static_cast<int>(a), static_cast<int>(i)));
      };
      auto column = part(0);
      repeat<Cell::size - 1>([&](std::size_t i) { column += part(i + 1); });
      repeat<D>([&](std::size_t d) { gathered.gradient[a * D + d] = column[static_cast<int>(d)]; });
    });
    return gathered;
  }
};

}  // namespace arenite::inline ARENITE_INSTRUCTION_SET
