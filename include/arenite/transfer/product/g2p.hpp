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
ARENITE_INLINE_BEGIN

/// Node vectors of a cell that are summed at its points for their transfer.
template <class Cell, class Gather>
struct TransferVectors {
  static constexpr bool has_second = requires(const Gather gather) { gather.second; };
  Differences<Cell> vectors;  // d_i; the new velocities if the transfer has none
  [[no_unique_address]] std::conditional_t<has_second, Differences<Cell>, Nothing> second;

  template <class Nodes>
  TransferVectors(const Cell& cell, const Nodes& nodes, const Gather& gather)
      : vectors{[&] {
          if constexpr (std::same_as<decltype(gather.velocity), Nothing>)
            return Differences<Cell>(cell, nodes.velocity);
          else
            return Differences<Cell>(gather.velocity);
        }()},
        second{[&] {
          if constexpr (has_second)
            return Differences<Cell>(gather.second);
          else
            return Nothing{};
        }()} {}

  /// Sums with the functions of `line`: by `kind`, with moments if the transfer needs them, and of its second vectors.
  template <class Line, class... Kinds>
  auto sums(const Line& line, const Kinds&... kind) const {
    reload_from_memory(*this);
    const auto sums = [&] {
      if constexpr (Gather::needs_moments)
        return line.sum(vectors, kind..., line.moment);
      else
        return line.sum(vectors, kind...);
    };
    if constexpr (has_second)
      return TwoSums{sums(), line.sum(second).value};
    else
      return sums();
  }
};

/// Node vectors of a cell for `Lines::sum`, or `Nothing`.
template <bool Wanted, class Cell, class Vectors>
auto differences_if(const Cell& cell, const Vectors& of_nodes) {
  if constexpr (Wanted)
    return Differences<Cell>(cell, of_nodes);
  else
    return Nothing{};
}

/// Whether a transfer uses the moments of the new velocities themselves.
template <class Gather>
inline constexpr bool takes_moments_of_v =
    Gather::needs_moments&& std::same_as<decltype(Gather::velocity), Nothing>;

/// G2P of a run of points of a cell, with weights w_i at x_p, the new node velocities v_i, and u_i, those for
/// the strains (the same, unless MUSL maps others back):
///   v_p, C_p: as the transfer gives them (with MUSL: in `map_back`)     x_p += dt sum w_i v_i (`moves_mapped`: u_i)
///   de = sym(dt sum u_i (grad w_i)^T), in axisymmetry de_hoop = dt sum w_i u_r,i / r_p
/// Strains go into `buffer`, that of point `origin` first (USF has applied them before). Returns a sum of the
/// positions. `by_moments`: see `ProductShape::Cell::has_moments_for_slopes`.
template <class K, bool by_moments, class N, class Cell, class Points, class Field, class T, class Average,
          class Buffer>
T g2p_of_cell(const N& numerics, const Cell& cell, Index c, Points& points, std::size_t begin,
              std::size_t end, const Field& nodes, T dt, const Average& average, Buffer& buffer,
              std::size_t origin) {
  constexpr int width = cell_width<Cell::D, N::template width<T>>;
  using P = lanes_of<T, width>;
  using Gather = decltype(numerics.transfer.gather(cell, nodes));
  using Taken = TransferVectors<Cell, Gather>;
  const Gather gather = numerics.transfer.gather(cell, nodes);
  // A transfer that sums the new velocities themselves shares the sums of the strains.
  constexpr bool takes_of_v = !N::maps_back && std::same_as<decltype(gather.velocity), Nothing>;
  constexpr bool moves_apart = N::maps_back && !N::moves_mapped;  // with v, while strains are those of u
  const std::conditional_t<N::maps_back, Nothing, Taken> taken(cell, nodes, gather);
  const auto u = differences_if<!takes_of_v>(cell, nodes.strain_velocity());
  const auto v = differences_if<moves_apart>(cell, nodes.velocity);
  P check(0);
  for_each_pack<width>(points, begin, end, [&](const auto& p) {
    const auto x = p.position();
    const Lines<P, Cell> line(cell, x);
    reload_from_memory(u), reload_from_memory(v);
    const auto sums = [&] {
      if constexpr (by_moments)
        return taken.sums(line);
      else if constexpr (takes_of_v)
        return taken.sums(line, line.slope);
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
    const auto moving_velocity = [&] {
      if constexpr (moves_apart)
        return line.sum(v).value;
      else
        return sums.value;
    }();
    if constexpr (takes_of_v)
      gather(cell, p, x, sums);
    else if constexpr (!N::maps_back)
      gather(cell, p, x, taken.sums(line));
    if constexpr (!N::strains_first) buffer.store(p.first - origin, step);
    check += move_points(p, x, moving_velocity, dt);
  });
  return lane_sums(std::array<P, 1>{check})[0];
}
ARENITE_INLINE_END

template <class K, class N, class M, class Points, class Field, class T, class Average, class Buffer>
ARENITE_KERNEL T g2p(const N& numerics, const M& mesh, Index c, Points& points, std::size_t begin,
                     std::size_t end, const Field& nodes, T dt, const Average& average, Buffer& buffer,
                     std::size_t origin) {
  return N::Shape::visit_cell(mesh, c, [&](const auto& cell) ARENITE_INLINE {
    const auto of_cell = [&]<bool by_moments>(std::bool_constant<by_moments>) ARENITE_INLINE {
      return g2p_of_cell<K, by_moments>(numerics, cell, c, points, begin, end, nodes, dt, average, buffer,
                                        origin);
    };
    using Gather = decltype(numerics.transfer.gather(cell, nodes));
    if constexpr (!N::maps_back && takes_moments_of_v<Gather> && requires { cell.has_moments_for_slopes(); })
      if (cell.has_moments_for_slopes()) return of_cell(std::true_type{});
    return of_cell(std::false_type{});
  });
}

}  // namespace product
}  // namespace arenite::inline ARENITE_INSTRUCTION_SET
