// Remap (MUSL): node velocities for the strains, as the points would hand them back.
#pragma once

#include <arenite/transfer/point_velocities.hpp>
#include <arenite/transfer/scatter.hpp>

namespace arenite::inline ARENITE_INSTRUCTION_SET {

namespace detail {

/// Hands back the velocities of a cell's points without reading them. What a point takes is linear in the
/// nodes': v_p = s v_p + sum_j w_j d_j with d_j = v_j - s v_j^old and FLIP's share s, so that node i gets
/// sum_p m w_i v_p = s m_i v_i^old + sum_j M_ij d_j, M_ij = sum_p m w_i w_j. Since sum_j M_ij = m_i, that is
/// m_i v_i + sum_j M_ij (d_j - d_i): what is added to `nodes.mapped` is the second term, an exchange along
/// each edge.
template <class N, class M, class B, class Field>
[[gnu::flatten]] void remap_simplex(const N& numerics, const M& mesh, const B& body, Index c, Field& nodes) {
  using T = typename M::scalar;
  constexpr std::size_t size = M::dimension + 1;
  using V = NodePack<T, M::dimension>;
  const auto& node = mesh.nodes(c);
  const V share(static_cast<T>(numerics.transfer.share));
  std::array<V, size> taken, gain;
  repeat<size>([&](std::size_t i) {
    taken[i] = nodes.velocity.pack(node[i]) - share * nodes.start.pack(node[i]);
    gain[i] = V(0);
  });
  const auto& edge_mass = body.cell_sums[c].edge_mass;
  for_each_edge<size>([&](std::size_t e, std::size_t i, std::size_t j) {
    const V exchanged = V(edge_mass[e]) * (taken[j] - taken[i]);
    gain[i] += exchanged;
    gain[j] -= exchanged;
  });
  repeat<size>([&](std::size_t i) { nodes.mapped.add(node[i], gain[i]); });
}

/// Gives the points of a cell whose functions are products along the axes their new velocities, and hands
/// these back.
template <class N, class M, class B, class Field>
[[gnu::flatten]] void remap_product(const N& numerics, const M& mesh, B& body, Index c, Field& nodes) {
  using Cell = typename N::Shape::template Cell<M>;
  using T = typename M::scalar;
  constexpr std::size_t D = M::dimension;
  using Rows = PointRows<T, D, N::template width<T>>;
  using P = typename Rows::P;
  auto& points = body.points;
  const Cell cell(mesh, c);
  const PointVelocities<N, Cell> velocities(numerics, cell, nodes);
  Rows rows;
  const auto spread = [&] {
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
    const auto v = velocities.take(cell, points, first, count, x, sums.value, sums.along[0]);
    if (rows.full()) spread();
    const P m = load_lanes<P>(points.mass.data() + first, count);
    rows.push(count, handed_momentum<typename N::Transfer, Rows>(points, first, count, m, v), line.value,
              line.arm, line.slope);
  });
  spread();
}

}  // namespace detail

/// What the points of a body would hand back of their new velocities, added to `nodes.mapped`: call
/// `finish_remap` once all bodies of the field have been through. Linear simplices need no pass over the
/// points, who take their velocities in `deform`; in all else they take them here, and the momentum that they
/// hand back is added. Positions stay: they move with the strains in `deform`, so that all of a step's
/// weights are those of its begin.
template <class N, class M, class B, class Field>
void remap(const N& numerics, const M& mesh, const Blocks& blocks, B& body, Field& nodes) {
  static_assert(N::remaps, "remap: this order of the stress update maps nothing back");
  blocks.for_each_colored([&](Index c) {
    if (body.cells.empty(c)) return;
    if constexpr (N::remaps_by_points)
      detail::remap_product(numerics, mesh, body, c, nodes);
    else
      detail::remap_simplex(numerics, mesh, body, c, nodes);
  });
}

/// Turns what was added into velocity. `Centred`: into the mean of what the points hand to the nodes at the
/// begin and at the end of the step (see `add_half_step`).
template <bool Centred, class N, class Field>
void finish_remap(const N&, Field& nodes) {
  parallel_chunks(nodes.size(), [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      if (nodes.mass[i] > 0)
        nodes.mapped[i] /= nodes.mass[i];
      else
        nodes.mapped[i].setZero();
      if constexpr (!N::remaps_by_points) nodes.mapped[i] += nodes.velocity[i];
      if constexpr (Centred) nodes.mapped[i] = (nodes.start[i] + nodes.mapped[i]) / 2;
    }
  });
}

}  // namespace arenite::inline ARENITE_INSTRUCTION_SET
