// P2G where the functions of a cell are products along the axes. Points are rows, whose lanes are channels.
#pragma once
// SPDX-License-Identifier: BSD-3-Clause

#include <arenite/simd/kernel.hpp>
#include <arenite/transfer/node_field.hpp>
#include <arenite/transfer/numerics.hpp>
#include <arenite/transfer/point_pack.hpp>
#include <arenite/transfer/product/momentum_rows.hpp>
#include <arenite/transfer/product/rows.hpp>

namespace arenite::inline ARENITE_INSTRUCTION_SET {
namespace product {

/// P2G of the points p of a cell, with weights w_i at x_p and the velocity field v_p(x) that the transfer
/// hands over:
///   mass_i += m_p w_i     momentum_i += m_p w_i v_p(x_i)     force_i -= V_p sigma_p grad w_i
///   in axisymmetry force_r,i -= V_p sigma_hoop w_i / r_p     mass_gradient_i += m_p grad w_i
template <class K, class N, class M, class B, class Field>
ARENITE_KERNEL void p2g(const N& numerics, const M& mesh, const B& body, Index c, Field& nodes) {
  using T = typename M::scalar;
  using Cell = typename N::Shape::template Cell<M>;
  constexpr std::size_t D = M::dimension;
  using Sums = Rows<Cell, typename NodeSums<T, M::dimension>::Lanes, N::template width<T>>;
  using Gradient = NodeLanes<ChannelList<>, ChannelList<Channel<node_channel::MassGradient, D>>>;
  using Gradients = Rows<Cell, Gradient, N::template width<T>>;
  using P = typename Sums::P;
  const Cell cell(mesh, c);
  Sums rows;
  [[maybe_unused]] P of_cell(0);
  [[maybe_unused]] std::conditional_t<Field::has_mass_gradient, Gradients, Nothing> gradients;
  const auto spread = [&] {
    rows.spread([&](std::size_t i, std::size_t lane, const auto& sum) {
      using L = std::remove_cvref_t<decltype(sum)>;
      T* const to = nodes.sums[cell.nodes[i]].lane.data() + lane;
      store_lanes(to, lane_count<L>, L(load_lanes<L>(to, lane_count<L>) + sum));
    });
    if constexpr (Field::has_mass_gradient)
      gradients.spread([&](std::size_t i, std::size_t lane, const auto& sum) {
        nodes.mass_gradient.add(cell.nodes[i], node_pack<T, M::dimension>(lane, sum));
      });
  };
  std::size_t left = body.cells[c].size();
  for_each_pack<Sums::width>(body.cells, c, body.points, [&](const auto& p) {
    const auto x = p.position();
    const auto field = numerics.transfer.particle_field(p);
    const auto stress = p.stress();
    const P m = p.mass(), volume = -p.volume();
    const Lines<P, Cell> line(cell, x);
    typename Sums::Handed handed;
    handed.own(node_channel::mass) = m;
    handed.momentum(m, field);
    repeat<D * D>([&](std::size_t k) {
      handed.slope(k / D, node_channel::force, k % D) =
          volume * stress[Sym<P, M::dimension>::index(k % D, k / D)];
    });
    if constexpr (K::hoop) handed.own(node_channel::force) = volume * stress[2] * reciprocal(x[0]);
    rows.push(p.count, handed, line);
    if constexpr (has_light_nodes<typename N::Shape>) of_cell += m;
    if constexpr (Field::has_mass_gradient) {
      typename Gradients::Handed mass;
      repeat<D>([&](std::size_t a) { mass.slope(a, node_channel::mass_gradient, a) = m; });
      gradients.push(p.count, mass, line);
    }
    // One call for full rows and for the last ones: it is the better part of the kernel, and compiled once.
    left -= static_cast<std::size_t>(p.count);
    if (rows.full() || left == 0) spread();
  });
  if constexpr (has_light_nodes<typename N::Shape>) {
    // Mean of (h |grad w|)^2 over a cell, of a function that is linear along each axis.
    constexpr T mean = D == 2 ? T(2) / 3 : T(1) / 3;
    const T reach = mean * lane_sums(std::array<P, 1>{of_cell})[0];
    for (const Index node : cell.nodes) nodes.sums[node].lane[NodeSums<T, M::dimension>::reach_lane] += reach;
  }
}

/// P2G where nodes collect only mass and the momentum at the end of the step (`NodeMomentum`):
///   mass_i += m_p w_i     momentum_i += m_p w_i v_p(x_i) - dt V_p sigma_p grad w_i
///   in axisymmetry momentum_r,i -= dt V_p sigma_hoop w_i / r_p
template <class K, class N, class M, class B, class Field, class T>
ARENITE_KERNEL void p2g_with_impulse(const N& numerics, const M& mesh, const B& body, Index c, Field& nodes,
                                     T dt) {
  using Cell = typename N::Shape::template Cell<M>;
  constexpr std::size_t D = M::dimension;
  using Sums = MomentumBuffer<Cell, N::template width<T>>;
  using P = typename Sums::P;
  const Cell cell(mesh, c);
  Sums rows;
  const auto spread = [&] {
    rows.spread([&](std::size_t i, std::size_t lane, const auto& sum) {
      using L = std::remove_cvref_t<decltype(sum)>;
      T* const to = nodes.sums[cell.nodes[i]].lane.data() + lane;
      store_lanes(to, lane_count<L>, L(load_lanes<L>(to, lane_count<L>) + sum));
    });
  };
  std::size_t left = body.cells[c].size();
  for_each_pack<Sums::width>(body.cells, c, body.points, [&](const auto& p) {
    const auto x = p.position();
    const auto field = numerics.transfer.particle_field(p);
    const auto stress = p.stress();
    const P factor = P(-dt) * p.volume();
    const Lines<P, Cell> line(cell, x);
    std::array<P, D> impulse;
    std::array<P, D * D> slope;
    repeat<D>([&](std::size_t d) { impulse[d] = P(0); });
    if constexpr (K::hoop) impulse[0] = factor * stress[2] * reciprocal(x[0]);
    repeat<D * D>(
        [&](std::size_t k) { slope[k] = factor * stress[Sym<P, M::dimension>::index(k % D, k / D)]; });
    rows.push(p.count, p.mass(), field, impulse, slope, line);
    left -= static_cast<std::size_t>(p.count);  // one call of `spread`, as above
    if (rows.full() || left == 0) spread();
  });
}

}  // namespace product
}  // namespace arenite::inline ARENITE_INSTRUCTION_SET
