// Strains of points where the functions of a cell are products along the axes.
#pragma once
// SPDX-License-Identifier: BSD-3-Clause

#include <arenite/simd/kernel.hpp>
#include <arenite/transfer/node_field.hpp>
#include <arenite/transfer/numerics.hpp>
#include <arenite/transfer/product/lines.hpp>
#include <arenite/transfer/strain.hpp>

namespace arenite::inline ARENITE_INSTRUCTION_SET {
namespace product {

/// Strain steps of the points of a cell: see `arenite::CellStrain`.
template <class K, class N, class M, class Cell = typename N::Shape::template Cell<M>>
struct CellStrain {
  using T = typename M::scalar;
  static constexpr int width = cell_width<M::dimension, N::template width<T>>;
  const Cell cell;
  const Differences<Cell> u;
  const T dt;

  template <class Field>
  CellStrain(const M& mesh, Index c, const Field& nodes, T step) : CellStrain(Cell(mesh, c), nodes, step) {}
  template <class Field>
  CellStrain(const Cell& of, const Field& nodes, T step)
      : cell(of), u(cell, nodes.strain_velocity()), dt{step} {}

  template <class Points>
  auto operator()(const PointPack<Points, width>& p) const {
    const auto x = p.position();
    const Lines<lanes_of<T, width>, Cell> line(cell, x);
    reload_from_memory(u);
    const auto sums = line.sum(u, line.slope);
    return strain_step_of<K, N::squares>(sums.by_axis[0], sums.value, x, dt);
  }
};

}  // namespace product
}  // namespace arenite::inline ARENITE_INSTRUCTION_SET
