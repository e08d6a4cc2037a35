// MUSL mapping where the functions of a cell are products along the axes: by the points.
#pragma once
// SPDX-License-Identifier: BSD-3-Clause

#include <arenite/simd/kernel.hpp>
#include <arenite/transfer/product/g2p.hpp>
#include <arenite/transfer/product/hand_back.hpp>

namespace arenite::inline ARENITE_INSTRUCTION_SET {
namespace product {

/// Gives the points of a cell their new velocities, as their transfer takes them, and adds to `nodes.mapped`
///   m_p w_i v_p(x_i)
template <class N, class M, class B, class Field>
ARENITE_KERNEL void map_back(const N& numerics, const M& mesh, B& body, Index c, Field& nodes) {
  using T = typename M::scalar;
  using Cell = typename N::Shape::template Cell<M>;
  const Cell cell(mesh, c);
  const CellVectors<T, M::dimension, Cell::size> v(cell, nodes.velocity);
  const auto gather = numerics.transfer.gather(cell, nodes);
  const auto& gathered = value_or(gather.velocity, v);
  hand_back<N>(cell, body, c, nodes.mapped, [&](const auto& p, const auto& x, const auto& line) {
    keep_in_memory(gathered);
    return gather(cell, p, x, gathered_sums(gather, line, gathered));
  });
}

}  // namespace product
}  // namespace arenite::inline ARENITE_INSTRUCTION_SET
