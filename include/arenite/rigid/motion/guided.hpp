// Guided: a rigid body that slides along one axis under forces.
#pragma once
// SPDX-License-Identifier: BSD-3-Clause

#include <array>
#include <cmath>
#include <limits>
#include <utility>

#include <arenite/core/error.hpp>
#include <arenite/core/tensor.hpp>
#include <arenite/core/vector_argument.hpp>
#include <arenite/functions/place_function.hpp>

namespace arenite::inline ARENITE_INSTRUCTION_SET {

/// A mass that slides along one axis without friction, under gravity, a load and the contact forces (the
/// paper's eqs. 1 to 4).
struct Guided {
  /// Of what the scene models (a slice, a metre, the full circle), kg; required, positive.
  double mass = std::numeric_limits<double>::quiet_NaN();
  std::array<double, 3> axis{0, 1, 0};  ///< direction of the guide, -, any; its length does not count
  double velocity = 0;                  ///< initial velocity along the axis, m/s, any
  /// External force along the axis, N; a step takes that of its start.
  ScalarFunction load = 0.0;
};

namespace detail {

/// Speed along the guide that balances the impulses: f(s) = M (s - trial) + axis . sum J(s) = 0. f is made of
/// pieces that are straight (or nearly so, with friction in three dimensions), whose slopes may differ by as
/// much as soil and body: Newton steps on the pieces, inside a bracket that is halved where they leave it or
/// do not get ahead.
template <class R, class V, class T>
T balance_speed(const R& body, const V& axis, T trial, T mass) {
  T soil = 0;
  for (const auto& t : body.touched_nodes) soil += t.mass_ratio * t.mass;
  const auto contact_impulse = [&](T s) {
    T sum = 0;
    for (const auto& t : body.touched_nodes) sum += body.impulse_at(t, s * axis).dot(axis);
    return sum;
  };
  constexpr T round_off = std::numeric_limits<T>::epsilon();
  T s = trial, impulse = contact_impulse(s), f = impulse;
  if (f == 0) return trial;
  const T sign = f > 0 ? T(1) : T(-1);
  T close = trial;               // f has the sign of the start here, and the other one (or none) at `far`
  T distant = trial - f / mass;  // where only the body's mass would balance the impulse at the trial speed
  T before = std::numeric_limits<T>::infinity();
  for (int k = 0; k < 200; ++k) {
    const T h = -sign * std::sqrt(round_off) * std::max(std::abs(s - trial), std::abs(f) / (mass + soil));
    const T slope = mass + (contact_impulse(s + h) - impulse) / h;
    T next = s - f / slope;
    if (!((next - close) * (next - distant) < 0) || 2 * std::abs(f) > before)
      next = close + (distant - close) / 2;
    before = std::abs(f);
    const T change = std::abs(next - s);
    s = next;
    impulse = contact_impulse(s);
    f = mass * (s - trial) + impulse;
    (f * sign > 0 ? close : distant) = s;
    if (f == 0 || change <= 4 * round_off * std::abs(s - trial)) break;
  }
  return s;
}

}  // namespace detail

/// A guided motion in D dimensions over scalar T.
template <class T, int D>
struct BoundGuided {
  using V = Vec<T, D>;
  static constexpr bool has_mass = true;
  double mass;          ///< kg
  ScalarFunction load;  ///< N
  V axis;               ///< unit vector of the guide
  T speed;              ///< at the start, m/s

  /// `hoop`: in axisymmetry the guide is the axis.
  explicit BoundGuided(const Guided& g, bool hoop = false)
      : mass{g.mass}, load{g.load}, speed{static_cast<T>(g.velocity)} {
    require(g.mass > 0 && std::isfinite(g.mass), "Guided.mass", g.mass, "must be given, positive");
    require(std::isfinite(g.velocity), "Guided.velocity", g.velocity, "must be finite");
    require(load.is_uniform(), "Guided.load", "f(x, t)", "must be a number or a function of time");
    if (load.is_constant()) {
      const double force = load({}, 0);
      require(std::isfinite(force), "Guided.load", force, "must be finite");
    }
    axis = direction_argument<T, D>("Guided.axis", g.axis);
    require(!hoop || axis[0] == 0, "Guided.axis", vector_text(axis),
            "must be the axis of symmetry (0, 1) in an axisymmetric scene");
    axis.normalize();
  }

  V start() const { return speed * axis; }
  /// With the load at the start of the step.
  V free_velocity(const V& before, const V& acceleration, T time, T dt) const {
    const double begin = static_cast<double>(time) - static_cast<double>(dt);
    const double force = value_at<double, D>(load, Vec<double, D>::Zero(), begin, "Guided.load");
    const T along = acceleration.dot(axis) + static_cast<T>(force / mass);
    return before + dt * along * axis;
  }
  template <class Body>
  V velocity_in_contact(const Body& body, const V& free_velocity) const {
    if constexpr (Body::coupling_through_centre)
      return free_velocity;  // `after` corrects it: eq. (4)
    else
      return detail::balance_speed(body, axis, free_velocity.dot(axis), static_cast<T>(mass)) * axis;
  }
  /// The remainder of the balance is given to the body, unless it is round-off of the impulses, which would
  /// give a very light body a large velocity.
  V after(const V& contact_velocity, const V& free_velocity, const V& total, T magnitudes) const {
    const V change = contact_velocity - free_velocity;
    const T m = static_cast<T>(mass), left = m * change.dot(axis) + total.dot(axis);
    const bool round_off = !(std::abs(left) > 16 * std::numeric_limits<T>::epsilon() * magnitudes);
    return round_off ? contact_velocity : V(free_velocity - (total.dot(axis) / m) * axis);
  }
  V mean(const V& before, const V& after) const { return (before + after) / 2; }
  /// For the contact of rigid bodies (`RigidContact`): change of the velocity by an impulse; `added`: how the
  /// impulse of the matter opposes the velocity, as a mass.
  Mat<double, D> mobility(const Mat<double, D>& added) const {
    const Vec<double, D> along = axis.template cast<double>();
    return along * along.transpose() / (mass + along.dot(added * along));
  }
  double work(const V& before, const V& free_velocity, const V& mean, const V&) const {
    const V change = free_velocity - before;
    return static_cast<double>(static_cast<T>(mass) * change.dot(mean));
  }
  double kinetic_energy(const V& v) const { return 0.5 * mass * static_cast<double>(v.squaredNorm()); }
  bool holds(const V& g) const { return std::abs(axis.dot(g)) <= 1e-6 * g.norm(); }
};

template <class Traits>
auto bind_part(const Guided& motion, const Traits&) {
  return BoundGuided<typename Traits::T, Traits::D>(motion, Traits::Kinematics::hoop);
}

}  // namespace arenite::inline ARENITE_INSTRUCTION_SET
