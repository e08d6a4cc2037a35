// Gather (G2P): points take their velocities from the nodes; MUSL then maps them back once more.
#pragma once

#include <arenite/transfer/scatter.hpp>

namespace arenite {

/// New point velocities (and affine motion) from the node velocities at the step's begin and end. Positions
/// stay: they move with the strains in `deform`, so that all of a step's weights are those of its begin.
template <class N, class M, class B, class Field>
void gather(const N& numerics, const M& mesh, const Blocks& blocks, B& body, const Field& nodes) {
  using Transfer = typename N::Transfer;
  using Cell = typename N::Shape::template Cell<M>;
  using T = typename M::scalar;
  constexpr int D = M::dimension, size = Cell::size;
  auto& points = body.points;
  blocks.for_each([&](Index c) {
    const auto in_cell = body.cells[c];
    if (in_cell.empty()) return;
    const Cell cell(mesh, c);
    Eigen::Matrix<T, D, size> end, change, x_nodes;
    for (int k = 0; k < size; ++k) {
      const Index i = cell.nodes[static_cast<std::size_t>(k)];
      end.col(k) = nodes.velocity[i];
      if constexpr (!Transfer::affine) change.col(k) = nodes.velocity[i] - nodes.start[i];
    }
    if constexpr (Transfer::affine) x_nodes = cell.node_positions();
    for (const Index p : in_cell) {
      const Vec<T, D>& x = points.position[p];
      const auto w = cell.weights(x);
      if constexpr (Transfer::affine) {
        points.velocity[p] = end * w;
        if constexpr (std::same_as<Transfer, Tpic>)
          points.motion[p] = end * cell.gradients(x).transpose();
        else
          points.motion[p] = end * w.asDiagonal() * (x_nodes.colwise() - x).transpose();
      } else {
        const T share = static_cast<T>(numerics.transfer.share);
        points.velocity[p] = share * (points.velocity[p] + change * w) + (1 - share) * (end * w);
      }
    }
  });
}

/// MUSL: momentum of the updated points at the nodes, in `nodes.mapped`. Call `finish_remap` once all bodies
/// of the field have been mapped.
template <class N, class M, class B, class Field>
void remap(const M& mesh, const Blocks& blocks, const B& body, Field& nodes) {
  using Transfer = typename N::Transfer;
  using Cell = typename N::Shape::template Cell<M>;
  using T = typename M::scalar;
  constexpr int D = M::dimension, size = Cell::size;
  const auto& points = body.points;
  blocks.for_each_colored([&](Index c) {
    const auto in_cell = body.cells[c];
    if (in_cell.empty()) return;
    const Cell cell(mesh, c);
    Eigen::Matrix<T, D, size> momentum = Eigen::Matrix<T, D, size>::Zero(), x_nodes;
    if constexpr (Transfer::affine) x_nodes = cell.node_positions();
    for (const Index p : in_cell) {
      const Vec<T, D>& x = points.position[p];
      const auto w = cell.weights(x);
      if constexpr (Transfer::affine) {
        const Mat<T, D> c_p = handed_gradient<Transfer, T, D>(points.motion[p], w, x_nodes, x);
        for (int k = 0; k < size; ++k)
          momentum.col(k) += (points.mass[p] * w[k]) * (points.velocity[p] + c_p * (x_nodes.col(k) - x));
      } else {
        momentum += (points.mass[p] * points.velocity[p]) * w.transpose();
      }
    }
    for (int k = 0; k < size; ++k) nodes.mapped[cell.nodes[static_cast<std::size_t>(k)]] += momentum.col(k);
  });
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
