// Friction of a frictional law as a policy: the angle of its parameters, or one by point, from rate and
// history.
#pragma once

#include <cmath>
#include <concepts>

#include <arenite/law/law.hpp>

namespace arenite::inline ARENITE_INSTRUCTION_SET {

/// The angle of the law's parameters, everywhere and always. Stores nothing.
///
/// Another policy has a `History<T>` of its own (see law.hpp) and
///
///   template <class T, int D>
///   T slope(double given, const StrainStep<T, D>& step, History<T>& history) const;
///
/// tan(phi) of a step, >= 0; `given` is that of the law's parameters, `step` what the matter feels of the
/// step. The law then computes its yield surface anew for each point, with slopes up to tan(1.55). A slope
/// that hardens or softens with strain keeps the strain in its history. It should not fall below the tangent
/// of the dilatancy: plastic flow would then produce energy.
///
/// Optional members of a policy:
///
/// - `bool constant() const`: whether its constants make it the same as `ConstantFriction` (a rate term of
///   0). The law then returns to its one surface, with the same results to the bit; the history is kept up.
struct ConstantFriction {
  template <class T>
  using History = NoHistory<T>;
};

namespace detail {

/// Whether a policy by point gives the law's own angle everywhere.
template <class Friction>
bool same_as_constant(const Friction& friction) {
  if constexpr (requires { friction.constant(); })
    return friction.constant();
  else
    return false;
}

/// Sine, cosine and tangent of an angle of friction: numbers N of one angle, or packs of one for each point.
template <class N>
struct FrictionAngle {
  N sin, cos, tan;
};
inline FrictionAngle<double> friction_angle(double angle) {
  return {std::sin(angle), std::cos(angle), std::tan(angle)};
}
template <class T>
FrictionAngle<T> friction_of_slope(const T& slope) {
  const T cos = reciprocal_root(T(T(1) + slope * slope));
  return {slope * cos, cos, slope};
}

}  // namespace detail
}  // namespace arenite::inline ARENITE_INSTRUCTION_SET
