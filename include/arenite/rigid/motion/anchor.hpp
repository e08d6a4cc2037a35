// Springs and dashpots between a rigid body and the world.
#pragma once
// SPDX-License-Identifier: BSD-3-Clause

#include <array>
#include <cmath>
#include <string>

#include <arenite/core/error.hpp>
#include <arenite/rigid/body/pose.hpp>

namespace arenite::inline ARENITE_INSTRUCTION_SET {

/// Springs and dashpots that tie a body to its place and orientation at the start, {x, y, z}. Rotational
/// ones act on the rotation vector (axis times angle), in space below a turn of pi.
struct Anchor {
  std::array<double, 3> stiffness{};  ///< along each axis, N/m, >= 0
  std::array<double, 3> damping{};    ///< along each axis, N s/m, >= 0
  std::array<double, 3>
      rotational_stiffness{};  ///< about each axis, N m/rad, >= 0; in the plane only about z
  std::array<double, 3>
      rotational_damping{};  ///< about each axis, N m s/rad, >= 0; in the plane only about z
};

/// An anchor in D dimensions.
template <int D>
struct BoundAnchor {
  using V = Vec<double, D>;
  using S = Spin<double, D>;
  V stiffness, damping;                        ///< N/m, N s/m
  S rotational_stiffness, rotational_damping;  ///< N m/rad, N m s/rad

  explicit BoundAnchor(const Anchor& a) {
    for (std::size_t k = 0; k < D; ++k) {
      stiffness[static_cast<int>(k)] = checked("Free.anchor.stiffness", a.stiffness[k]);
      damping[static_cast<int>(k)] = checked("Free.anchor.damping", a.damping[k]);
    }
    for (std::size_t k = D == 2 ? 2 : 0; k < 3; ++k) {
      const int at = D == 2 ? 0 : static_cast<int>(k);
      rotational_stiffness[at] = checked("Free.anchor.rotational_stiffness", a.rotational_stiffness[k]);
      rotational_damping[at] = checked("Free.anchor.rotational_damping", a.rotational_damping[k]);
    }
  }

  V force(const V& displacement) const { return -stiffness.cwiseProduct(displacement); }
  /// -(dr/dw)^T K r, r the rotation vector, w the spin: the moment whose work is the energy stored.
  S moment_of_springs(const Orientation<D>& orientation) const {
    const S r = orientation.rotation_vector(), pull = rotational_stiffness.cwiseProduct(r);
    if constexpr (D == 2) {
      return -pull;
    } else {
      const double angle = r.norm();
      const double c = angle < 1e-3
                           ? 1.0 / 12
                           : (1 - angle / 2 * std::cos(angle / 2) / std::sin(angle / 2)) / (angle * angle);
      return -(pull + r.cross(pull) / 2 + c * r.cross(r.cross(pull)));
    }
  }
  double stored_energy(const V& displacement, const Orientation<D>& orientation) const {
    const S r = orientation.rotation_vector();
    return (displacement.dot(stiffness.cwiseProduct(displacement)) +
            r.dot(rotational_stiffness.cwiseProduct(r))) /
           2;
  }
  bool has_springs() const { return !(stiffness.isZero(0) && rotational_stiffness.isZero(0)); }

 private:
  static double checked(const char* name, double value) {
    require(value >= 0 && std::isfinite(value), name, value, "must not be negative");
    return value;
  }
};

}  // namespace arenite::inline ARENITE_INSTRUCTION_SET
