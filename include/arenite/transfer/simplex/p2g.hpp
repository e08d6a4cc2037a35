// P2G on linear simplices. Lanes are points; the sums of a cell are added up across them.
#pragma once
// SPDX-License-Identifier: BSD-3-Clause

#include <arenite/simd/kernel.hpp>
#include <arenite/transfer/cell_stress.hpp>
#include <arenite/transfer/node_field.hpp>
#include <arenite/transfer/numerics.hpp>

namespace arenite::inline ARENITE_INSTRUCTION_SET {
namespace simplex {

/// Sums of P2G over the points of a cell, except for the stress.
template <class K, class N, class Cell, class P, bool CentresStress>
using P2gSums =
    PointSums<P, Cell::size,
              ChannelList<Channel<node_channel::Momentum, Cell::D>, Channel<node_channel::Mass, 1>,
                          Channel<node_channel::HoopForce, K::hoop>>,
              ChannelList<Channel<node_channel::EdgeMass, N::needs_edge_mass ? Cell::D*(Cell::D + 1) / 2 : 0>,
                          Channel<node_channel::HoopMean,
                                  K::hoop && (N::averages_strain || CentresStress) ? Cell::size : 0>>>;

/// Contributions of a pack of points p to the nodes i of its cell:
///   mass_i += m_p w_i     momentum_i += m_p w_i v_p(x_i)     hoop_force_i += V_p sigma_hoop w_i / r_p
/// with the weights w_i at x_p and the velocity field v_p(x) of the transfer; to its edges
/// edge_mass_ij += m_p w_i w_j.
template <class Transfer, class Cell, class Points, int Width, class Sums>
void add_points(const Transfer& transfer, const Cell& cell, const PointPack<Points, Width>& p, Sums& sums) {
  using P = typename PointPack<Points, Width>::P;
  const auto x = p.position();
  const auto field = transfer.particle_field(p);
  const auto m = p.mass();
  const auto w = cell.weights(x);
  std::array<P, Cell::size> mw;
  const auto offsets = cell.offsets(x);
  const P around = p.volume() * reciprocal(x[0]), hoop = around * p.stress(2);
  repeat<Cell::size>([&](std::size_t i) { mw[i] = m * w[i]; });
  repeat<Cell::size>([&](std::size_t i) {
    sums.add(i, node_channel::momentum, mw[i], field.at([&](std::size_t a) { return offsets[a][i]; }));
    sums.add(i, node_channel::mass, mw[i]);
    sums.add(i, node_channel::hoop_force, hoop * w[i]);
    sums.add_to_cell(node_channel::hoop_mean, i, around * w[i]);
  });
  for_each_edge<Cell::size>([&](std::size_t e, std::size_t i, std::size_t j) {
    sums.add_to_cell(node_channel::edge_mass, e, mw[i] * w[j]);
  });
}

/// Stores the sums over the points of a cell that later stages need.
template <class N, class B, class T, int D, class Total>
void leave_sums(const B&, const StressSums<T, D>& stress, const Total& total, CellSums<T, D>& left) {
  left.volume = stress.volume;
  if constexpr (N::AntiLocking::averages_stress) left.volume_factor = stress.volume_factor;
  if constexpr (B::has_dilation) left.dilation = stress.dilation / stress.volume;
  if constexpr (B::knows_opening) left.open = stress.closed < stress.volume;
  total.copy(node_channel::edge_mass, left.edge_mass);
  total.copy(node_channel::hoop_mean, left.hoop);
}

/// P2G of the points of a cell: `add_points`, and with the gradients, which are constant in it,
///   force_i -= (sum_p V_p sigma_p) grad w_i     mass_gradient_i += (sum_p m_p) grad w_i
template <class K, class N, class M, class B, class Field>
ARENITE_KERNEL void p2g(const N& numerics, const M& mesh, B& body, Index c, Field& nodes) {
  using T = typename M::scalar;
  using Cell = typename N::Shape::template Cell<M>;
  using Quad = Pack<T, 4>;
  constexpr int width = N::template width<T>;
  constexpr bool centres_stress = N::template centres_stress<decltype(body.law)>;
  using Sums = P2gSums<K, N, Cell, lanes_of<T, width>, centres_stress>;
  const Cell cell(mesh, c);
  auto stress = sum_stresses<width>(body, c);
  average_stress<K>(numerics, mesh, body, c, stress);  // writes the points' stresses
  if constexpr (centres_stress) body.cell_stress[c].c = stress.stress;
  Sums sums;
  for_each_pack<width>(body.cells, c, body.points, [&](const auto& p) {
    p.prefetch(body.points.position, body.points.velocity, body.points.mass);
    add_points(numerics.transfer, cell, p, sums);
  });
  const typename Sums::Total total(sums);
  if constexpr (N::needs_cell_sums) leave_sums<N>(body, stress, total, body.cell_sums[c]);
  T mass = 0;
  repeat<Cell::size>([&](std::size_t i) { mass += total.node(i, node_channel::mass); });
  [[maybe_unused]] const T reach = mass * square(mesh.size(c));
  [[maybe_unused]] const Quad touched = pack4(T(0), T(0), T(0), mass);
  const CellForce<T, M::dimension> internal(stress.stress);
  [[maybe_unused]] const Quad hoop = pack4(-stress.volume_factor, T(0), T(0), T(0));
  repeat<Cell::size>([&](std::size_t i) {
    auto& node = nodes.sums[cell.nodes[i]];
    const auto gradient = cell.gradient.col(static_cast<int>(i));
    Quad force = internal.at(gradient);
    repeat<K::hoop>([&](std::size_t) { force += hoop * Quad(total.node(i, node_channel::hoop_force)); });
    repeat<N::smooths_light_nodes>(
        [&](std::size_t) { force += pack4(T(0), T(0), T(0), reach * gradient.squaredNorm()); });
    repeat<!N::smooths_light_nodes>([&](std::size_t) { force += touched; });
    node.add_values(total.node(i));
    node.add_slopes(force);
    if constexpr (Field::has_mass_gradient) nodes.mass_gradient[cell.nodes[i]] += mass * gradient;
  });
}

}  // namespace simplex
}  // namespace arenite::inline ARENITE_INSTRUCTION_SET
