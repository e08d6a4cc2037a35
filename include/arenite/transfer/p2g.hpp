// P2G: the points of a body give their mass, momentum and internal force to a node field.
#pragma once
// SPDX-License-Identifier: BSD-3-Clause

#include <algorithm>
#include <cmath>

#include <arenite/mesh/blocks.hpp>
#include <arenite/particles/body.hpp>
#include <arenite/transfer/product/p2g.hpp>
#include <arenite/transfer/simplex/p2g.hpp>

namespace arenite::inline ARENITE_INSTRUCTION_SET {

/// For each node: sum of w m, w m v (with the affine part), and the internal force -sum V sigma grad N (with
/// the hoop stress in axisymmetry), as in Sulsky, Chen, Schreyer 1994 (doi:10.1016/0045-7825(94)90112-0). The
/// field must have been cleared. Of the body, the cell sums are renewed, where there are points, and where
/// the numerics average stresses, the points of filled cells get the mean. A field without a start state
/// collects mass and momentum with the impulse of the force over the step dt, s.
template <class K, class N, class M, class B, class Field>
void p2g(const N& numerics, const M& mesh, const Blocks& blocks, B& body, Field& nodes,
         [[maybe_unused]] typename M::scalar dt = 0) {
  if constexpr (N::needs_cell_sums) body.cell_sums.resize(mesh.cell_count());
  if constexpr (N::template centres_stress<decltype(body.law)>) body.cell_stress.resize(mesh.cell_count());
  blocks.for_each_colored([&](Index c) {
    if (body.cells.empty(c)) return;
    if constexpr (N::Shape::constant_gradient)
      simplex::p2g<K>(numerics, mesh, body, c, nodes);
    else if constexpr (!Field::has_start_state)
      product::p2g_with_impulse<K>(numerics, mesh, body, c, nodes, dt);
    else
      product::p2g<K>(numerics, mesh, body, c, nodes);
  });
}

/// Node velocities from momentum and force: v = p / m, v^new = v + (f / m + g) dt. Nodes without mass stay at
/// rest. A mass below `mass_floor`, kg, counts as none: a quotient by it has no correct digits in T. So does
/// a `negligible_mass`, but that its velocity is known, without its force.
template <class Field, class T, int D>
void update_grid(Field& nodes, const Vec<T, D>& gravity, T dt, T mass_floor) {
  NodePack<T, D> g(0);
  for (int k = 0; k < D; ++k) g.set(k, gravity[k]);
  parallel_chunks(nodes.size(), [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      const auto& sums = nodes.sums[i];
      // Round-off may leave a negative mass, whose velocity is known as well.
      if ((Field::has_start_state ? std::abs(sums.mass()) : sums.mass()) <= mass_floor) {
        nodes.mass[i] = 0;
        if constexpr (Field::has_start_state) nodes.start.set(i, 0);
        nodes.velocity.set(i, 0);
        continue;
      }
      const T inverse = 1 / sums.mass();
      nodes.mass[i] = sums.mass();
      if constexpr (Field::has_start_state) {
        const NodePack<T, D> start = inverse * sums.momentum_pack();
        nodes.start.set(i, start);
        if (sums.mass() <= negligible_mass(sums)) {
          nodes.mass[i] = 0;
          nodes.velocity.set(i, start + dt * g);
          continue;
        }
        nodes.velocity.set(i, start + dt * (inverse * sums.force_pack() + g));
      } else {
        nodes.velocity.set(i, inverse * sums.momentum_pack() + dt * g);
      }
    }
  });
}

/// The part of the grid update that needs only masses and the momentum from P2G.
template <class Field, class T>
void start_velocities(Field& nodes, T mass_floor) {
  parallel_chunks(nodes.size(), [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      const auto& sums = nodes.sums[i];
      nodes.mass[i] = sums.mass() <= std::max(mass_floor, negligible_mass(sums)) ? T(0) : sums.mass();
      const bool is_known = std::abs(sums.mass()) > mass_floor;
      nodes.velocity.set(i, is_known ? (1 / sums.mass()) * sums.momentum_pack() : 0);
    }
  });
}

}  // namespace arenite::inline ARENITE_INSTRUCTION_SET
