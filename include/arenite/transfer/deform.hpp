// Deform (G2P): velocities and strains from the nodes, the points moved, and stresses from the law; one pass
// over the points as they lie in memory, after one over the cells where the volumetric strain is averaged.
#pragma once

#include <arenite/transfer/law_pass.hpp>
#include <arenite/transfer/point_velocities.hpp>
#include <arenite/transfer/tensor_product.hpp>
#include <arenite/transfer/volumetric_average.hpp>

namespace arenite::inline ARENITE_INSTRUCTION_SET {

/// Strain and spin of one step from the velocity gradient times dt, whose columns are `along(j)`[i] =
/// dv_i/dx_j dt; no strain out of plane.
template <class P, std::size_t D, class Columns>
StrainStep<P, static_cast<int>(D)> in_plane_step(Columns&& along) {
  StrainStep<P, static_cast<int>(D)> inc;
  auto& e = inc.strain;
  const P half(0.5);
  const auto x = along(0), y = along(1);
  e[0] = x[0];
  e[1] = y[1];
  e[3] = (y[0] + x[1]) * half;
  inc.spin[0] = (y[0] - x[1]) * half;
  if constexpr (D == 3) {
    const auto z = along(2);
    e[2] = z[2];
    e[4] = (z[1] + y[2]) * half;
    e[5] = (x[2] + z[0]) * half;
    inc.spin[1] = (z[1] - y[2]) * half;
    inc.spin[2] = (x[2] - z[0]) * half;
  } else {
    e[2] = P(0);
  }
  return inc;
}

namespace detail {

/// Moves the neighbours [begin, end) of one cell and writes their strains into `buffer`, from `at`
/// on; gives them their velocities too, unless they have them. Returns a sum of the positions.
template <class K, class N, class M, class Points, class Field, class Average, class Buffer>
[[gnu::flatten]] auto move_run(const N& numerics, const M& mesh, Index c, Points& points, std::size_t begin,
                               std::size_t end, const Field& nodes, typename M::scalar dt,
                               [[maybe_unused]] const Average& average, Buffer& buffer, std::size_t at) {
  using T = typename M::scalar;
  using Shape = typename N::Shape;
  using Cell = typename Shape::template Cell<M>;
  constexpr std::size_t D = M::dimension, size = Cell::size;
  constexpr int width =
      Shape::constant_gradient ? N::template width<T> : cell_width<M::dimension, N::template width<T>>;
  using P = lanes_of<T, width>;
  using V = NodePack<T, M::dimension>;
  constexpr bool takes_velocity = !N::remaps_by_points;
  const Cell cell(mesh, c);
  // Velocities of the nodes: for positions, and for strains, which are the same unless mapped back.
  using Rows = NodeRows<T, M::dimension, size>;
  Rows v;
  [[maybe_unused]] std::conditional_t<N::remaps, Rows, Nothing> mapped;
  repeat<size>([&](std::size_t i) {
    v.set(i, nodes.velocity.pack(cell.nodes[i]));
    if constexpr (N::remaps) mapped.set(i, nodes.mapped.pack(cell.nodes[i]));
  });
  const Rows& u = [&]() -> const Rows& {
    if constexpr (N::remaps)
      return mapped;
    else
      return v;
  }();
  const std::conditional_t<takes_velocity, PointVelocities<N, Cell>, Nothing> velocities(numerics, cell,
                                                                                         nodes);
  [[maybe_unused]] StrainStep<T, M::dimension> of_cell;
  if constexpr (Shape::constant_gradient) {
    of_cell = in_plane_step<T, D>([&](std::size_t b) {
      V column(0);
      repeat<size>([&](std::size_t i) {
        column += u.pack(i) * V(dt * cell.gradient(static_cast<int>(b), static_cast<int>(i)));
      });
      std::array<T, V::width> lane;
      column.store(lane.data());
      return lane;
    });
    if constexpr (N::AntiLocking::averages_strain && !K::hoop)
      of_cell.strain =
          add_isotropic(of_cell.strain, T((average.cell_strain[c] - trace(of_cell.strain)) * T(1.0 / 3)));
  }
  P check(0);
  for (std::size_t p = begin; p < end; p += width) {
    const int count = static_cast<int>(std::min<std::size_t>(width, end - p));
    auto x = points.position.template load_repeated<P>(p, count);
    StrainStep<P, M::dimension> inc;
    std::array<P, D> way{};
    [[maybe_unused]] P radial(0);
    if constexpr (Shape::constant_gradient) {
      const auto w = cell.weights(x);
      repeat<size>([&](std::size_t i) { repeat<D>([&](std::size_t d) { way[d] += P(v[i][d]) * w[i]; }); });
      if constexpr (K::hoop) repeat<size>([&](std::size_t i) { radial += P(u[i][0]) * w[i]; });
      repeat<of_cell.strain.size>([&](std::size_t k) { inc.strain[k] = P(of_cell.strain[k]); });
      repeat<of_cell.spin.size()>([&](std::size_t k) { inc.spin[k] = P(of_cell.spin[k]); });
      if constexpr (takes_velocity) velocities.take(cell, points, p, count, w);
    } else {
      const LineSet<P, Cell> line(cell, x);
      keep_in_memory(v), keep_in_memory(u);
      const auto increment = [&](const auto& along) {
        return in_plane_step<P, D>([&](std::size_t b) {
          auto column = along[b];
          for (P& component : column) component = component * P(dt);
          return column;
        });
      };
      if constexpr (takes_velocity && N::Transfer::affine) {
        // Points move with the velocity that they take: one set of sums serves all.
        const auto sums = line_sums<P, D, 2>(v, line.value, {line.slope, line.arm});
        inc = increment(sums.along[0]);
        way = sums.value;
        if constexpr (K::hoop) radial = sums.value[0];
        velocities.take(cell, points, p, count, x, sums.value, sums.along[1]);
      } else {
        const auto sums = line_sums<P, D, 1>(u, line.value, {line.slope});
        inc = increment(sums.along[0]);
        way = N::remaps ? line_sums<P, D, 0>(v, line.value, {}).value : sums.value;
        if constexpr (K::hoop) radial = sums.value[0];
        if constexpr (takes_velocity)
          velocities.take(cell, points, p, count, x,
                          line_sums<P, D, 0>(velocities.taken, line.value, {}).value, {});
      }
    }
    if constexpr (K::hoop) {
      inc.strain[2] = P(dt) * radial * reciprocal(x[0]);
      if constexpr (N::AntiLocking::averages_strain)
        inc.strain =
            add_isotropic(inc.strain, P((P(average.cell_strain[c]) - trace(inc.strain)) * P(1.0 / 3)));
    }
    buffer.store(at + (p - begin), inc);
    repeat<D>([&](std::size_t d) { x[d] += P(dt) * way[d]; });
    points.position.template store<P>(p, count, x);
    P sum = x[0] + x[1];
    if constexpr (D == 3) sum += x[2];
    check += select(lanes_from<P>(count), P(0), sum);
  }
  return lane_sums(std::array<P, 1>{check})[0];
}

}  // namespace detail

/// Gives each point its new velocity (unless `remap` did), updates its stress, history and volume by the law
/// of its body, and moves it with the node velocities. `TracksWork`: whether the work of the stresses is
/// summed.
template <class K, bool TracksWork, class N, class M, class B, class Field, class Average>
DeformSums deform(const N& numerics, const M& mesh, const Blocks& blocks, B& body, const Field& nodes,
                  typename M::scalar dt, Average& average) {
  using T = typename M::scalar;
  constexpr bool weighs = TracksWork && N::AntiLocking::averages_stress;
  using Buffer = StrainBuffer<T, M::dimension, weighs>;
  auto& points = body.points;
  if constexpr (N::AntiLocking::averages_strain)
    average.template compute<K, N>(mesh, blocks, body, nodes, dt);
  return parallel_reduce(
      points.size(), DeformSums{},
      [&](std::size_t chunk_begin, std::size_t chunk_end) {
        const auto law = body.law;  // a copy: its moduli stay in registers
        DeformSums chunk;
        Buffer buffer;
        for (std::size_t begin = chunk_begin; begin < chunk_end; begin += Buffer::capacity) {
          const std::size_t end = std::min(chunk_end, begin + Buffer::capacity);
          for (std::size_t p = begin; p < end;) {
            const Index c = points.cell[p];
            const std::size_t next = std::min<std::size_t>(end, body.cells.run_end(static_cast<Index>(p), c));
            chunk.check += static_cast<double>(detail::move_run<K>(numerics, mesh, c, points, p, next, nodes,
                                                                   dt, average, buffer, p - begin));
            if constexpr (weighs) buffer.store_bearing(p - begin, next - p, body.cell_sums[c].bearing);
            p = next;
          }
          law_pass<TracksWork, N::template width<T>>(law, points, begin, end, buffer, dt, chunk);
        }
        return chunk;
      },
      std::plus<>{});
}

}  // namespace arenite::inline ARENITE_INSTRUCTION_SET
