// Prescribed: a rigid body whose motion is given in time.
#pragma once

#include <array>
#include <cstddef>
#include <utility>

#include <arenite/core/tensor.hpp>

namespace arenite::inline ARENITE_INSTRUCTION_SET {

/// A motion given in time: `velocity(t)` returns the velocity {x, y, z}, m/s, at time t, s.
template <class Velocity>
struct Prescribed {
  Velocity velocity;
};
template <class Velocity>
Prescribed(Velocity) -> Prescribed<Velocity>;

/// A prescribed motion in D dimensions over scalar T.
template <class T, int D, class Velocity>
struct BoundPrescribed {
  using V = Vec<T, D>;
  static constexpr bool has_mass = false;
  Velocity velocity;

  explicit BoundPrescribed(Prescribed<Velocity> p) : velocity{std::move(p.velocity)} {}

  V start() const { return V::Zero(); }
  V free_velocity(const V&, const V&, T time, T) const {
    const auto v = velocity(static_cast<double>(time));
    V out;
    for (int k = 0; k < D; ++k) out[k] = static_cast<T>(v[static_cast<std::size_t>(k)]);
    return out;
  }
  template <class Body>
  V velocity_in_contact(const Body&, const V& free_velocity) const {
    return free_velocity;
  }
  V after(const V& met, const V&, const V&, T) const { return met; }
  V mean(const V&, const V& after) const { return after; }
  double drive(const V&, const V&, const V& mean, const V& total) const {
    return static_cast<double>(total.dot(mean));
  }
  double kinetic_energy(const V&) const { return 0; }
  bool holds(const V&) const { return true; }
};

template <class Velocity, class Site>
auto bind_part(const Prescribed<Velocity>& motion, const Site&) {
  return BoundPrescribed<typename Site::T, Site::D, Velocity>(motion);
}

}  // namespace arenite::inline ARENITE_INSTRUCTION_SET
