// Coulomb's law at a node: the impulse that two velocity fields exchange, with no penetration and limited
// friction.
#pragma once

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

/// Whether friction holds two surfaces that meet with relative velocity `approach`, m/s: the impulse that
/// stops the approach along `normal` (unit) allows one that stops all slip.
template <class T, int D>
bool sticks(const Vec<T, D>& approach, const Vec<T, D>& normal, const Friction& friction) {
  const T closing = approach.dot(normal);
  if (!(closing < 0) || friction.coefficient() == 0) return false;
  return friction.is_no_slip() ||
         (approach - closing * normal).norm() <= static_cast<T>(friction.coefficient()) * -closing;
}

/// Impulse, N s, on the first of two masses that meet with relative velocity `approach` (first less second),
/// m/s. `normal` is the unit normal out of the second. `mass` is what an impulse has to move, kg: m1 m2 / (m1
/// + m2), or m1 against a rigid wall. Zero if they part. The normal velocity is taken to zero, the tangential
/// one reduced by at most friction times the normal impulse (Bardenhagen, Brackbill, Sulsky 2000,
/// doi:10.1016/S0045-7825(99)00338-2, eqs. 14 to 20).
template <class T, int D>
Vec<T, D> coulomb_impulse(const Vec<T, D>& approach, const Vec<T, D>& normal, T mass,
                          const Friction& friction) {
  const T closing = approach.dot(normal);
  if (!(closing < 0)) return Vec<T, D>::Zero();
  const Vec<T, D> slip = approach - closing * normal;
  const T speed = slip.norm();
  if (friction.is_no_slip() || speed <= static_cast<T>(friction.coefficient()) * -closing)
    return -mass * approach;
  return -mass * (closing * normal + (static_cast<T>(friction.coefficient()) * -closing / speed) * slip);
}

}  // namespace arenite::inline ARENITE_INSTRUCTION_SET
