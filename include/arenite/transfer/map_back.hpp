// MUSL mapping: node velocities for the strains, mapped back from the new velocities of the points.
#pragma once
// SPDX-License-Identifier: BSD-3-Clause

#include <arenite/mesh/blocks.hpp>
#include <arenite/transfer/product/map_back.hpp>
#include <arenite/transfer/simplex/map_back.hpp>

namespace arenite::inline ARENITE_INSTRUCTION_SET {

/// Maps the new velocities of a body's points to the nodes, added to `nodes.mapped`: call `finish_map_back`
/// after all bodies of the field. Linear simplices need no pass over the points, which get their velocities
/// in `g2p`. Elsewhere the points get their velocities here, and their momentum is added. Positions stay:
/// they are updated with the strains in `g2p`, so that all weights of a step are those at its start.
template <class N, class M, class B, class Field>
void map_back(const N& numerics, const M& mesh, const Blocks& blocks, B& body, Field& nodes) {
  static_assert(N::maps_back, "map_back: this order of the stress update maps nothing back");
  blocks.for_each_colored([&](Index c) {
    if (body.cells.empty(c)) return;
    if constexpr (N::maps_back_by_points)
      product::map_back(numerics, mesh, body, c, nodes);
    else
      simplex::map_back(numerics, mesh, body, c, nodes);
  });
}

/// Turns the sums into velocities; in a centred field into the mean of the velocities that the points map to
/// the nodes at the start and at the end of the step (see `add_half_step`).
template <class N, class Field>
void finish_map_back([[maybe_unused]] const N& numerics, Field& nodes) {
  parallel_chunks(nodes.size(), [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      if (nodes.mass[i] > 0)
        nodes.mapped.set(i, nodes.mapped.pack(i) / nodes.mass[i]);
      else if constexpr (N::maps_back_by_points)
        nodes.mapped.set(i, nodes.velocity.pack(i));  // of a node without mass: of those around it
      else
        nodes.mapped.set(i, 0);
      if constexpr (!N::maps_back_by_points) {
        if constexpr (requires { numerics.transfer.returned_velocity(nodes, Index{}); })
          nodes.mapped.add(i, numerics.transfer.returned_velocity(nodes, static_cast<Index>(i)));
        else
          nodes.mapped.add(i, nodes.velocity.pack(i));
        if (nodes.centred) nodes.mapped.set(i, (nodes.start.pack(i) + nodes.mapped.pack(i)) / 2);
      }
    }
  });
}

}  // namespace arenite::inline ARENITE_INSTRUCTION_SET
