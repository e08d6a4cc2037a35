// Node residual mapped to the points and back where the functions of a cell are products along the axes: by the points.
#pragma once
// SPDX-License-Identifier: BSD-3-Clause

#include <arenite/simd/kernel.hpp>
#include <arenite/transfer/product/scatter_momentum.hpp>

namespace arenite::inline ARENITE_INSTRUCTION_SET {
namespace product {

/// Adds to `nodes.mapped_residual` the vectors r_i in `nodes.residual` mapped to a cell's points and back:
///   m_p w_i sum_j w_j r_j
template <class N, class M, class B, class Field>
ARENITE_KERNEL void map_residual(const M& mesh, const B& body, Index c, Field& nodes) {
  N::Shape::visit_cell(mesh, c, [&]<class Cell>(const Cell& cell) ARENITE_INLINE {
    const Differences<Cell> residual(cell, nodes.residual);
    scatter_momentum<N>(cell, body, c, nodes.mapped_residual,
                        [&](const auto&, const auto&, const auto& line) {
                          reload_from_memory(residual);
                          return VelocityField{line.sum(residual).value};
                        });
  });
}

}  // namespace product
}  // namespace arenite::inline ARENITE_INSTRUCTION_SET
