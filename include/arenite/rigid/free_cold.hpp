// Cold functions of free.hpp.
#pragma once
// SPDX-License-Identifier: BSD-3-Clause

#include <Eigen/LU>
#include <cmath>

#include <arenite/core/vector_argument.hpp>
#include <arenite/rigid/free.hpp>
#include <arenite/rigid/free_rotation.hpp>
#include <arenite/rigid/spin_function.hpp>

namespace arenite::inline ARENITE_INSTRUCTION_SET {

template <class T, int D>
ARENITE_COLD BoundFree<T, D>::BoundFree(const Free& f, bool hoop)
    : mass{f.mass}, hoop_{hoop}, anchor_{f.anchor}, force_{f.force}, moment_{f.moment} {
  in_space_.setIdentity();
  require(mass > 0 && std::isfinite(mass), "Free.mass", mass, "must be given, positive");
  centre_ = vector_argument<double, D>("Free.centre", f.centre);
  velocity_ = vector_argument<double, D>("Free.velocity", f.velocity);
  spin_ = spin_argument<D>("Free.spin", f.spin);
  if (hoop) {
    require(centre_[0] == 0, "Free.centre", centre_[0], "must lie on the axis in an axisymmetric scene");
    require(velocity_[0] == 0 && spin_.isZero(0), "Free.velocity, spin", vector_text(velocity_),
            "must be along the axis, without spin, in an axisymmetric scene");
    inertia_.setIdentity();
  } else {
    f.inertia.check<D>();
    if constexpr (D == 2)
      inertia_(0, 0) = f.inertia.about_z();
    else
      inertia_ = f.inertia.template tensor<D>();
  }
  momentum_ = inertia_ * spin_;
}

template <class T, int D>
ARENITE_COLD auto BoundFree<T, D>::start() const -> Velocity {
  return twist<double, D>(velocity_, spin_).template cast<T>();
}

template <class T, int D>
ARENITE_COLD auto BoundFree<T, D>::free_velocity(const State& body, const Velocity& before,
                                                 const Vec<T, D>& acceleration, T time, T dt_) -> Velocity {
  const double dt = static_cast<double>(dt_), begin = static_cast<double>(time) - dt;
  const V displacement = body.displacement.template cast<double>(), place = centre_ + displacement;
  in_space_ = inertia_in_space(body.orientation);
  const V old = linear_part<D>(before).template cast<double>();
  const V spring = dt * anchor_.force(displacement);
  V v = old + dt * acceleration.template cast<double>() +
        (dt * value_at<double, D>(force_, place, begin, "Free.force") + spring) / mass;
  v = v.cwiseQuotient(V::Ones() + dt / mass * anchor_.damping);
  S moment = S::Zero(), slowed = S::Zero();
  S added = dt * spin_value_at<D>(moment_, place, begin, "Free.moment");
  if (!anchor_.rotational_stiffness.isZero(0)) moment = dt * anchor_.moment_of_springs(body.orientation);
  added += moment;
  if (!anchor_.rotational_damping.isZero(0)) {
    Mat<double, rotations<D>> slow = in_space_;
    slow.diagonal() += dt * anchor_.rotational_damping;
    const S left = slow.inverse() * (momentum_ + added);
    slowed = -dt * anchor_.rotational_damping.cwiseProduct(left);
    added += slowed;
  }
  if (hoop_) v[0] = 0, added.setZero();
  free_momentum_ = momentum_ + added;
  of_springs_ = twist<double, D>(spring, moment);
  of_dashpots_ = twist<double, D>(-dt * anchor_.damping.cwiseProduct(v), slowed);
  gained_ = twist<double, D>(mass * (v - old), added);
  return twist<double, D>(v, in_space_.inverse() * free_momentum_).template cast<T>();
}

template <class T, int D>
ARENITE_COLD auto BoundFree<T, D>::balanced(const State& body, const Velocity& free_velocity,
                                            SumOver sum) const -> Velocity {
  return detail::balance_twist<T, D>(body, free_velocity.template cast<double>(), whole_inertia(), moves(),
                                     sum)
      .template cast<T>();
}

template <class T, int D>
ARENITE_COLD auto BoundFree<T, D>::whole_inertia() const -> Mat<double, N> {
  Mat<double, N> inertia = Mat<double, N>::Zero();
  inertia.template topLeftCorner<D, D>().diagonal().setConstant(mass);
  inertia.template bottomRightCorner<rotations<D>, rotations<D>>() = in_space_;
  return inertia;
}

template <class T, int D>
ARENITE_COLD auto BoundFree<T, D>::after(const Velocity& contact_velocity, const Velocity& free_velocity,
                                         const Velocity& total, const Vec<T, 2>& exchanged) -> Velocity {
  const U given = total.template cast<double>().cwiseProduct(moves()),
          change = (contact_velocity - free_velocity).template cast<double>();
  const V left = mass * linear_part<D>(change) + linear_part<D>(given);
  const S left_spin = in_space_ * angular_part<D>(change) + angular_part<D>(given);
  if (detail::is_round_off(left.norm(), exchanged[0], 64) &&
      detail::is_round_off(left_spin.norm(), exchanged[1], 64)) {
    momentum_ = free_momentum_ + in_space_ * angular_part<D>(change);
    return contact_velocity;
  }
  momentum_ = free_momentum_ - angular_part<D>(given);
  const V v = linear_part<D>(free_velocity).template cast<double>() - linear_part<D>(given) / mass;
  return twist<double, D>(v, in_space_.inverse() * momentum_).template cast<T>();
}

template <class T, int D>
ARENITE_COLD auto BoundFree<T, D>::mean(const Velocity& before, const Velocity& after) const -> Velocity {
  return (before + after) / 2;
}

template <class T, int D>
ARENITE_COLD auto BoundFree<T, D>::mobility(const Mat<double, N>& added) const -> Mat<double, N> {
  const Vec<double, N> can = moves();
  Mat<double, N> inertia = added;
  inertia.template topLeftCorner<D, D>().diagonal().array() += mass;
  inertia.template bottomRightCorner<rotations<D>, rotations<D>>() += in_space_;
  inertia = can.asDiagonal() * inertia * can.asDiagonal();
  inertia.diagonal() += Vec<double, N>::Ones() - can;
  const Mat<double, N> response = can.asDiagonal() * inertia.inverse() * can.asDiagonal();
  return response;
}

template <class T, int D>
ARENITE_COLD void BoundFree<T, D>::push(const U& impulse) {
  free_momentum_ += angular_part<D>(U(impulse.cwiseProduct(moves())));
}

template <class T, int D>
ARENITE_COLD Orientation<D> BoundFree<T, D>::turned(Orientation<D> orientation, const U& u, double dt) const {
  if constexpr (D == 2)
    orientation.turn(dt * angular_part<D>(u));
  else
    rotate_freely(orientation, inertia_, S(in_space_ * angular_part<D>(u)), dt);
  return orientation;
}

template <class T, int D>
ARENITE_COLD double BoundFree<T, D>::work(const Velocity&, const Velocity&, const Velocity& mean,
                                          const Velocity&) {
  const U with = mean.template cast<double>();
  damped -= of_dashpots_.dot(with);
  return (gained_ - of_springs_ - of_dashpots_).dot(with);
}

template <class T, int D>
ARENITE_COLD auto BoundFree<T, D>::turn(Orientation<D>& orientation, const Velocity& velocity, T dt) const
    -> Velocity {
  if constexpr (D == 2) {
    orientation.turn(dt * angular_part<D>(velocity).template cast<double>());
    return velocity;
  } else {
    rotate_freely(orientation, inertia_, momentum_, static_cast<double>(dt));
    const Spin<double, D> spin = inertia_in_space(orientation).inverse() * momentum_;
    Velocity turned = velocity;
    for (int k = 0; k < rotations<D>; ++k) turned[D + k] = static_cast<T>(spin[k]);
    return turned;
  }
}

template <class T, int D>
ARENITE_COLD double BoundFree<T, D>::kinetic_energy(const Velocity& v) const {
  const Twist<double, D> u = v.template cast<double>();
  return (mass * linear_part<D>(u).squaredNorm() + momentum_.dot(angular_part<D>(u))) / 2;
}

template <class T, int D>
ARENITE_COLD double BoundFree<T, D>::stored_energy(const State& body) const {
  return anchor_.stored_energy(body.displacement.template cast<double>(), body.orientation);
}

template <class T, int D>
ARENITE_COLD bool BoundFree<T, D>::holds(const Vec<T, D>& g) const {
  return anchor_.stiffness.cwiseProduct(g.template cast<double>()).norm() > 0;
}

template <class T, int D>
ARENITE_COLD auto BoundFree<T, D>::inertia_in_space(const Orientation<D>& orientation) const -> Inertias {
  if constexpr (D == 2) {
    return inertia_;
  } else {
    const Mat<double, 3> r = orientation.matrix();
    return r * inertia_ * r.transpose();
  }
}

template <class T, int D>
ARENITE_COLD auto BoundFree<T, D>::moves() const -> U {
  if (hoop_) return U::Unit(1);
  return U::Ones();
}

#define ARENITE_INSTANCES(T, D) template class BoundFree<T, D>;
ARENITE_FOR_NUMBERS_AND_DIMENSIONS(ARENITE_INSTANCES)
#undef ARENITE_INSTANCES

}  // namespace arenite::inline ARENITE_INSTRUCTION_SET
