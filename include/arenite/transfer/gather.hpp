// Gather (G2P): points take their velocities from the nodes; MUSL then maps them back once more.
#pragma once

#include <arenite/transfer/scatter.hpp>
#include <arenite/transfer/tensor_product.hpp>

namespace arenite {

namespace detail {

/// Gathers the points of one cell.
template <class N, class M, class B, class Field>
[[gnu::flatten]] void gather_cell([[maybe_unused]] const N& numerics, const M& mesh, B& body, Index c,
                                  Field& nodes) {
  using Transfer = typename N::Transfer;
  using Cell = typename N::Shape::template Cell<M>;
  using T = typename M::scalar;
  constexpr std::size_t D = M::dimension, size = Cell::size;
  constexpr int width = N::template width<T>;
  using P = lanes_of<T, width>;
  constexpr bool remaps = N::Order::remaps;
  auto& points = body.points;
  const Cell cell(mesh, c);
  // What a point keeps of its velocity, and what it adds to that: PIC and FLIP are both linear in the nodes.
  T kept = 0;
  if constexpr (!Transfer::affine) kept = static_cast<T>(numerics.transfer.share);
  using V = NodePack<T, static_cast<int>(D)>;
  NodeRows<T, static_cast<int>(D), size> taken;
  repeat<size>([&](std::size_t i) {
    V value = nodes.velocity.pack(cell.nodes[i]);
    if constexpr (!Transfer::affine) value -= V(kept) * nodes.start.pack(cell.nodes[i]);
    taken.set(i, value);
  });
  std::array<P, remaps ? size * D : 1> mapped;
  repeat<mapped.size()>([&](std::size_t k) { mapped[k] = P(0); });
  body.cells.template for_packs<width>(c, [&](Index first, int count) {
    const auto x = points.position.template load_repeated<P>(first, count);
    [[maybe_unused]] const auto w = cell.weights(x);
    std::array<P, D> v{};
    if constexpr (!Transfer::affine) {
      v = points.velocity.template load<P>(first, count);
      repeat<D>([&](std::size_t d) { v[d] = v[d] * P(kept); });
    }
    if constexpr (std::same_as<Transfer, Apic>) {
      const auto value = cell.line_values(x);
      auto arm = cell.ways(x);
      repeat<D>([&](std::size_t a) { repeat<3>([&](std::size_t i) { arm[a][i] *= value[a][i]; }); });
      const auto sums = line_sums<P, D>(taken, value, arm);
      v = sums.value;
      std::array<P, D * D> motion;
      repeat<D * D>([&](std::size_t k) { motion[k] = sums.along[k / D][k % D]; });
      points.motion.template store<P>(first, count, motion);
    } else {
      repeat<size>([&](std::size_t i) { repeat<D>([&](std::size_t d) { v[d] += w[i] * P(taken[i][d]); }); });
      if constexpr (std::same_as<Transfer, Tpic>)
        points.motion.template store<P>(first, count, taken_gradient<P, D>(cell, taken));
    }
    points.velocity.template store<P>(first, count, v);
    if constexpr (remaps) {
      const P m = load_lanes<P>(points.mass.data() + first, count);
      add_momentum<Transfer, D>(cell, points, first, count, m, w, x, v, mapped);
    }
  });
  if constexpr (remaps) {
    const auto total = lane_sums(mapped);
    for (std::size_t i = 0; i < size; ++i)
      nodes.mapped.add(cell.nodes[i], NodePack<T, D>::load(&total[i * D]));
  }
}

}  // namespace detail

/// New point velocities (and affine motion) from the node velocities at the step's begin and end; for MUSL
/// the momentum of the updated points goes back to the nodes, into `nodes.mapped`, in the same pass: call
/// `finish_remap` once all bodies of the field have been through. Positions stay: they move with the strains
/// in `deform`, so that all of a step's weights are those of its begin.
template <class N, class M, class B, class Field>
void gather(const N& numerics, const M& mesh, const Blocks& blocks, B& body, Field& nodes) {
  const auto in_cell = [&](Index c) {
    if (!body.cells.empty(c)) detail::gather_cell(numerics, mesh, body, c, nodes);
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
