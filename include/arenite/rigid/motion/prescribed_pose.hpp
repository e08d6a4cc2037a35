// PrescribedPose: a rigid body whose motion and rotation are given in time.
#pragma once
// SPDX-License-Identifier: BSD-3-Clause

#include <array>
#include <utility>

#include <arenite/core/vector_argument.hpp>
#include <arenite/functions/place_function.hpp>
#include <arenite/rigid/body/pose.hpp>
#include <arenite/rigid/motion/spin_function.hpp>

namespace arenite::inline ARENITE_INSTRUCTION_SET {

/// A motion given in time, with rotation: the velocity of one point of the body, and the spin about it. No
/// impulse changes them; the work of the drive is recorded. Values are those of the end of each step, in
/// which the body turns by spin times dt about their axis.
///
/// A wheel: `PrescribedPose{.centre = {0, 1}, .spin = {0, 0, 2}}`.
struct PrescribedPose {
  std::array<double, 3> centre{};    ///< the point, at the start, m, any
  VectorFunction velocity{0, 0, 0};  ///< of the point, m/s
  VectorFunction spin{0, 0, 0};      ///< angular velocity, rad/s; in the plane {0, 0, z}
};

/// A prescribed motion with rotation in D dimensions over scalar T.
template <class T, int D>
class BoundPrescribedPose {
 public:
  using V = Vec<double, D>;
  using Velocity = Twist<T, D>;
  static constexpr bool has_mass = false, rotates = true;

  /// `hoop`: in axisymmetry the body moves along the axis and does not turn.
  explicit BoundPrescribedPose(PrescribedPose p, bool hoop = false)
      : hoop_{hoop},
        centre_{vector_argument<double, D>("PrescribedPose.centre", p.centre)},
        velocity_{std::move(p.velocity)},
        spin_{std::move(p.spin)} {}

  const V& centre() const { return centre_; }
  Velocity start() const { return Velocity::Zero(); }
  template <class Body>
  Velocity free_velocity(const Body& body, const Velocity&, const Vec<T, D>&, T time, T) const {
    const auto t = static_cast<double>(time);
    const V place = centre_ + body.displacement.template cast<double>();
    const V v = value_at<double, D>(velocity_, place, t, "PrescribedPose.velocity");
    const Spin<double, D> spin = spin_value_at<D>(spin_, place, t, "PrescribedPose.spin");
    if (hoop_ && (v[0] != 0 || !spin.isZero(0)))
      throw run_error(joined_text({"t = ", time, " s: PrescribedPose: in an axisymmetric scene a body moves ",
                                   "along the axis and does not turn"}));
    return twist<double, D>(v, spin).template cast<T>();
  }
  template <class Body>
  Velocity velocity_in_contact(const Body&, const Velocity& free_velocity) const {
    return free_velocity;
  }
  Velocity after(const Velocity& contact_velocity, const Velocity&, const Velocity&, const Vec<T, 2>&) const {
    return contact_velocity;
  }
  Velocity mean(const Velocity&, const Velocity& after) const { return after; }
  double work(const Velocity&, const Velocity&, const Velocity& mean, const Velocity& total) const {
    return static_cast<double>(total.dot(mean));
  }
  Velocity turn(Orientation<D>& orientation, const Velocity& velocity, T dt) const {
    orientation.turn(static_cast<double>(dt) * angular_part<D>(velocity).template cast<double>());
    return velocity;
  }
  double kinetic_energy(const Velocity&) const { return 0; }
  bool holds(const Vec<T, D>&) const { return true; }

 private:
  bool hoop_;
  V centre_;
  VectorFunction velocity_, spin_;
};

template <class Traits>
auto bind_part(const PrescribedPose& motion, const Traits&) {
  return BoundPrescribedPose<typename Traits::T, Traits::D>(motion, Traits::Kinematics::hoop);
}

}  // namespace arenite::inline ARENITE_INSTRUCTION_SET
