// Strains of the points alone, for the orders that update the stress apart from G2P, where the functions of a
// cell are products along the axes.
#pragma once
// SPDX-License-Identifier: BSD-3-Clause

#include <arenite/simd/kernel.hpp>
#include <arenite/transfer/product/g2p.hpp>

namespace arenite::inline ARENITE_INSTRUCTION_SET {
namespace product {

/// Strains of a run of points of a cell, of sym(dt sum u_i (grad w_i)^T), in axisymmetry with de_hoop = dt
/// sum w_i u_r,i / r_p, into `buffer`, that of point `origin` first.
template <class K, class N, class M, class Points, class Field, class T, class Buffer>
ARENITE_KERNEL void strain(const M& mesh, Index c, Points& points, std::size_t begin, std::size_t end,
                           const Field& nodes, T dt, Buffer& buffer, std::size_t origin) {
  using Cell = typename N::Shape::template Cell<M>;
  constexpr int width = cell_width<M::dimension, N::template width<T>>;
  using P = lanes_of<T, width>;
  const Cell cell(mesh, c);
  const CellVectors<T, M::dimension, Cell::size> u(cell, nodes.strain_velocity());
  for_each_pack<width>(points, begin, end, [&](const auto& p) {
    const auto x = p.position();
    const Lines<P, Cell> line(cell, x);
    keep_in_memory(u);
    const auto sums = line.sum(u, line.slope);
    auto step = in_plane_step<P, M::dimension>([&](std::size_t b) {
      auto column = sums.by_axis[0][b];
      for (P& component : column) component = component * P(dt);
      return column;
    });
    if constexpr (K::hoop) step.strain[2] = P(dt) * sums.value[0] * reciprocal(x[0]);
    buffer.store(p.first - origin, step);
  });
}

}  // namespace product
}  // namespace arenite::inline ARENITE_INSTRUCTION_SET
