// G2P on linear simplices.
#pragma once
// SPDX-License-Identifier: BSD-3-Clause

#include <arenite/simd/kernel.hpp>
#include <arenite/transfer/node_field.hpp>
#include <arenite/transfer/numerics.hpp>
#include <arenite/transfer/simplex/strain.hpp>

namespace arenite::inline ARENITE_INSTRUCTION_SET {
namespace simplex {

/// The sum for a transfer.
template <class V>
struct ValueSum {
  V value;
};
template <class V>
ValueSum(V) -> ValueSum<V>;

/// G2P of a run of points of a cell, with weights w_i at x_p, the new node velocities v_i, and u_i, those for
/// the strains (the same, unless MUSL maps others back):
///   v_p, L_p: as the transfer gives them     x_p += dt sum w_i v_i
///   de = sym(dt sum u_i (grad w_i)^T), in axisymmetry de_hoop = dt sum w_i u_r,i / r_p
/// Strains go into `buffer`, that of point `origin` first (USF has applied them before). Returns a sum of the
/// positions.
template <class K, class N, class M, class Points, class Field, class T, class Average, class Buffer>
ARENITE_KERNEL T g2p(const N& numerics, const M& mesh, Index c, Points& points, std::size_t begin,
                     std::size_t end, const Field& nodes, T dt, const Average& average, Buffer& buffer,
                     std::size_t origin) {
  using Cell = typename N::Shape::template Cell<M>;
  constexpr int width = N::template width<T>;
  using P = lanes_of<T, width>;
  const Cell cell(mesh, c);
  const CellVectors<T, M::dimension, Cell::size> v(cell, nodes.velocity), u(cell, nodes.strain_velocity());
  const auto gather = numerics.transfer.gather(cell, nodes);
  auto of_cell = cell_step<N::squares>(cell, u, dt);
  if constexpr (!K::hoop) apply_average(of_cell, average, c);  // one for all points
  P check(0);
  for_each_pack<width>(points, begin, end, [&](const auto& p) {
    const auto x = p.position();
    const auto w = cell.weights(x);
    const auto moving_velocity = interpolate(w, v);
    auto step = in_all_lanes<P>(of_cell);
    const ValueSum gathered{interpolate(w, value_or(gather.velocity, v))};
    if constexpr (requires { gather.second; })
      gather(cell, p, x, TwoSums{gathered, interpolate(w, gather.second)});
    else
      gather(cell, p, x, gathered);
    if constexpr (K::hoop) {
      set_hoop_strain<K, N::squares>(step, interpolate(w, u), x, dt);
      apply_average(step, average, c);
    }
    if constexpr (!N::strains_first) buffer.store(p.first - origin, step);
    check += move_points(p, x, moving_velocity, dt);
  });
  return lane_sums(std::array<P, 1>{check})[0];
}

}  // namespace simplex
}  // namespace arenite::inline ARENITE_INSTRUCTION_SET
