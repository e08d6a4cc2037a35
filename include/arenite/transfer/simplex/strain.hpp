// Strains of points of linear simplices: one for all points of a cell, but for the hoop strain.
#pragma once
// SPDX-License-Identifier: BSD-3-Clause

#include <arenite/simd/kernel.hpp>
#include <arenite/transfer/node_field.hpp>
#include <arenite/transfer/numerics.hpp>
#include <arenite/transfer/strain.hpp>

namespace arenite::inline ARENITE_INSTRUCTION_SET {
namespace simplex {

/// sum w_i v_i over the nodes, from their vectors in rows.
template <class P, std::size_t Size, class Rows>
auto interpolate(const std::array<P, Size>& w, const Rows& rows) {
  std::array<P, Rows::dimension> v{};
  repeat<Size>(
      [&](std::size_t i) { repeat<Rows::dimension>([&](std::size_t d) { v[d] += w[i] * P(rows[i][d]); }); });
  return v;
}

/// Strain of a whole cell in a step: that of dt sum u_i (grad w_i)^T.
template <int squares = 0, class Cell, class Rows, class T = typename Cell::T>
StrainStep<T, Cell::D> cell_step(const Cell& cell, const Rows& u, T dt) {
  return strain_step_of<T, Cell::D, squares>([&](std::size_t b) {
    using V = NodePack<T, Cell::D>;
    V column(0);
    repeat<Cell::size>([&](std::size_t i) {
      column += u.pack(i) * V(dt * cell.gradient(static_cast<int>(b), static_cast<int>(i)));
    });
    std::array<T, V::width> lane;
    column.store(lane.data());
    return lane;
  });
}

/// Strain steps of the points of a cell: see `arenite::CellStrain`.
template <class K, class N, class M>
struct CellStrain {
  using T = typename M::scalar;
  using Cell = typename N::Shape::template Cell<M>;
  static constexpr int width = N::template width<T>;
  const Cell cell;
  const CellVectors<T, M::dimension, Cell::size> u;
  const T dt;
  const StrainStep<T, M::dimension> of_cell;

  template <class Field>
  CellStrain(const M& mesh, Index c, const Field& nodes, T step)
      : cell(mesh, c),
        u(cell, nodes.strain_velocity()),
        dt{step},
        of_cell(cell_step<N::squares>(cell, u, dt)) {}

  template <class Points>
  auto operator()(const PointPack<Points, width>& p) const {
    auto step = in_all_lanes<lanes_of<T, width>>(of_cell);
    if constexpr (K::hoop) {
      const auto x = p.position();
      set_hoop_strain<K, N::squares>(step, interpolate(cell.weights(x), u), x, dt);
    }
    return step;
  }
};

}  // namespace simplex
}  // namespace arenite::inline ARENITE_INSTRUCTION_SET
