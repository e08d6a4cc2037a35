// Prescribed: a rigid body whose motion is given in time.
#pragma once
// SPDX-License-Identifier: BSD-3-Clause

#include <array>
#include <concepts>
#include <cstddef>
#include <functional>
#include <utility>

#include <arenite/core/tensor.hpp>
#include <arenite/core/vector_argument.hpp>

namespace arenite::inline ARENITE_INSTRUCTION_SET {

/// A motion given in time: `velocity(t)` returns the velocity {x, y, z}, m/s, at time t, s. No impulse
/// changes it; the work of the drive is recorded. Each velocity is checked when it is requested.
struct Prescribed {
  std::function<std::array<double, 3>(double)> velocity;

  template <class Velocity>
  explicit Prescribed(Velocity v) : velocity{as_function(std::move(v))} {}

 private:
  template <class Velocity>
  static std::function<std::array<double, 3>(double)> as_function(Velocity v) {
    constexpr bool callable = std::is_invocable_r_v<std::array<double, 3>, const Velocity&, double>;
    static_assert(callable,
                  "Prescribed: the velocity must be callable as std::array<double, 3> velocity(double time) "
                  "const, {x, y, z} in m/s");
    if constexpr (callable) return v;
    return {};
  }
};

/// A prescribed motion in D dimensions over scalar T.
template <class T, int D>
struct BoundPrescribed {
  using V = Vec<T, D>;
  static constexpr bool has_mass = false;
  std::function<std::array<double, 3>(double)> velocity;

  explicit BoundPrescribed(Prescribed p) : velocity{std::move(p.velocity)} {}

  V start() const { return V::Zero(); }
  V free_velocity(const V&, const V&, T time, T) const {
    return vector_argument<T, D>("Prescribed.velocity", velocity(static_cast<double>(time)));
  }
  template <class Body>
  V velocity_in_contact(const Body&, const V& free_velocity) const {
    return free_velocity;
  }
  V after(const V& contact_velocity, const V&, const V&, T) const { return contact_velocity; }
  V mean(const V&, const V& after) const { return after; }
  double work(const V&, const V&, const V& mean, const V& total) const {
    return static_cast<double>(total.dot(mean));
  }
  double kinetic_energy(const V&) const { return 0; }
  bool holds(const V&) const { return true; }
};

template <class Traits>
auto bind_part(const Prescribed& motion, const Traits&) {
  return BoundPrescribed<typename Traits::T, Traits::D>(motion);
}

}  // namespace arenite::inline ARENITE_INSTRUCTION_SET
