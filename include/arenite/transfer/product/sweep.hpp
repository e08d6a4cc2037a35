// Node sweep where the functions of a cell are products along the axes: by the points.
#pragma once

#include <arenite/transfer/node_field.hpp>
#include <arenite/transfer/numerics.hpp>
#include <arenite/transfer/point_pack.hpp>
#include <arenite/transfer/product/lines.hpp>
#include <arenite/transfer/product/rows.hpp>

namespace arenite::inline ARENITE_INSTRUCTION_SET {
namespace product {

/// Adds to `nodes.given` what the points of a cell hand back of the vectors r_i in `nodes.residual`:
///   m_p w_i sum_j w_j r_j
template <class N, class M, class B, class Field>
[[gnu::flatten]] void sweep(const M& mesh, const B& body, Index c, Field& nodes) {
  using T = typename M::scalar;
  using Cell = typename N::Shape::template Cell<M>;
  using Momentum = NodeLanes<ChannelList<Channel<node_channel::Momentum, M::dimension>>, ChannelList<>>;
  using Sums = Rows<Cell, Momentum, N::template width<T>>;
  const Cell cell(mesh, c);
  const NodeRows<T, M::dimension, Cell::size> residual(cell, nodes.residual);
  Sums rows;
  const auto spread = [&] {
    rows.spread([&](std::size_t i, std::size_t lane, const auto& sum) {
      nodes.given.add(cell.nodes[i], node_pack<T, M::dimension>(lane, sum));
    });
  };
  std::size_t left = body.cells[c].size();
  for_each_pack<Sums::width>(body.cells, c, body.points, [&](const auto& p) {
    const Lines<typename Sums::P, Cell> line(cell, p.position());
    keep_in_memory(residual);
    typename Sums::Handed handed;
    handed.momentum(p.mass(), VelocityField{line.sum(residual).value});
    rows.push(p.count, handed, line);
    left -= static_cast<std::size_t>(p.count);  // one call of `spread`, as in P2G
    if (rows.full() || left == 0) spread();
  });
}

}  // namespace product
}  // namespace arenite::inline ARENITE_INSTRUCTION_SET
