// Transfers: how a point gets its velocity from the nodes and which velocity field it returns to them. And
// the order of the stress update.
#pragma once
// SPDX-License-Identifier: BSD-3-Clause

#include <concepts>

#include <arenite/core/role_names.hpp>
#include <arenite/core/type_family.hpp>
#include <arenite/transfer/aflip.hpp>
#include <arenite/transfer/apic.hpp>
#include <arenite/transfer/flip.hpp>
#include <arenite/transfer/fmpm.hpp>
#include <arenite/transfer/tpic.hpp>
#include <arenite/transfer/xpic.hpp>

namespace arenite::inline ARENITE_INSTRUCTION_SET {

// A transfer is a value of a class, not `final`, with (examples/extend/own_transfer.cpp)
// - `affine`: whether points carry a velocity gradient (`Points::velocity_gradient`) beside their velocity;
// - `fits<Shape>`: whether it goes with the shape functions. Parameters check themselves (`Checked`);
// - `returns_unchanged<Shape>` (optional, else false): whether points return to each node the velocity
//   that they got from it, so that MUSL is USL; a transfer derived from another one must declare it again;
// - `reads_start_state` (optional, else true): whether `gather` reads the velocities of the nodes at the start
//   of the step, `nodes.start`;
// - `in_step(dt)` (optional): the transfer of a step dt, s, where it depends on that;
// - `particle_field(p)`: the `VelocityField` that a point p, a `PointPack`, passes to its nodes (P2G);
// - `iterations()` and `iterated(nodes, i)` (optional, together): how many iterations it needs, and of which vector
//   u_i of node i, as a pack: `nodes.correction` is then sum_{l=1}^{iterations} (I - S+ S)^l u for `gather`,
//   with S the interpolation to the points and S+ the lumped mapping back (`node_correction.hpp`);
// - `returned_velocity(nodes, i)` (optional, else the new velocity): s v_i^old + d_i where points compute
//   v_p = s v_p + sum w_i d_i, as a pack: for MUSL on linear simplices;
// - `increment_at(nodes, i)` (optional): the vector d_i, below, of one node, as a pack: MUSL on linear
//   simplices needs no more of it;
// - `gather(cell, nodes)`: what the points of a cell do in G2P, made once a cell:
//   - `velocity`: the vectors d_i of its nodes that are summed at points, `CellVectors`; or `Nothing`: the
//     new velocities of the nodes;
//   - `second` (optional): vectors s_i of a second sum, sum w_i s_i;
//   - `needs_moments`: whether it needs sum w_i d_i (x_i - x_p)^T, beside sum w_i d_i;
//   - `(cell, p, x, sums)`: updates point p at x from `sums.value` [D], `sums.second` [D] and, if it needs
//     them, `sums.moments()` [D][D], axis by axis; returns the field that it passes to P2G from then on.

/// The members above, as far as they can be asked for without a kernel.
template <class Transfer, class Shape>
concept transfer_type = requires(const Transfer transfer) {
  { Transfer::affine } -> std::convertible_to<bool>;
  { Transfer::template fits<Shape> } -> std::convertible_to<bool>;
}
&&names_particle_field<Transfer>&& names_gather<Transfer>;

/// See above.
template <class Transfer, class Shape>
inline constexpr bool returns_unchanged = [] {
  if constexpr (requires { Transfer::template returns_unchanged<Shape>; })
    return Transfer::template returns_unchanged<Shape>;
  else
    return false;
}();

/// The library's transfers: the one list, from which comes what Python reads, checks and refuses.
using Transfers = TypeFamily<Flip, Apic, Tpic, Aflip, Fmpm, Xpic>;

// The order of the stress update: `maps_back`, whether strains are computed from velocities that the points
// return at the end of the step; `strains_first`, whether they are computed before the forces.

/// Update of stress last, from the nodal velocities of the step (update stress last, USL).
struct Usl {
  static constexpr bool maps_back = false;
  static constexpr bool strains_first = false;
};

/// Update of stress first, from the node velocities at the start of the step, so that
/// the forces are those of the new stress (update stress first, USF; Bardenhagen 2002,
/// doi:10.1006/jcph.2002.7103). It strains as MUSL does, but with the weights after the motion in place of
/// those before it, and conserves energy with FLIP. P2G runs twice.
struct Usf {
  static constexpr bool maps_back = false;
  static constexpr bool strains_first = true;
};

/// Update of stress last, from point velocities mapped back to the nodes once more (modified USL; Sulsky,
/// Zhou, Schreyer 1995, doi:10.1016/0010-4655(94)00170-7): nodes of little mass get no spurious strain. On grids points
/// move with the mapped velocities, too, unless the transfer is affine, so that positions and strains
/// agree (docs/decisions.md, Kernels).
/// Elastic bodies on simplices, without averages, use the stress at the middle of the step.
struct Musl {
  static constexpr bool maps_back = true;
  static constexpr bool strains_first = false;
};

/// An order of the stress update, `MidpointStrain<Usl>`, with the strain at the middle of the step's motion: sym(G - G^2 / 2), G = dt L,
/// where it else is sym(G). Points move along straight lines; what that adds to a length in a rotation by an angle a, a^2 / 2, is then strained,
/// and a body that turns does not swell with each step. With USF, which strains after the motion, sym(G + G^2 / 2).
template <class Order>
struct MidpointStrain : Order {
  static constexpr bool strains_at_middle = true;
};

}  // namespace arenite::inline ARENITE_INSTRUCTION_SET
