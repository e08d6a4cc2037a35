// Momentum mapped from the points to the nodes of their cell where its functions are products along the axes.
#pragma once
// SPDX-License-Identifier: BSD-3-Clause

#include <arenite/simd/kernel.hpp>
#include <arenite/transfer/node_field.hpp>
#include <arenite/transfer/numerics.hpp>
#include <arenite/transfer/point_pack.hpp>
#include <arenite/transfer/product/p2g.hpp>

namespace arenite::inline ARENITE_INSTRUCTION_SET {
namespace product {
ARENITE_INLINE_BEGIN

/// Adds to the vectors `to` of the nodes, of the points p of a cell,
///   m_p w_i v_p(x_i)
/// with the velocity field v_p = `field(p, x, line)`, at x, with the functions of `line`.
template <class N, class Cell, class B, class Vectors, class F>
void scatter_momentum(const Cell& cell, B& body, Index c, Vectors& to, F&& field) {
  using T = typename Cell::T;
  using Sums =
      Rows<Cell, N::template width<T>, N::Transfer::affine ? Contribution::both : Contribution::by_value>;
  using P = typename Sums::P;
  Sums rows;
  const auto hand = [&](const auto& p, const auto& x, const auto& line) {
    const P m = p.mass();
    const auto v = field(p, x, line);
    std::array<P, Cell::D> own;
    repeat<own.size()>([&](std::size_t d) { own[d] = m * v.value[d]; });
    rows.template hand<0>(line, own, moment_of(m, v), Nothing{});
  };
  for_each_row(rows, cell, body, c, hand, [&] {
    rows.template spread<0>([&](std::size_t i, std::size_t lane, const auto& sum) {
      to.add(cell.nodes[i], node_pack<T, Cell::D>(lane, sum));
    });
  });
}

ARENITE_INLINE_END
}  // namespace product
}  // namespace arenite::inline ARENITE_INSTRUCTION_SET
