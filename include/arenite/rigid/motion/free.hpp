// Free: a rigid body that moves and turns under gravity, contact, springs, forces and moments.
#pragma once
// SPDX-License-Identifier: BSD-3-Clause

#include <array>
#include <cmath>
#include <limits>
#include <utility>

#include <arenite/core/linear_solve.hpp>
#include <arenite/core/vector_argument.hpp>
#include <arenite/functions/place_function.hpp>
#include <arenite/rigid/body/inertia.hpp>
#include <arenite/rigid/body/pose.hpp>
#include <arenite/rigid/motion/anchor.hpp>
#include <arenite/rigid/motion/free_rotation.hpp>
#include <arenite/rigid/motion/spin_function.hpp>
#include <arenite/rigid/with_matter/contact_balance.hpp>

namespace arenite::inline ARENITE_INSTRUCTION_SET {

/// A mass that moves and turns freely: in the plane with three degrees of freedom, in space with six, in
/// axisymmetry only along the axis. Vectors are {x, y, z}; in the plane spins and moments have only z.
///
/// `symmetry`: in space, where a scene models one half of what is symmetric about a plane, the axis normal to
/// it. The body keeps to the plane: it moves along the other two axes and turns about this one, as the other
/// half would make it. Mass and inertia are those of the half, the centre that of the whole.
struct Free {
  static constexpr double not_given = std::numeric_limits<double>::quiet_NaN();
  /// Of what the scene models (a slice, a metre, the full circle), kg; required, positive.
  double mass = not_given;
  /// About the centre of mass, kg m2, positive; in axisymmetry none is needed.
  Inertia inertia{};
  std::array<double, 3> centre{not_given, not_given, 0};  ///< of mass, at the start, m; required, any
  std::array<double, 3> velocity{};                       ///< of the centre at the start, m/s, any
  std::array<double, 3> spin{};    ///< angular velocity at the start, rad/s, any; in the plane {0, 0, z}
  Anchor anchor{};                 ///< springs and dashpots to the world
  VectorFunction force{0, 0, 0};   ///< on the centre, N
  VectorFunction moment{0, 0, 0};  ///< N m
  int symmetry = -1;               ///< axis normal to a plane of symmetry, -, in [-1, 2]; -1: there is none
};

/// A free body in D dimensions over scalar T.
template <class T, int D>
class BoundFree {
 public:
  using V = Vec<double, D>;
  using S = Spin<double, D>;
  using Velocity = Twist<T, D>;
  static constexpr bool has_mass = true, rotates = true;
  static constexpr int N = D + rotations<D>;
  double mass;        ///< kg
  double damped = 0;  ///< by the anchor's dashpots since the start, J

  /// `hoop`: in axisymmetry the body moves along the axis.
  explicit BoundFree(const Free& f, bool hoop = false)
      : mass{f.mass}, anchor_{f.anchor}, force_{f.force}, moment_{f.moment} {
    require(mass > 0 && std::isfinite(mass), "Free.mass", mass, "must be given, positive");
    for (const double c : f.centre) require(!std::isnan(c), "Free.centre", c, "must be given, m");
    centre_ = vector_argument<double, D>("Free.centre", f.centre);
    velocity_ = vector_argument<double, D>("Free.velocity", f.velocity);
    spin_ = spin_argument<D>("Free.spin", f.spin);
    if (hoop) {
      require(centre_[0] == 0, "Free.centre", centre_[0], "must lie on the axis in an axisymmetric scene");
      require(velocity_[0] == 0 && spin_.isZero(0), "Free.velocity, spin", vector_text(velocity_),
              "must be along the axis, without spin, in an axisymmetric scene");
      inertia_.setIdentity();
      moves_ = Vec<double, N>::Unit(1);
    } else {
      f.inertia.check<D>();
      if constexpr (D == 2)
        inertia_(0, 0) = f.inertia.about_z();
      else
        inertia_ = f.inertia.template tensor<D>();
    }
    if (f.symmetry != -1) keep_to_plane(f.symmetry);
    momentum_ = inertia_ * spin_;
  }

  /// Of mass, at the start, m.
  const V& centre() const { return centre_; }
  /// About the centre of mass, kg m2/s.
  const S& angular_momentum() const { return momentum_; }
  Velocity start() const { return twist<double, D>(velocity_, spin_).template cast<T>(); }

  /// Adds forces and moments of the start of the step; dashpots by the velocity that they leave.
  template <class Body>
  Velocity free_velocity(const Body& body, const Velocity& before, const Vec<T, D>& acceleration, T time,
                         T dt_) {
    const double dt = static_cast<double>(dt_), begin = static_cast<double>(time) - dt;
    const V displacement = body.displacement.template cast<double>(), place = centre_ + displacement;
    in_space_ = inertia_in_space(body.orientation);
    const V old = linear_part<D>(before).template cast<double>();
    const V spring = dt * anchor_.force(displacement);
    V v = old + dt * acceleration.template cast<double>() +
          (dt * value_at<double, D>(force_, place, begin, "Free.force") + spring) / mass;
    v = v.cwiseQuotient(V::Ones() + dt / mass * anchor_.damping);
    S spring_moment = S::Zero(), damping_moment = S::Zero();
    S added = dt * spin_value_at<D>(moment_, place, begin, "Free.moment");
    if (!anchor_.rotational_stiffness.isZero(0))
      spring_moment = dt * anchor_.moment_of_springs(body.orientation);
    added += spring_moment;
    if (!anchor_.rotational_damping.isZero(0)) {
      Mat<double, rotations<D>> slow = in_space_;
      slow.diagonal() += dt * anchor_.rotational_damping;
      const S left = slow.inverse() * (momentum_ + added);
      damping_moment = -dt * anchor_.rotational_damping.cwiseProduct(left);
      added += damping_moment;
    }
    v = v.cwiseProduct(linear_part<D>(moves_));
    added = added.cwiseProduct(angular_part<D>(moves_));
    free_momentum_ = momentum_ + added;
    of_springs_ = twist<double, D>(spring, spring_moment);
    of_dashpots_ = twist<double, D>(-dt * anchor_.damping.cwiseProduct(v), damping_moment);
    gained_ = twist<double, D>(mass * (v - old), added);
    return twist<double, D>(v, in_space_.inverse() * free_momentum_).template cast<T>();
  }

  template <class Body>
  Velocity velocity_in_contact(const Body& body, const Velocity& free_velocity) const {
    ContactBalance<D> balance(resisting_nodes(body), body.friction, free_velocity.template cast<double>(),
                              inertia_of_twist(), moves_);
    return balance.solve().template cast<T>();
  }

  /// The remainder of the balance is given to the body, unless it is round-off of the impulses, which would
  /// give a very light body a large velocity. `magnitudes`: sums of the magnitudes of impulses and of their
  /// moments.
  Velocity after(const Velocity& contact_velocity, const Velocity& free_velocity, const Velocity& total,
                 const Vec<T, 2>& magnitudes) {
    constexpr double round_off = 64 * static_cast<double>(std::numeric_limits<T>::epsilon());
    const Vec<double, N> given = total.template cast<double>().cwiseProduct(moves_),
                         change = (contact_velocity - free_velocity).template cast<double>();
    const V left = mass * linear_part<D>(change) + linear_part<D>(given);
    const S left_spin = in_space_ * angular_part<D>(change) + angular_part<D>(given);
    if (left.norm() <= round_off * static_cast<double>(magnitudes[0]) &&
        left_spin.norm() <= round_off * static_cast<double>(magnitudes[1])) {
      momentum_ = free_momentum_ + in_space_ * angular_part<D>(change);
      return contact_velocity;
    }
    momentum_ = free_momentum_ - angular_part<D>(given);
    const V v = linear_part<D>(free_velocity).template cast<double>() - linear_part<D>(given) / mass;
    return twist<double, D>(v, in_space_.inverse() * momentum_).template cast<T>();
  }
  Velocity mean(const Velocity& before, const Velocity& after) const { return (before + after) / 2; }

  /// For the contact of rigid bodies (`RigidContact`). Change of the twist by an impulse and its moment, once
  /// `free_velocity` was asked for; `added`: how the impulse of the matter opposes the twist, as an inertia.
  Mat<double, N> mobility(const Mat<double, N>& added) const {
    Mat<double, N> inertia = inertia_of_twist() + added;
    inertia = moves_.asDiagonal() * inertia * moves_.asDiagonal();
    inertia.diagonal() += Vec<double, N>::Ones() - moves_;
    const Mat<double, N> response = moves_.asDiagonal() * inverse_of<N>(inertia) * moves_.asDiagonal();
    return response;
  }
  /// Takes an impulse of another rigid body with its moment, before `after`.
  void push(const Vec<double, N>& impulse) {
    free_momentum_ += angular_part<D>(Vec<double, N>(impulse.cwiseProduct(moves_)));
  }
  /// The orientation at the end of a step with this twist.
  Orientation<D> turned(Orientation<D> orientation, const Vec<double, N>& u, double dt) const {
    if constexpr (D == 2)
      orientation.turn(dt * angular_part<D>(u));
    else
      rotate_freely(orientation, inertia_, S(in_space_ * angular_part<D>(u)), dt);
    return orientation;
  }

  /// Work of gravity, forces and moments, J; that of dashpots is added to `damped`.
  double work(const Velocity&, const Velocity&, const Velocity& mean, const Velocity&) {
    const Vec<double, N> with = mean.template cast<double>();
    damped -= of_dashpots_.dot(with);
    return (gained_ - of_springs_ - of_dashpots_).dot(with);
  }

  /// Turns the body through the step; returns its velocity and spin there.
  Velocity turn(Orientation<D>& orientation, const Velocity& velocity, T dt) const {
    if constexpr (D == 2) {
      orientation.turn(dt * angular_part<D>(velocity).template cast<double>());
      return velocity;
    } else {
      rotate_freely(orientation, inertia_, momentum_, static_cast<double>(dt));
      const Spin<T, D> spin = (inertia_in_space(orientation).inverse() * momentum_).template cast<T>();
      return twist<T, D>(linear_part<D>(velocity), spin);
    }
  }

  double kinetic_energy(const Velocity& v) const {
    const Twist<double, D> u = v.template cast<double>();
    return (mass * linear_part<D>(u).squaredNorm() + momentum_.dot(angular_part<D>(u))) / 2;
  }
  template <class Body>
  double stored_energy(const Body& body) const {
    return anchor_.stored_energy(body.displacement.template cast<double>(), body.orientation);
  }
  bool holds(const Vec<T, D>& g) const {
    return anchor_.stiffness.cwiseProduct(g.template cast<double>()).norm() > 0;
  }
  template <class F>
  void visit_state(F&& f) {
    f("angular_momentum", momentum_);
    f("damped", damped);
  }

 private:
  using Inertias = Mat<double, rotations<D>>;

  Inertias inertia_in_space(const Orientation<D>& orientation) const {
    if constexpr (D == 2) {
      return inertia_;
    } else {
      const Mat<double, 3> r = orientation.matrix();
      return r * inertia_ * r.transpose();
    }
  }
  /// Of the step: takes the twist to momentum and angular momentum.
  Mat<double, N> inertia_of_twist() const {
    Mat<double, N> inertia = Mat<double, N>::Zero();
    inertia.template topLeftCorner<D, D>().diagonal().setConstant(mass);
    inertia.template bottomRightCorner<rotations<D>, rotations<D>>() = in_space_;
    return inertia;
  }
  /// Throws `error` unless the body is of this plane of symmetry.
  void keep_to_plane(int normal) {
    require(D == 3 && normal >= 0 && normal < 3, "Free.symmetry", normal,
            "must be -1, or in space the axis 0, 1 or 2");
    moves_[normal] = 0;
    for (int k = 0; k < rotations<D>; ++k) {
      moves_[D + k] = k == normal ? 1 : 0;
      require(k == normal || inertia_(k, normal) == 0, "Free.inertia", inertia_(k, normal),
              {"must have no products with the axis ", normal, " of the plane of symmetry"});
    }
    require((twist<double, D>(velocity_, spin_).cwiseProduct(Vec<double, N>::Ones() - moves_)).isZero(0),
            "Free.velocity, spin", joined_text({vector_text(velocity_), ", ", vector_text(spin_)}),
            {"must be in the plane of symmetry, and about its normal, axis ", normal});
  }

  /// 1 for each component of the velocity that may change, 0 for the others.
  Vec<double, N> moves_ = Vec<double, N>::Ones();
  BoundAnchor<D> anchor_;
  VectorFunction force_, moment_;
  V centre_, velocity_;
  S spin_;
  Inertias inertia_ = Inertias::Zero();  // in the body's frame
  S momentum_;
  // Of the step.
  Inertias in_space_ = Inertias::Identity();
  S free_momentum_ = S::Zero();
  Vec<double, N> gained_, of_springs_, of_dashpots_;  // impulses without contact
};

template <class Traits>
auto bind_part(const Free& motion, const Traits&) {
  return BoundFree<typename Traits::T, Traits::D>(motion, Traits::Kinematics::hoop);
}

}  // namespace arenite::inline ARENITE_INSTRUCTION_SET
