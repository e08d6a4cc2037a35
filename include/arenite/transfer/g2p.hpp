// G2P: velocities and strains from the nodes, stresses from the law, and the motion of the points, in one
// pass over the points in memory order.
#pragma once
// SPDX-License-Identifier: BSD-3-Clause

#include <arenite/law/pass.hpp>
#include <arenite/transfer/product/g2p.hpp>
#include <arenite/transfer/product/strain.hpp>
#include <arenite/transfer/simplex/g2p.hpp>
#include <arenite/transfer/simplex/strain.hpp>

namespace arenite::inline ARENITE_INSTRUCTION_SET {

/// Strain steps of the points of a cell, made from the cell and the node velocities that strain: called with a
/// pack of its points, it gives their sym(dt sum u_i (grad w_i)^T), in axisymmetry with
/// de_hoop = dt sum w_i u_r,i / r_p. K: kinematics, N: numerics, M: mesh.
template <class K, class N, class M>
using CellStrain = std::conditional_t<N::Shape::constant_gradient, simplex::CellStrain<K, N, M>,
                                      product::CellStrain<K, N, M>>;

namespace detail {

/// Strains of a run of points of a cell into `buffer`, that of point `origin` first.
template <class K, class N, class M, class Points, class Field, class Average, class Buffer>
ARENITE_KERNEL void strain(const M& mesh, Index c, const Points& points, std::size_t begin, std::size_t end,
                           const Field& nodes, typename M::scalar dt, const Average& average, Buffer& buffer,
                           std::size_t origin) {
  const auto of_cell = [&]<class Strain>(const Strain& strain) {
    for_each_pack<Strain::width>(points, begin, end, [&](const auto& p) {
      auto step = strain(p);
      apply_average(step, average, c);
      buffer.store(p.first - origin, step);
    });
  };
  if constexpr (N::Shape::constant_gradient)
    of_cell(CellStrain<K, N, M>(mesh, c, nodes, dt));
  else
    N::Shape::visit_cell(mesh, c, [&]<class Cell>(const Cell& cell) {
      of_cell(product::CellStrain<K, N, M, Cell>(cell, nodes, dt));
    });
}

/// Calls `run(cell, first, last, buffer, origin)` for the runs of points of one cell as they lie in memory,
/// which returns a part of the check; where `UpdatesStress`, the law takes the strains that it left in the
/// buffer, and updates the points.
template <bool TracksWork, bool UpdatesStress, class N, class M, class B, class Run>
G2pSums pass_over_points(const N&, const M&, B& body, typename M::scalar dt, Run&& run) {
  using T = typename M::scalar;
  constexpr bool stores_bearing = TracksWork && N::AntiLocking::averages_stress;
  using Buffer = StrainBuffer<T, M::dimension, stores_bearing>;
  auto& points = body.points;
  return parallel_reduce(
      points.size(), G2pSums{},
      [&](std::size_t chunk_begin, std::size_t chunk_end) {
        const auto law = body.law;  // a copy: its moduli stay in registers
        G2pSums chunk;
        Buffer buffer;
        for (std::size_t begin = chunk_begin; begin < chunk_end; begin += Buffer::capacity) {
          const std::size_t end = std::min(chunk_end, begin + Buffer::capacity);
          for (std::size_t p = begin; p < end;) {
            const Index c = points.cell[p];
            const std::size_t next = std::min<std::size_t>(end, body.cells.run_end(static_cast<Index>(p), c));
            chunk.check += static_cast<double>(run(c, p, next, buffer, begin));
            if constexpr (stores_bearing)
              buffer.store_volume_factor(p - begin, next - p, body.cell_sums[c].volume_factor);
            p = next;
          }
          if constexpr (UpdatesStress)
            law_pass<TracksWork, N::template width<T>>(law, points, begin, end, buffer, dt, chunk);
        }
        return chunk;
      },
      std::plus<>{});
}

}  // namespace detail

/// Gives each point its new velocity (unless `map_back` did), updates its stress, history and volume by the
/// law of its body (unless `update_stress` did), and moves it with the node velocities. `average`: that of
/// this body, where the numerics have one. `TracksWork`: whether the work of the stresses is summed.
template <class K, bool TracksWork, class N, class M, class B, class Field, class Average>
G2pSums g2p(const N& numerics, const M& mesh, B& body, const Field& nodes, typename M::scalar dt,
            const Average& average) {
  auto& points = body.points;
  return detail::pass_over_points<TracksWork, !N::strains_first>(
      numerics, mesh, body, dt,
      [&](Index c, std::size_t first, std::size_t last, auto& buffer, std::size_t origin) {
        if constexpr (N::Shape::constant_gradient)
          return simplex::g2p<K>(numerics, mesh, c, points, first, last, nodes, dt, average, buffer, origin);
        else
          return product::g2p<K>(numerics, mesh, c, points, first, last, nodes, dt, average, buffer, origin);
      });
}

/// Stress, history and volume of the points after a step by the law of their body, and nothing else.
template <class K, bool TracksWork, class N, class M, class B, class Field, class Average>
G2pSums update_stress(const N& numerics, const M& mesh, B& body, const Field& nodes, typename M::scalar dt,
                      const Average& average) {
  return detail::pass_over_points<TracksWork, true>(
      numerics, mesh, body, dt,
      [&](Index c, std::size_t first, std::size_t last, auto& buffer, std::size_t origin) {
        detail::strain<K, N>(mesh, c, body.points, first, last, nodes, dt, average, buffer, origin);
        return 0;
      });
}

}  // namespace arenite::inline ARENITE_INSTRUCTION_SET
