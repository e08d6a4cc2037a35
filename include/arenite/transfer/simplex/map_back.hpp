// MUSL mapping on linear simplices, from sums of the cells instead of a pass over the points.
#pragma once
// SPDX-License-Identifier: BSD-3-Clause

#include <arenite/particles/cell_sums.hpp>
#include <arenite/simd/kernel.hpp>
#include <arenite/transfer/node_field.hpp>
#include <arenite/transfer/simplex/map_residual.hpp>

namespace arenite::inline ARENITE_INSTRUCTION_SET {
namespace simplex {

/// The nodes of a cell, without its functions.
template <class M>
struct CellNodes {
  using T = typename M::scalar;
  static constexpr int D = M::dimension, size = D + 1;
  const std::array<Index, static_cast<std::size_t>(size)>& nodes;
};

/// The new velocity of a point is linear in its transfer's node vectors d_j (FLIP: d_j = v_j - s v_j^old):
/// v_p = s v_p + sum_j w_j d_j. Mapped back, node i gets sum_p m w_i v_p = s m_i v_i^old + sum_j M_ij d_j
/// with the edge masses M_ij = sum_p m w_i w_j. Since sum_j M_ij = m_i, that is
///   m_i v_i + sum_j M_ij (d_j - d_i)
/// of which the second term, an exchange along each edge, is added to `nodes.mapped`. (A transfer with
/// s v_i^old + d_i other than v_i has `returned_velocity`.)
template <class N, class M, class B, class Field>
ARENITE_KERNEL void map_back(const N& numerics, const M& mesh, const B& body, Index c, Field& nodes) {
  using T = typename M::scalar;
  using V = NodePack<T, M::dimension>;
  using Cell = CellNodes<M>;
  const Cell cell{mesh.nodes(c)};
  const auto transfer = numerics.transfer;  // a copy: its parameters stay in registers
  std::array<V, Cell::size> d;
  if constexpr (requires { numerics.transfer.increment_at(nodes, c); }) {
    repeat<Cell::size>([&](std::size_t i) { d[i] = transfer.increment_at(nodes, cell.nodes[i]); });
  } else {
    const CellVectors<T, M::dimension, Cell::size> v(cell, nodes.velocity);
    const auto gather = transfer.gather(cell, nodes);
    repeat<Cell::size>([&](std::size_t i) { d[i] = value_or(gather.velocity, v).pack(i); });
  }
  diffuse_along_edges(cell.nodes, body.cell_sums[c].edge_mass, d, nodes.mapped);
}

}  // namespace simplex
}  // namespace arenite::inline ARENITE_INSTRUCTION_SET
