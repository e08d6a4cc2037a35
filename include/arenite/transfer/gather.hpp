// Gather (G2P): points take their velocities from the nodes; MUSL then maps them back once more.
#pragma once

#include <arenite/transfer/scatter.hpp>

namespace arenite {

/// New point velocities (and affine motion) from the node velocities at the step's begin and end; for MUSL
/// the momentum of the updated points goes back to the nodes, into `nodes.mapped`, in the same pass: call
/// `finish_remap` once all bodies of the field have been through. Positions stay: they move with the strains
/// in `deform`, so that all of a step's weights are those of its begin.
template <class N, class M, class B, class Field>
void gather(const N& numerics, const M& mesh, const Blocks& blocks, B& body, Field& nodes) {
  using Transfer = typename N::Transfer;
  using Cell = typename N::Shape::template Cell<M>;
  using T = typename M::scalar;
  constexpr int D = M::dimension, size = Cell::size;
  constexpr bool remaps = N::Order::remaps;
  auto& points = body.points;
  const auto in_cell = [&](Index c) {
    const auto list = body.cells[c];
    if (list.empty()) return;
    const Cell cell(mesh, c);
    detail::Quads<T, size> end = detail::Quads<T, size>::Zero(), change = end, mapped = end;
    [[maybe_unused]] Eigen::Matrix<T, D, size> x_nodes;
    for (int k = 0; k < size; ++k) {
      const Index i = cell.nodes[static_cast<std::size_t>(k)];
      end.col(k).template head<D>() = nodes.velocity[i];
      if constexpr (!Transfer::affine) change.col(k).template head<D>() = nodes.velocity[i] - nodes.start[i];
    }
    if constexpr (Transfer::affine) x_nodes = cell.node_positions();
    for (const Index p : list) {
      const Vec<T, D>& x = points.position[p];
      const auto w = cell.weights(x);
      const Eigen::Matrix<T, 4, 1> v_end = end * w;
      if constexpr (Transfer::affine) {
        points.velocity[p] = v_end.template head<D>();
        if constexpr (std::same_as<Transfer, Tpic>)
          points.motion[p] = end.template topRows<D>() * cell.gradients(x).transpose();
        else
          points.motion[p] = end.template topRows<D>() * w.asDiagonal() * (x_nodes.colwise() - x).transpose();
      } else {
        const T share = static_cast<T>(numerics.transfer.share);
        const Eigen::Matrix<T, 4, 1> v_change = change * w;
        points.velocity[p] = share * (points.velocity[p] + v_change.template head<D>()) +
                             (1 - share) * v_end.template head<D>();
      }
      if constexpr (remaps) detail::add_momentum<Transfer, T, D>(points, p, w, x_nodes, mapped);
    }
    if constexpr (remaps)
      for (int k = 0; k < size; ++k)
        nodes.mapped[cell.nodes[static_cast<std::size_t>(k)]] += mapped.col(k).template head<D>();
  };
  if constexpr (remaps)
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
