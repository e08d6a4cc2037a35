// Motion of a rigid body: guided along an axis under forces, or prescribed.
#pragma once

#include <array>
#include <cmath>
#include <limits>

#include <arenite/contact/coulomb.hpp>
#include <arenite/core/error.hpp>
#include <arenite/core/tensor.hpp>

namespace arenite::inline ARENITE_INSTRUCTION_SET {

/// A mass that slides along one axis without friction, under gravity, a load and the contact forces (the
/// paper's eqs. 1 to 4).
struct Guided {
  double mass = std::numeric_limits<double>::quiet_NaN();  ///< kg: that of what the scene models (a slice, a
                                                           ///< metre, the full circle)
  std::array<double, 3> axis{0, 1, 0};                     ///< direction of the guide; any length
  double velocity = 0;                                     ///< initial velocity along the axis, m/s
  double load = 0;                                         ///< external force along the axis, N
  static constexpr bool free = true;
  void check() const {
    require(mass > 0 && std::isfinite(mass), "Guided.mass", mass, "must be given, positive");
    require(std::isfinite(velocity), "Guided.velocity", velocity, "must be finite");
    require(std::isfinite(load), "Guided.load", load, "must be finite");
  }
};

/// A motion given in time: `velocity(t)` returns the velocity {x, y, z}, m/s, at time t, s.
template <class Velocity>
struct Prescribed {
  Velocity velocity;
  static constexpr bool free = false;
  void check() const {}
};
template <class Velocity>
Prescribed(Velocity) -> Prescribed<Velocity>;

/// Contact by rigid nodal velocity: a touched node may not move into the body, whatever the masses. The
/// body's new velocity and all impulses are found together, so that a light body is as stable as a heavy one.
struct RigidVelocity {
  static constexpr bool through_centre_of_mass = false;
};

/// Contact through the centre-of-mass velocity of the soil's and the body's nodal mass (the paper's choice):
/// softer, and nodes may move into the body. Needs a `MeshSurface`, which spreads the body's mass over its
/// nodes.
struct CentreOfMass {
  static constexpr bool through_centre_of_mass = true;
};

/// What `rigid` makes: surface, motion, friction and kind of contact of one rigid body.
template <class Surface_, class Motion_, class Coupling_ = RigidVelocity>
struct Rigid {
  using Surface = Surface_;
  using Motion = Motion_;
  using Coupling = Coupling_;
  Surface surface;
  Motion motion;
  Friction friction;
  Coupling coupling{};
};

/// A rigid body for `rigids(...)`.
template <class Surface, class Motion, class Coupling = RigidVelocity>
Rigid<Surface, Motion, Coupling> rigid(Surface surface, Motion motion, Friction friction,
                                       Coupling coupling = {}) {
  return {std::move(surface), std::move(motion), friction, coupling};
}

}  // namespace arenite::inline ARENITE_INSTRUCTION_SET
