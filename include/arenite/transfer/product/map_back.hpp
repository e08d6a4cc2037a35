// MUSL mapping where the functions of a cell are products along the axes: by the points.
#pragma once
// SPDX-License-Identifier: BSD-3-Clause

#include <arenite/simd/kernel.hpp>
#include <arenite/transfer/product/g2p.hpp>
#include <arenite/transfer/product/scatter_momentum.hpp>

namespace arenite::inline ARENITE_INSTRUCTION_SET {
namespace product {

/// Gives the points of a cell their new velocities, as their transfer gives them, and adds to `nodes.mapped`
///   m_p w_i v_p(x_i)
template <class N, class M, class B, class Field>
ARENITE_KERNEL void map_back(const N& numerics, const M& mesh, B& body, Index c, Field& nodes) {
  N::Shape::visit_cell(mesh, c, [&]<class Cell>(const Cell& cell) ARENITE_INLINE {
    using Gather = decltype(numerics.transfer.gather(cell, nodes));
    const Gather gather = numerics.transfer.gather(cell, nodes);
    const TransferVectors<Cell, Gather> taken(cell, nodes, gather);
    scatter_momentum<N>(cell, body, c, nodes.mapped,
                        [&](const auto& p, const auto& x, const auto& line)
                            ARENITE_INLINE { return gather(cell, p, x, taken.sums(line)); });
  });
}

}  // namespace product
}  // namespace arenite::inline ARENITE_INSTRUCTION_SET
