// What points hand back to the nodes of their cell where its functions are products along the axes: only
// momentum.
#pragma once
// SPDX-License-Identifier: BSD-3-Clause

#include <arenite/transfer/node_field.hpp>
#include <arenite/transfer/numerics.hpp>
#include <arenite/transfer/point_pack.hpp>
#include <arenite/transfer/product/rows.hpp>

namespace arenite::inline ARENITE_INSTRUCTION_SET {
namespace product {

/// Adds to the vectors `to` of the nodes, of the points p of a cell,
///   m_p w_i v_p(x_i)
/// with the velocity field v_p = `field(p, x, line)`, at x, with the functions of `line`.
template <class N, class Cell, class B, class Vectors, class F>
void hand_back(const Cell& cell, B& body, Index c, Vectors& to, F&& field) {
  using T = typename Cell::T;
  using Momentum = NodeLanes<ChannelList<Channel<node_channel::Momentum, Cell::D>>, ChannelList<>>;
  using Sums = Rows<Cell, Momentum, N::template width<T>>;
  Sums rows;
  const auto spread = [&] {
    rows.spread([&](std::size_t i, std::size_t lane, const auto& sum) {
      to.add(cell.nodes[i], node_pack<T, Cell::D>(lane, sum));
    });
  };
  std::size_t left = body.cells[c].size();
  for_each_pack<Sums::width>(body.cells, c, body.points, [&](const auto& p) {
    const auto x = p.position();
    const Lines<typename Sums::P, Cell> line(cell, x);
    typename Sums::Handed handed;
    handed.momentum(p.mass(), field(p, x, line));
    rows.push(p.count, handed, line);
    left -= static_cast<std::size_t>(p.count);  // one call of `spread`, as in P2G
    if (rows.full() || left == 0) spread();
  });
}

}  // namespace product
}  // namespace arenite::inline ARENITE_INSTRUCTION_SET
