// Strains of the points of linear simplices alone, for the orders that update the stress apart from G2P.
#pragma once
// SPDX-License-Identifier: BSD-3-Clause

#include <arenite/simd/kernel.hpp>
#include <arenite/transfer/simplex/g2p.hpp>

namespace arenite::inline ARENITE_INSTRUCTION_SET {
namespace simplex {

/// Strains of a run of points of a cell, of sym(dt sum u_i (grad w_i)^T), in axisymmetry with de_hoop = dt
/// sum w_i u_r,i / r_p, into `buffer`, that of point `origin` first.
template <class K, class N, class M, class Points, class Field, class T, class Average, class Buffer>
ARENITE_KERNEL void strain(const M& mesh, Index c, Points& points, std::size_t begin, std::size_t end,
                           const Field& nodes, T dt, const Average& average, Buffer& buffer,
                           std::size_t origin) {
  using Cell = typename N::Shape::template Cell<M>;
  constexpr int width = N::template width<T>;
  using P = lanes_of<T, width>;
  const Cell cell(mesh, c);
  const CellVectors<T, M::dimension, Cell::size> u(cell, nodes.strain_velocity());
  const auto of_cell = cell_step(cell, u, dt);
  for_each_pack<width>(points, begin, end, [&](const auto& p) {
    auto step = in_all_lanes<P>(of_cell);
    if constexpr (K::hoop) {
      const auto x = p.position();
      step.strain[2] = P(dt) * interpolate(cell.weights(x), u)[0] * reciprocal(x[0]);
    }
    step.strain = averaged<N>(step.strain, average, c);
    buffer.store(p.first - origin, step);
  });
}

}  // namespace simplex
}  // namespace arenite::inline ARENITE_INSTRUCTION_SET
