// Gather (G2P): points take their velocities from the nodes; MUSL then maps them back once more.
#pragma once

#include <arenite/transfer/point_velocities.hpp>
#include <arenite/transfer/scatter.hpp>

namespace arenite {

namespace detail {

/// Gathers the points of a cell with constant gradients.
template <class N, class M, class B, class Field>
[[gnu::flatten]] void gather_simplex(const N& numerics, const M& mesh, B& body, Index c, Field& nodes) {
  using Cell = typename N::Shape::template Cell<M>;
  using T = typename M::scalar;
  constexpr std::size_t size = Cell::size;
  constexpr int width = N::template width<T>;
  using P = lanes_of<T, width>;
  constexpr bool remaps = N::Order::remaps;
  auto& points = body.points;
  const Cell cell(mesh, c);
  const PointVelocities<N, Cell> velocities(numerics, cell, nodes);
  // Whole packs of a node lie side by side in the sums, so that one load takes what one store wrote.
  constexpr std::size_t stride = NodeRows<T, M::dimension, size>::lanes;
  std::array<P, remaps ? size * stride : 1> mapped;
  repeat<mapped.size()>([&](std::size_t k) { mapped[k] = P(0); });
  body.cells.template for_packs<width>(c, [&](Index first, int count) {
    const auto x = points.position.template load_repeated<P>(first, count);
    const auto w = cell.weights(x);
    [[maybe_unused]] const auto v = velocities.take(cell, points, first, count, w);
    if constexpr (remaps) {
      const P m = load_lanes<P>(points.mass.data() + first, count);
      add_momentum<typename N::Transfer, stride>(cell, points, first, count, m, w, x, v, mapped);
    }
  });
  if constexpr (remaps) {
    const auto total = lane_sums(mapped);
    for (std::size_t i = 0; i < size; ++i)
      nodes.mapped.add(cell.nodes[i], NodePack<T, M::dimension>::load(&total[i * stride]));
  }
}

/// Gathers the points of a cell whose functions are products along the axes.
template <class N, class M, class B, class Field>
[[gnu::flatten]] void gather_product(const N& numerics, const M& mesh, B& body, Index c, Field& nodes) {
  using Cell = typename N::Shape::template Cell<M>;
  using T = typename M::scalar;
  constexpr std::size_t D = M::dimension;
  using Rows = PointRows<T, D, N::template width<T>>;
  using P = typename Rows::P;
  auto& points = body.points;
  const Cell cell(mesh, c);
  const PointVelocities<N, Cell> velocities(numerics, cell, nodes);
  [[maybe_unused]] std::conditional_t<N::Order::remaps, Rows, Nothing> rows;
  const auto spread = [&] {
    if constexpr (N::Order::remaps)
      rows.spread([&](std::size_t i, std::size_t lane, const auto& sum) {
        std::array<T, 8> sums{};
        store_lanes(sums.data() + lane, lane_count<std::remove_cvref_t<decltype(sum)>>, sum);
        nodes.mapped.add(cell.nodes[i], NodePack<T, M::dimension>::load(sums.data()));
      });
  };
  body.cells.template for_packs<Rows::width>(c, [&](Index first, int count) {
    const auto x = points.position.template load_repeated<P>(first, count);
    const LineSet<P, Cell> line(cell, x);
    keep_in_memory(velocities.taken);
    const auto sums = line_sums<P, D, 1>(velocities.taken, line.value, {line.arm});
    [[maybe_unused]] const auto v = velocities.take(points, first, count, sums.value, sums.along[0]);
    if constexpr (N::Order::remaps) {
      if (rows.full()) spread();
      const P m = load_lanes<P>(points.mass.data() + first, count);
      rows.push(count, handed_momentum<typename N::Transfer, Rows>(cell, points, first, count, m, x, v),
                line.value, line.arm, line.slope);
    }
  });
  spread();
}

}  // namespace detail

/// New point velocities (and affine motion) from the node velocities at the step's begin and end; for MUSL
/// the momentum of the updated points goes back to the nodes, into `nodes.mapped`, in the same pass: call
/// `finish_remap` once all bodies of the field have been through. Positions stay: they move with the strains
/// in `deform`, so that all of a step's weights are those of its begin.
template <class N, class M, class B, class Field>
void gather(const N& numerics, const M& mesh, const Blocks& blocks, B& body, Field& nodes) {
  const auto in_cell = [&](Index c) {
    if (body.cells.empty(c)) return;
    if constexpr (N::Shape::constant_gradient)
      detail::gather_simplex(numerics, mesh, body, c, nodes);
    else
      detail::gather_product(numerics, mesh, body, c, nodes);
  };
  if constexpr (N::Order::remaps)
    blocks.for_each_colored(in_cell);
  else
    blocks.for_each(in_cell);
}

/// Turns mapped momentum into velocity.
template <class Field>
void finish_remap(Field& nodes) {
  parallel_chunks(nodes.size(), [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      if (nodes.mass[i] > 0)
        nodes.mapped[i] /= nodes.mass[i];
      else
        nodes.mapped[i].setZero();
    }
  });
}

}  // namespace arenite
