// MUSL mapping where the functions of a cell are products along the axes: by the points.
#pragma once

#include <arenite/transfer/node_field.hpp>
#include <arenite/transfer/numerics.hpp>
#include <arenite/transfer/point_pack.hpp>
#include <arenite/transfer/product/g2p.hpp>
#include <arenite/transfer/product/rows.hpp>

namespace arenite::inline ARENITE_INSTRUCTION_SET {
namespace product {

/// Gives the points of a cell their new velocities, as their transfer takes them, and adds to `nodes.mapped`
///   m_p w_i v_p(x_i)
template <class N, class M, class B, class Field>
[[gnu::flatten]] void map_back(const N& numerics, const M& mesh, B& body, Index c, Field& nodes) {
  using T = typename M::scalar;
  using Cell = typename N::Shape::template Cell<M>;
  using Momentum = NodeLanes<ChannelList<Channel<node_channel::Momentum, M::dimension>>, ChannelList<>>;
  using Sums = Rows<Cell, Momentum, N::template width<T>>;
  const Cell cell(mesh, c);
  const NodeRows<T, M::dimension, Cell::size> v(cell, nodes.velocity);
  const auto take = numerics.transfer.take(cell, nodes);
  const auto& taken = either(take.velocity, v);
  Sums rows;
  const auto spread = [&] {
    rows.spread([&](std::size_t i, std::size_t lane, const auto& sum) {
      nodes.mapped.add(cell.nodes[i], node_pack<T, M::dimension>(lane, sum));
    });
  };
  std::size_t left = body.cells[c].size();
  for_each_pack<Sums::width>(body.cells, c, body.points, [&](const auto& p) {
    const auto x = p.position();
    const Lines<typename Sums::P, Cell> line(cell, x);
    keep_in_memory(taken);
    const auto field = take(cell, p, x, taken_sums(take, line, taken));
    typename Sums::Handed handed;
    handed.momentum(p.mass(), field);
    rows.push(p.count, handed, line);
    left -= static_cast<std::size_t>(p.count);  // one call of `spread`, as in P2G
    if (rows.full() || left == 0) spread();
  });
}

}  // namespace product
}  // namespace arenite::inline ARENITE_INSTRUCTION_SET
