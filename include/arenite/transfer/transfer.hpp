// Transfers: how a point takes its velocity from the nodes and what of its velocity field it hands back.
#pragma once

#include <arenite/core/error.hpp>
#include <arenite/core/scalar.hpp>
#include <arenite/shape/shape.hpp>

namespace arenite::inline ARENITE_INSTRUCTION_SET {

/// PIC and FLIP in any blend: v_p = share (v_p + sum w (v_i^new - v_i^old)) + (1 - share) sum w v_i^new.
/// FLIP (share 1; Brackbill and Ruppel 1986, doi:10.1016/0021-9991(86)90211-1) keeps energy and noise, PIC
/// (share 0; Harlow 1964) damps both, at a rate that grows with the number of steps.
struct Flip {
  static constexpr bool affine = false;
  double share = 1.0;  ///< share of FLIP, 0 to 1
  void check() const { require(share >= 0 && share <= 1, "Flip.share", share, "must lie in [0, 1]"); }
  template <class Shape>
  static constexpr bool fits = true;
};

/// Affine particle-in-cell (Jiang et al. 2015, doi:10.1145/2766996): a point takes B = sum w v_i (x_i -
/// x_p)^T, carries C = B D^-1, D = sum w (x_i - x_p)(x_i - x_p)^T, and hands back w (v_p + C (x_i - x_p)).
/// Keeps angular momentum to round-off where D is the same everywhere: not in the outermost cells of a grid.
struct Apic {
  static constexpr bool affine = true;
  void check() const {}
  /// D is singular for a point at a node of a linear simplex.
  template <class Shape>
  static constexpr bool fits = !Shape::constant_gradient;
};

/// Taylor particle-in-cell: a point carries the velocity gradient L and hands back w (v_p + L (x_i - x_p))
/// (Wallstedt and Guilkey 2007, doi:10.1016/j.jcp.2007.08.023, their velocity projection). No inertia tensor
/// to invert.
struct Tpic {
  static constexpr bool affine = true;
  void check() const {}
  template <class Shape>
  static constexpr bool fits = Shape::constant_gradient;
};

/// Update of stress last, from the nodal velocities of the step (update stress last, USL).
struct Usl {
  static constexpr bool remaps = false;
};

/// Update of stress last, from point velocities mapped back to the nodes once more (modified USL; Sulsky,
/// Zhou, Schreyer 1995, doi:10.1016/0010-4655(94)00170-7): nodes of little mass get no spurious strain.
/// Elastic bodies on simplices, without averages, take their stress at the middle of the step
/// (`add_half_step`).
struct Musl {
  static constexpr bool remaps = true;
};

}  // namespace arenite::inline ARENITE_INSTRUCTION_SET
