// Centred stress: forces of elastic bodies on simplices from the stresses of the middle of the step.
#pragma once
// SPDX-License-Identifier: BSD-3-Clause

#include <arenite/law/law.hpp>
#include <arenite/law/pass.hpp>
#include <arenite/mesh/blocks.hpp>
#include <arenite/particles/body.hpp>
#include <arenite/transfer/cell_stress.hpp>
#include <arenite/transfer/simplex/g2p.hpp>

namespace arenite::inline ARENITE_INSTRUCTION_SET {

/// Adds to the forces of a body's nodes what half a step does to its stresses, with the velocities in
/// `nodes.velocity`: those from P2G with the present weights. The points themselves keep their stresses:
/// `g2p` then strains them with the mean of the velocities that they map to the nodes at the start and at the
/// end of the step (`finish_map_back`). The result is the same as with two updates of the stress, one after
/// and one before each motion of the points (USAVG; Nairn 2003, Material point method calculations with
/// explicit cracks), with one pass of the law.
///
/// Points that keep their velocities but move give another velocity gradient to the grid. Their kinetic
/// energy changes by the stress times the gradients with their old and with their new weights, each for half
/// a step. MUSL strains only with the old weights: what the gradient changes by then leaves energy in the
/// stresses, on average, and strains only with the new weights do so as well. With half of each none is left
/// to this order. For laws that are linear: the force then needs only the cells' sums of stress, not the
/// points. (For the hoop strain it uses the mean of the cell.)
template <class K, class Shape, class M, class B, class Field, class T>
void add_half_step(const M& mesh, const Blocks& blocks, const B& body, Field& nodes, T half) {
  using Cell = typename Shape::template Cell<M>;
  using L = decltype(body.law);
  constexpr int D = M::dimension;
  constexpr std::size_t size = Cell::size;
  blocks.for_each_colored([&](Index c) {
    if (body.cells.empty(c)) return;
    const Cell cell(mesh, c);
    const auto& sums = body.cell_sums[c];
    auto step = simplex::cell_step(cell, CellVectors<T, D, size>(cell, nodes.velocity), half);
    if constexpr (K::hoop) {
      repeat<size>([&](std::size_t i) { step.strain[2] += nodes.velocity[cell.nodes[i]][0] * sums.hoop[i]; });
      step.strain[2] *= half / sums.volume;
    }
    const auto& before = body.cell_stress[c];
    Sym<T, D> after = (1 / sums.volume) * before;
    typename L::template History<T> history{};
    step.dt = static_cast<double>(half);
    body.law.update(after, step, history);
    after = (sums.volume * small_exp(trace(step.strain))) * after;
    const Sym<T, D> gain = after - before;
    const simplex::CellForce<T, D> gained(gain);
    repeat<size>([&](std::size_t i) {
      auto force = gained.at(cell.gradient.col(static_cast<int>(i)));
      if constexpr (K::hoop) force += pack4(-gain[2] / sums.volume * sums.hoop[i], T(0), T(0), T(0));
      nodes.sums[cell.nodes[i]].add_slopes(force);
    });
  });
}

}  // namespace arenite::inline ARENITE_INSTRUCTION_SET
