// Friction of a frictional law as a policy: the angle of its parameters, or one by point, from rate and
// history.
#pragma once
// SPDX-License-Identifier: BSD-3-Clause

#include <array>
#include <cmath>
#include <concepts>
#include <limits>
#include <tuple>
#include <type_traits>

#include <arenite/law/law.hpp>

namespace arenite::inline ARENITE_INSTRUCTION_SET {

/// Angles of a law's parameters, as a policy is given them.
struct GivenAngles {
  double friction, dilatancy;     ///< rad
  double slope, dilatancy_slope;  ///< their tangents
};

/// History of a policy that depends on the plastic strain, or a base of it: the law sums the strains that
/// `flow` would receive.
template <class T>
struct PlasticStrainHistory {
  T plastic_strain{0};  ///< deviatoric, sum of sqrt(2/3 de:de), -
  static constexpr std::array names{"plastic_strain"};
  constexpr auto members() { return std::tie(plastic_strain); }
  constexpr auto members() const { return std::tie(plastic_strain); }
};

/// The angle of the law's parameters, everywhere and always. Stores nothing.
///
/// Another policy has its own `History<T>` (see law.hpp) and one of
///
///   template <class T, int D>
///   T slope(double given, const StrainStep<T, D>& step, History<T>& history) const;
///   template <class T, int D>
///   T slope(const GivenAngles& given, const StrainStep<T, D>& step, const Sym<T, D>& trial,
///           History<T>& history) const;
///
/// tan(phi) of a step, >= 0; `given` is that of the law's parameters, `step` the part of the step that the
/// matter feels, `trial` the elastic trial stress, Pa. The law then computes a yield surface for each point,
/// with slopes up to tan(1.55). The result for a point may depend only on that point, not on the others of
/// its pack: a `select` for a branch.
///
/// Optional members of a policy:
///
/// - `void follow(const StrainStep<T, D>& step, History<T>& history) const`: called once in each step, before
///   all else: what the history keeps of each step, such as a smoothed rate.
/// - `double least_slope(const GivenAngles& given) const`: a lower bound of the slope. Where all points of a
///   pack lie within its cone, and with cohesion within that of tan(1.55) too, `slope` is not called: it
///   takes a `const History<T>&`, and changes in each step belong in `follow`. Worth it for slopes
///   that cost more than a few operations. Not a number: no bound, and `slope` is called in each step.
/// - `bool implicit() const`: whether the slope is that of the mean stress at the end of the step, which
///   dilatancy and a cut-off change in the return. It must not rise with the pressure, nor with tension. The
///   law then calls `slope`, with a `const History<T>&`, for the stresses of returns too, until that of the
///   surface and that of the stress on it agree; `least_slope` bounds the search.
/// - `T dilatancy_slope(const GivenAngles& given, const History<T>& history) const`: tan(psi) of the point,
///   >= 0; called after `slope`, and never more than its result: plastic flow would else produce energy. A
///   policy without it has the dilatancy of the law's parameters, and must keep its slope above it.
/// - `bool own_dilatancy() const`: whether `dilatancy_slope` is to be called, where constants decide on it.
/// - `void flow(const T& strain, History<T>& history) const`: receives the deviatoric plastic strain of each
///   step, sqrt(2/3 e:e), -; 0 where nothing yields. Hardening or softening with it starts in the next step.
///   A history that is a `PlasticStrainHistory` needs none.
/// - `bool constant() const`: whether its constants make it the same as `ConstantFriction` (a rate term of
///   0). The law then returns to its one surface, with the same results to the bit; the history is kept up.
/// - `void check(const GivenAngles& given) const`: throws `error` if its constants do not go with the law's.
struct ConstantFriction {
  template <class T>
  using History = NoHistory<T>;

  bool constant() const { return true; }
  template <class T, int D>
  T slope(double given, const StrainStep<T, D>&, const NoHistory<T>&) const {
    return T(given);
  }
};

namespace detail {

/// Greatest angle of friction, rad: 88.8 deg. The round-off of a return grows with 1 / (pi/2 - friction); in
/// float it is here 3e-5 of the trial stress.
inline constexpr double greatest_friction = 1.55;

/// `least_slope` of a policy whose constants give it none: all comparisons with it are false.
inline constexpr double no_least_slope = std::numeric_limits<double>::quiet_NaN();

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
