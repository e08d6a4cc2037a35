// Springs and dashpots between a rigid body and the world.
#pragma once
// SPDX-License-Identifier: BSD-3-Clause

#include <array>

#include <arenite/core/cold.hpp>
#include <arenite/rigid/pose.hpp>

namespace arenite::inline ARENITE_INSTRUCTION_SET {

/// Springs and dashpots that hold a body to its place and orientation at the start, {x, y, z}. Rotational
/// ones act on the rotation vector (axis times angle), in space below a turn of pi.
struct Anchor {
  std::array<double, 3> stiffness{};             ///< N/m
  std::array<double, 3> damping{};               ///< N s/m
  std::array<double, 3> rotational_stiffness{};  ///< N m/rad; in the plane about z alone
  std::array<double, 3> rotational_damping{};    ///< N m s/rad; in the plane about z alone
};

/// An anchor in D dimensions.
template <int D>
struct BoundAnchor {
  using V = Vec<double, D>;
  using S = Spin<double, D>;
  V stiffness, damping;                        ///< N/m, N s/m
  S rotational_stiffness, rotational_damping;  ///< N m/rad, N m s/rad

  explicit BoundAnchor(const Anchor& a);

  V force(const V& displacement) const;
  /// -(dr/dw)^T K r, r the rotation vector, w the spin: the moment whose work is the energy stored.
  S moment_of_springs(const Orientation<D>& orientation) const;
  double stored_energy(const V& displacement, const Orientation<D>& orientation) const;
};

}  // namespace arenite::inline ARENITE_INSTRUCTION_SET

#ifndef ARENITE_COLD_LIBRARY
#include <arenite/rigid/anchor_cold.hpp>
#endif
