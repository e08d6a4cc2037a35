// G2P where the functions of a cell are products along the axes.
#pragma once
// SPDX-License-Identifier: BSD-3-Clause

#include <arenite/simd/kernel.hpp>
#include <arenite/transfer/node_field.hpp>
#include <arenite/transfer/numerics.hpp>
#include <arenite/transfer/product/lines.hpp>
#include <arenite/transfer/strain.hpp>

namespace arenite::inline ARENITE_INSTRUCTION_SET {
namespace product {

/// Sums over node vectors with the functions of `line`: with moments if a transfer needs them, and with those
/// over its vectors `second`.
template <class Gather, class Line, class Rows, class... Kinds>
auto gathered_sums(const Gather& gather, const Line& line, const Rows& rows, const Kinds&... kind) {
  const auto sums = [&] {
    if constexpr (Gather::needs_moments)
      return line.sum(rows, kind..., line.moment);
    else
      return line.sum(rows, kind...);
  };
  if constexpr (requires { gather.second; }) {
    keep_in_memory(gather.second);
    return TwoSums{sums(), line.sum(gather.second).value};
  } else {
    return sums();
  }
}

/// Whether a transfer takes the moments of the new velocities themselves.
template <class Gather>
inline constexpr bool takes_moments_of_v =
    Gather::needs_moments&& std::same_as<decltype(Gather::velocity), Nothing>;

/// G2P of a run of points of a cell, with weights w_i at x_p, the new node velocities v_i, and u_i, those for
/// the strains (the same, unless MUSL maps others back):
///   v_p, C_p: as the transfer takes them (with MUSL: in `map_back`)     x_p += dt sum w_i v_i (`moves_mapped`: u_i)
///   de = sym(dt sum u_i (grad w_i)^T), in axisymmetry de_hoop = dt sum w_i u_r,i / r_p
/// Strains go into `buffer`, that of point `origin` first (USF took them before). Returns a sum of the
/// positions. `by_moments`: see `ProductShape::Cell::has_moments_for_slopes`.
template <class K, bool by_moments, class N, class Cell, class Points, class Field, class T, class Average,
          class Buffer>
T g2p_of_cell(const N& numerics, const Cell& cell, Index c, Points& points, std::size_t begin,
              std::size_t end, const Field& nodes, T dt, const Average& average, Buffer& buffer,
              std::size_t origin) {
  using Rows = CellVectors<T, Cell::D, Cell::size>;
  constexpr int width = cell_width<Cell::D, N::template width<T>>;
  using P = lanes_of<T, width>;
  const Rows v(cell, nodes.velocity);
  const std::conditional_t<N::maps_back, Rows, Nothing> mapped(cell, nodes.strain_velocity());
  const auto& u = value_or(mapped, v);
  const auto gather = numerics.transfer.gather(cell, nodes);
  // What is taken of v itself costs no sum of its own.
  constexpr bool takes_of_v = !N::maps_back && std::same_as<decltype(gather.velocity), Nothing>;
  P check(0);
  for_each_pack<width>(points, begin, end, [&](const auto& p) {
    const auto x = p.position();
    const Lines<P, Cell> line(cell, x);
    keep_in_memory(v), keep_in_memory(u);
    const auto sums = [&] {
      if constexpr (by_moments)
        return gathered_sums(gather, line, u);
      else if constexpr (takes_of_v)
        return gathered_sums(gather, line, u, line.slope);
      else
        return line.sum(u, line.slope);
    }();
    auto gradient = sums.by_axis[0];
    if constexpr (by_moments) {
      const auto inverse = cell.inverse_inertia(x);
      repeat<inverse.size()>([&](std::size_t a) {
        for (P& component : gradient[a]) component = component * inverse[a];
      });
    }
    auto step = strain_step_of<K, N::squares>(gradient, sums.value, x, dt);
    apply_average(step, average, c);
    const auto moving_velocity = N::maps_back && !N::moves_mapped ? line.sum(v).value : sums.value;
    if constexpr (takes_of_v)
      gather(cell, p, x, sums);
    else if constexpr (!N::maps_back)
      gather(cell, p, x, gathered_sums(gather, line, gather.velocity));
    if constexpr (!N::strains_first) buffer.store(p.first - origin, step);
    check += move_points(p, x, moving_velocity, dt);
  });
  return lane_sums(std::array<P, 1>{check})[0];
}

template <class K, class N, class M, class Points, class Field, class T, class Average, class Buffer>
ARENITE_KERNEL T g2p(const N& numerics, const M& mesh, Index c, Points& points, std::size_t begin,
                     std::size_t end, const Field& nodes, T dt, const Average& average, Buffer& buffer,
                     std::size_t origin) {
  const typename N::Shape::template Cell<M> cell(mesh, c);
  const auto of_cell = [&]<bool by_moments>(std::bool_constant<by_moments>) {
    return g2p_of_cell<K, by_moments>(numerics, cell, c, points, begin, end, nodes, dt, average, buffer,
                                      origin);
  };
  using Gather = decltype(numerics.transfer.gather(cell, nodes));
  if constexpr (!N::maps_back && takes_moments_of_v<Gather> && requires { cell.has_moments_for_slopes(); })
    if (cell.has_moments_for_slopes()) return of_cell(std::true_type{});
  return of_cell(std::false_type{});
}

}  // namespace product
}  // namespace arenite::inline ARENITE_INSTRUCTION_SET
