// Node correction: the sum of (I - S+ S)^l u over iterations l, in which a vector of the nodes is mapped to the
// points and back; for transfers that ask for it (XPIC, FMPM).
#pragma once
// SPDX-License-Identifier: BSD-3-Clause

#include <arenite/mesh/blocks.hpp>
#include <arenite/transfer/product/map_residual.hpp>
#include <arenite/transfer/simplex/map_residual.hpp>

namespace arenite::inline ARENITE_INSTRUCTION_SET {

/// Before the first iteration: the residual is the transfer's u, the correction zero.
template <class N, class Field>
void start_correction(const N& numerics, Field& nodes) {
  parallel_chunks(nodes.size(), [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      nodes.residual.set(i, numerics.transfer.iterated(nodes, static_cast<Index>(i)));
      nodes.correction[i].setZero();
      nodes.mapped_residual[i].setZero();
    }
  });
}

/// Maps the residual to the points of a body and back, added to `nodes.mapped_residual`: call
/// `finish_residual` after all bodies of the field.
template <class N, class M, class B, class Field>
void map_residual(const N&, const M& mesh, const Blocks& blocks, const B& body, Field& nodes) {
  blocks.for_each_colored([&](Index c) {
    if (body.cells.empty(c)) return;
    if constexpr (N::Shape::constant_gradient)
      simplex::map_residual(mesh, body, c, nodes);
    else
      product::map_residual<N>(mesh, body, c, nodes);
  });
}

/// r <- (I - S+ S) r.
template <class N, class Field>
void finish_residual(const N&, Field& nodes) {
  parallel_chunks(nodes.size(), [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      if (!(nodes.mass[i] > 0))
        nodes.residual[i].setZero();
      else if constexpr (N::Shape::constant_gradient)
        nodes.residual[i] = -nodes.mapped_residual[i] / nodes.mass[i];
      else
        nodes.residual[i] -= nodes.mapped_residual[i] / nodes.mass[i];
      nodes.mapped_residual[i].setZero();
    }
  });
}

/// Adds the residual, to which constraints have been applied, to the correction.
template <class Field>
void add_residual(Field& nodes) {
  parallel_chunks(nodes.size(), [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) nodes.correction[i] += nodes.residual[i];
  });
}

}  // namespace arenite::inline ARENITE_INSTRUCTION_SET
