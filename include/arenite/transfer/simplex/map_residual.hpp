// Node residual mapped to the points and back on linear simplices, from the edge masses of the cells instead of a pass over the points.
#pragma once
// SPDX-License-Identifier: BSD-3-Clause

#include <arenite/particles/cell_sums.hpp>
#include <arenite/simd/kernel.hpp>
#include <arenite/transfer/node_field.hpp>

namespace arenite::inline ARENITE_INSTRUCTION_SET {
namespace simplex {

/// Exchange of the vectors r_j [nodes of the cell] along the edges of a cell, with the edge masses
/// M_ij = sum_p m w_i w_j. Adds to `to` at node i:
///   sum_j M_ij (r_j - r_i)
template <std::size_t Size, class V, class EdgeMass, class Vectors>
void diffuse_along_edges(const std::array<Index, Size>& nodes, const EdgeMass& edge_mass,
                         const std::array<V, Size>& r, Vectors& to) {
  std::array<V, Size> gain;
  repeat<Size>([&](std::size_t i) { gain[i] = V(0); });
  for_each_edge<Size>([&](std::size_t e, std::size_t i, std::size_t j) {
    const V exchanged = V(edge_mass[e]) * (r[j] - r[i]);
    gain[i] += exchanged;
    gain[j] -= exchanged;
  });
  repeat<Size>([&](std::size_t i) { to.add(nodes[i], gain[i]); });
}

/// Adds to `nodes.mapped_residual` the vectors r_i in `nodes.residual` mapped to a cell's points and back,
/// minus m_i r_i: since sum_j M_ij = m_i, an exchange along the edges.
template <class M, class B, class Field>
ARENITE_KERNEL void map_residual(const M& mesh, const B& body, Index c, Field& nodes) {
  constexpr std::size_t size = static_cast<std::size_t>(M::dimension) + 1;
  std::array<NodePack<typename M::scalar, M::dimension>, size> r;
  const auto& of_cell = mesh.nodes(c);
  repeat<size>([&](std::size_t i) { r[i] = nodes.residual.pack(of_cell[i]); });
  diffuse_along_edges(of_cell, body.cell_sums[c].edge_mass, r, nodes.mapped_residual);
}

}  // namespace simplex
}  // namespace arenite::inline ARENITE_INSTRUCTION_SET
