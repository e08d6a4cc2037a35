// Coulomb's law at a node: the impulse that two velocity fields exchange, with no penetration and limited
// friction.
#pragma once
// SPDX-License-Identifier: BSD-3-Clause

#include <algorithm>
#include <cmath>
#include <limits>

#include <arenite/core/error.hpp>
#include <arenite/core/tensor.hpp>

namespace arenite::inline ARENITE_INSTRUCTION_SET {

/// Friction between two surfaces as an angle, rad, or none at all or unlimited.
class Friction {
 public:
  /// Throws `error` unless 0 <= angle < pi / 2.
  explicit Friction(double angle) : coefficient_{std::tan(angle)} {
    require(angle >= 0 && angle < pi / 2, "Friction.angle", angle, "must lie in [0, pi/2) rad");
  }
  static Friction frictionless() { return Friction(0.0); }
  /// No slip while in contact, whatever the pressure; the surfaces may still part.
  static Friction no_slip() {
    Friction f(0.0);
    f.coefficient_ = std::numeric_limits<double>::infinity();
    return f;
  }
  double coefficient() const { return coefficient_; }
  bool is_no_slip() const { return std::isinf(coefficient_); }

 private:
  double coefficient_;
};

/// Result of Coulomb's law: an impulse, N s, and whether it stops all relative motion, not only that along
/// the normal.
template <class T, int D>
struct CoulombImpulse {
  Vec<T, D> impulse = Vec<T, D>::Zero();
  bool sticks = false;
};

/// Impulse on the first of two masses in contact, of relative velocity `approach` (first minus second), m/s.
/// `normal` is the unit normal out of the second. `mass` is the reduced mass, kg: m1 m2 / (m1 + m2), or m1
/// against a rigid wall. Zero if they separate. The normal velocity is set to zero, the tangential one
/// reduced by at most friction times the normal impulse (Bardenhagen, Brackbill, Sulsky 2000,
/// doi:10.1016/S0045-7825(99)00338-2, eqs. 14 to 20) and by at most the impulse `shear`, N s.
template <class T, int D>
CoulombImpulse<T, D> coulomb(const Vec<T, D>& approach, const Vec<T, D>& normal, T mass,
                             const Friction& friction, T shear = std::numeric_limits<T>::infinity()) {
  const T closing = approach.dot(normal);
  if (!(closing < 0)) return {};
  const Vec<T, D> slip = approach - closing * normal;
  const T speed = slip.norm(),
          most = std::min(static_cast<T>(friction.coefficient()) * -closing, shear / mass);
  if (speed <= most) return {-mass * approach, friction.coefficient() > 0};
  return {-mass * (closing * normal + (most / speed) * slip), false};
}

/// The impulse between two bodies that stick whatever the normal, because one lies inside the other.
template <class T, int D>
CoulombImpulse<T, D> stick(const Vec<T, D>& approach, T mass) {
  return {-mass * approach, true};
}

}  // namespace arenite::inline ARENITE_INSTRUCTION_SET
