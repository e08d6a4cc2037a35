// P2G where the functions of a cell are products along the axes. Points are rows, whose lanes are channels.
#pragma once
// SPDX-License-Identifier: BSD-3-Clause

#include <arenite/simd/kernel.hpp>
#include <arenite/transfer/node_field.hpp>
#include <arenite/transfer/numerics.hpp>
#include <arenite/transfer/point_pack.hpp>
#include <arenite/transfer/product/rows.hpp>

namespace arenite::inline ARENITE_INSTRUCTION_SET {
namespace product {
ARENITE_INLINE_BEGIN

/// Calls `hand(p, x, line)` for the points of a cell, and `spread()` to add their rows to the nodes.
template <class Rows, class Cell, class B, class F, class Spread>
void for_each_row(Rows& rows, const Cell& cell, B& body, Index c, F&& hand, Spread&& spread) {
  std::size_t left = body.cells[c].size();
  for_each_pack<Rows::width>(body.cells, c, body.points, [&](const auto& p) {
    const auto x = p.position();
    const Lines<typename Rows::P, Cell> line(cell, x);
    hand(p, x, line);
    rows.take(p.count, line);
    // One call for full rows and for the last ones: it is most of the kernel, and compiled once.
    left -= static_cast<std::size_t>(p.count);
    if (!rows.full() && left > 0) return;
    spread();
    rows.forget();
  });
}

/// Adds lanes to those of a node from `to` on.
template <class T, class L>
void add_lanes(T* to, const L& sum) {
  store_lanes(to, lane_count<L>, L(load_lanes<L>(to, lane_count<L>) + sum));
}

/// Momentum and mass of points, by value.
template <class P, std::size_t D>
std::array<P, D + 1> momentum_and_mass(const P& m, const std::array<P, D>& v) {
  std::array<P, D + 1> own;
  repeat<D>([&](std::size_t d) { own[d] = m * v[d]; });
  own[D] = m;
  return own;
}
/// m times the gradient of a velocity field along axis a; `Nothing` of one that is constant.
template <class P, std::size_t D, bool Linear>
auto moment_of(const P& m, const VelocityField<P, D, Linear>& v) {
  if constexpr (Linear)
    return [&m, &v](std::size_t a) {
      std::array<P, D> along;
      repeat<D>([&](std::size_t d) { along[d] = m * v.gradient[a * D + d]; });
      return along;
    };
  else
    return Nothing{};
}
/// `factor` times the stress along axis a.
template <int D, class P, class Stress>
auto traction_of(const P& factor, const Stress& stress) {
  return [&factor, &stress](std::size_t a) {
    std::array<P, static_cast<std::size_t>(D)> along;
    repeat<along.size()>([&](std::size_t d) { along[d] = factor * stress[Sym<P, D>::index(d, a)]; });
    return along;
  };
}

/// P2G of the points p of a cell, with weights w_i at x_p and the velocity field v_p(x) of the transfer:
///   mass_i += m_p w_i     momentum_i += m_p w_i v_p(x_i)     force_i -= V_p sigma_p grad w_i
///   in axisymmetry force_r,i -= V_p sigma_hoop w_i / r_p     mass_gradient_i += m_p grad w_i
template <class K, class N, class Cell, class B, class Field>
void p2g_of_cell(const N& numerics, const Cell& cell, const B& body, Index c, Field& nodes) {
  using T = typename Cell::T;
  constexpr std::size_t D = Cell::D;
  constexpr Contribution momentum = N::Transfer::affine ? Contribution::both : Contribution::by_value,
                         force = K::hoop ? Contribution::both : Contribution::by_axis;
  using Sums = std::conditional_t<Field::has_mass_gradient,
                                  Rows<Cell, N::template width<T>, momentum, force, Contribution::by_axis>,
                                  Rows<Cell, N::template width<T>, momentum, force>>;
  using P = typename Sums::P;
  Sums rows;
  [[maybe_unused]] P of_cell(0);
  const auto hand = [&](const auto& p, const auto& x, const auto& line) {
    const auto field = numerics.transfer.particle_field(p);
    const auto stress = p.stress();
    const P m = p.mass(), volume = -p.volume();
    rows.template hand<0>(line, momentum_and_mass(m, field.value), moment_of(m, field), Nothing{});
    std::conditional_t<K::hoop, std::array<P, 1>, Nothing> hoop;
    if constexpr (K::hoop) hoop[0] = volume * stress[2] * reciprocal(x[0]);
    rows.template hand<1>(line, hoop, Nothing{}, traction_of<Cell::D>(volume, stress));
    if constexpr (Field::has_mass_gradient)
      rows.template hand<2>(line, Nothing{}, Nothing{}, [&](std::size_t a) {
        std::array<P, D> along;
        repeat<D>([&](std::size_t d) { along[d] = d == a ? m : P(0); });
        return along;
      });
    if constexpr (has_light_nodes<typename N::Shape>) of_cell += m;
  };
  for_each_row(rows, cell, body, c, hand, [&] {
    const auto at = [&](std::size_t i, std::size_t lane) {
      return nodes.sums[cell.nodes[i]].lane.data() + lane;
    };
    rows.template spread<0>(
        [&](std::size_t i, std::size_t lane, const auto& sum) { add_lanes(at(i, lane), sum); });
    rows.template spread<1>([&](std::size_t i, std::size_t lane, const auto& sum) {
      add_lanes(at(i, NodeSums<T, Cell::D>::force_lane + lane), sum);
    });
    if constexpr (Field::has_mass_gradient)
      rows.template spread<2>([&](std::size_t i, std::size_t lane, const auto& sum) {
        nodes.mass_gradient.add(cell.nodes[i], node_pack<T, Cell::D>(lane, sum));
      });
  });
  if constexpr (has_light_nodes<typename N::Shape>) {
    // Mean of (h |grad w|)^2 over a cell, of a function that is linear along each axis.
    constexpr T mean = D == 2 ? T(2) / 3 : T(1) / 3;
    const T reach = mean * lane_sums(std::array<P, 1>{of_cell})[0];
    for (const Index node : cell.nodes) nodes.sums[node].lane[NodeSums<T, Cell::D>::reach_lane] += reach;
  }
}
ARENITE_INLINE_END
template <class K, class N, class M, class B, class Field>
ARENITE_KERNEL void p2g(const N& numerics, const M& mesh, const B& body, Index c, Field& nodes) {
  N::Shape::visit_cell(
      mesh, c, [&](const auto& cell) ARENITE_INLINE { p2g_of_cell<K>(numerics, cell, body, c, nodes); });
}

/// P2G where nodes collect only mass and the momentum at the end of the step (`NodeMomentum`):
///   mass_i += m_p w_i     momentum_i += m_p w_i v_p(x_i) - dt V_p sigma_p grad w_i
///   in axisymmetry momentum_r,i -= dt V_p sigma_hoop w_i / r_p
template <class K, class N, class M, class B, class Field, class T>
ARENITE_KERNEL void p2g_with_impulse(const N& numerics, const M& mesh, const B& body, Index c, Field& nodes,
                                     T dt) {
  N::Shape::visit_cell(mesh, c, [&]<class Cell>(const Cell& cell) ARENITE_INLINE {
    using Sums = Rows<Cell, N::template width<T>, Contribution::both>;
    using P = typename Sums::P;
    Sums rows;
    const auto hand = [&](const auto& p, const auto& x, const auto& line) ARENITE_INLINE {
      const auto field = numerics.transfer.particle_field(p);
      const auto stress = p.stress();
      const P m = p.mass(), factor = P(-dt) * p.volume();
      auto own = momentum_and_mass(m, field.value);
      if constexpr (K::hoop) own[0] += factor * stress[2] * reciprocal(x[0]);
      rows.template hand<0>(line, own, moment_of(m, field), traction_of<Cell::D>(factor, stress));
    };
    for_each_row(rows, cell, body, c, hand, [&] {
      rows.template spread<0>([&](std::size_t i, std::size_t lane, const auto& sum) {
        add_lanes(nodes.sums[cell.nodes[i]].lane.data() + lane, sum);
      });
    });
  });
}

}  // namespace product
}  // namespace arenite::inline ARENITE_INSTRUCTION_SET
