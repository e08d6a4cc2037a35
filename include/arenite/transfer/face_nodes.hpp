// Nodes beside a grid's faces: the second function of open knots falls to zero at the face with a slope that
// does not fall. They exchange momentum with the nodes on the face.
#pragma once
// SPDX-License-Identifier: BSD-3-Clause

#include <limits>
#include <vector>

#include <arenite/core/scalar.hpp>
#include <arenite/mesh/mesh.hpp>
#include <arenite/transfer/node_field.hpp>

namespace arenite::inline ARENITE_INSTRUCTION_SET {

/// Quadratic splines on open knots, s cell edges from a face: w_0 = (1 - s)^2 of the node on the face, w_1 =
/// 2 s - 3/2 s^2 of the one beside it, whose slope 2 - 3 s does not vanish at the face. Points that lie close
/// to the face, with none further inside, give that node the full force of their stress and next to none of
/// their mass: its frequency has no bound. For a layer with w_1 < w_0 / 2 (s < 0.195) slope^2 / value exceeds
/// the shape's `steepness`, for which the stable step is made. A node with m_1 < m_0 / 2 therefore goes the
/// share 1 - 2 m_1 / m_0 of the way to the velocity of the node on the face, which gives what it gets: linear
/// momentum is kept to round-off, the kinetic energy of the relative motion falls, and its own force moves
/// the node as if it had the mass m_0 / 2. (`Shape::least_beside_face`: that half, 1 for cubic splines.) A
/// body that fills the cells at a face has m_1 = 2 m_0.
///
/// Points exactly on the face leave the node no mass, and the grid update no way to take up its force over
/// the step dt [s]: here is the limit of the exchange as m_1 falls to nothing. (Mapped velocities: dt = 0.)
///
/// One thread: they are nodes of a surface, and few of them are light. Returns how many.
template <class Shape, class M, class Field, class T, int D>
std::size_t redistribute_at_faces(const M& grid, const Field& nodes, NodeVectors<T, D>& velocity, T dt) {
  std::size_t count = 0;
  const auto redistribute = [&](Index face, Index beside) {
    const T m = nodes.mass[beside], on_face = nodes.mass[face],
            enough = static_cast<T>(Shape::least_beside_face) * on_face;
    if (!(m < enough)) return;
    ++count;
    if (m == 0) {
      const auto impulse = impulse_of_forces(nodes.sums[beside], dt);
      velocity.set(beside, velocity.pack(face) + impulse / enough);
      velocity.add(face, impulse / on_face);
      return;
    }
    const auto on = velocity.pack(face), change = (1 - m / enough) * (on - velocity.pack(beside));
    velocity.set(face, on - (m / on_face) * change);
    // Of hardly any mass it is a velocity without a digit that is right, but times the mass.
    if (m * m > std::numeric_limits<T>::epsilon() * enough * enough)
      velocity.add(beside, change);
    else
      velocity.set(beside, on + (m / enough) * (velocity.pack(beside) - on));
  };
  Index stride = 1;
  for (int k = 0; k < D; ++k) {
    const Index nodes_on_axis = Shape::node_count(grid, k), length = stride * nodes_on_axis;
    const Index whole = whole_cells(grid, k), first = first_cell(grid, k), face = Shape::face_node(whole);
    const bool has_low = first == 0, has_high = first + grid.cells(k) == whole;
    for (Index slab = is_periodic<M>(k) ? static_cast<Index>(nodes.size()) : 0;
         slab < static_cast<Index>(nodes.size()); slab += length)
      for (Index i = slab; i < slab + stride; ++i) {
        const Index low = i + face * stride, high = i + (nodes_on_axis - 1 - face) * stride;
        if (has_low) redistribute(low, low + stride);
        if (has_high) redistribute(high, high - stride);
      }
    stride = length;
  }
  return count;
}

}  // namespace arenite::inline ARENITE_INSTRUCTION_SET
