// Node sweeps: vectors of the nodes mapped to the points and back, for transfers that ask for it (XPIC,
// FMPM).
#pragma once
// SPDX-License-Identifier: BSD-3-Clause

#include <arenite/mesh/blocks.hpp>
#include <arenite/transfer/product/sweep.hpp>
#include <arenite/transfer/simplex/sweep.hpp>

namespace arenite::inline ARENITE_INSTRUCTION_SET {

/// Before the first sweep: the residual is what the transfer has swept, the correction zero.
template <class N, class Field>
void start_sweeps(const N& numerics, Field& nodes) {
  parallel_chunks(nodes.size(), [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      nodes.residual.set(i, numerics.transfer.swept(nodes, static_cast<Index>(i)));
      nodes.correction[i].setZero();
      nodes.given[i].setZero();
    }
  });
}

/// What the points of a body hand back of the residual, added to `nodes.given`: call `finish_sweep` once all
/// bodies of the field have been through.
template <class N, class M, class B, class Field>
void sweep(const N&, const M& mesh, const Blocks& blocks, const B& body, Field& nodes) {
  blocks.for_each_colored([&](Index c) {
    if (body.cells.empty(c)) return;
    if constexpr (N::Shape::constant_gradient)
      simplex::sweep(mesh, body, c, nodes);
    else
      product::sweep<N>(mesh, body, c, nodes);
  });
}

/// r <- (I - S+ S) r.
template <class N, class Field>
void finish_sweep(const N&, Field& nodes) {
  parallel_chunks(nodes.size(), [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      if (!(nodes.mass[i] > 0))
        nodes.residual[i].setZero();
      else if constexpr (N::Shape::constant_gradient)
        nodes.residual[i] = -nodes.given[i] / nodes.mass[i];
      else
        nodes.residual[i] -= nodes.given[i] / nodes.mass[i];
      nodes.given[i].setZero();
    }
  });
}

/// Adds the residual, of which constraints have taken their part, to the correction.
template <class Field>
void add_residual(Field& nodes) {
  parallel_chunks(nodes.size(), [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) nodes.correction[i] += nodes.residual[i];
  });
}

}  // namespace arenite::inline ARENITE_INSTRUCTION_SET
