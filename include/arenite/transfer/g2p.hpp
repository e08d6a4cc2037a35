// G2P: velocities and strains from the nodes, stresses from the law, and the motion of the points, in one
// pass over the points in memory order.
#pragma once

#include <arenite/transfer/law_pass.hpp>
#include <arenite/transfer/product/g2p.hpp>
#include <arenite/transfer/simplex/g2p.hpp>

namespace arenite::inline ARENITE_INSTRUCTION_SET {

/// Gives each point its new velocity (unless `map_back` did), updates its stress, history and volume by the
/// law of its body, and moves it with the node velocities. `average`: that of this body, where the numerics
/// have one. `TracksWork`: whether the work of the stresses is summed.
template <class K, bool TracksWork, class N, class M, class B, class Field, class Average>
G2pSums g2p(const N& numerics, const M& mesh, B& body, const Field& nodes, typename M::scalar dt,
            const Average& average) {
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
            if constexpr (N::Shape::constant_gradient)
              chunk.check += static_cast<double>(
                  simplex::g2p<K>(numerics, mesh, c, points, p, next, nodes, dt, average, buffer, begin));
            else
              chunk.check += static_cast<double>(
                  product::g2p<K>(numerics, mesh, c, points, p, next, nodes, dt, buffer, begin));
            if constexpr (stores_bearing)
              buffer.store_bearing(p - begin, next - p, body.cell_sums[c].bearing);
            p = next;
          }
          law_pass<TracksWork, N::template width<T>>(law, points, begin, end, buffer, dt, chunk);
        }
        return chunk;
      },
      std::plus<>{});
}

}  // namespace arenite::inline ARENITE_INSTRUCTION_SET
