// Cold functions of contact_balance.hpp.
#pragma once
// SPDX-License-Identifier: BSD-3-Clause

#include <Eigen/Cholesky>
#include <Eigen/LU>
#include <cmath>
#include <limits>
#include <utility>

#include <arenite/rigid/contact_balance.hpp>
#include <arenite/rigid/rigid_state_cold.hpp>

namespace arenite::inline ARENITE_INSTRUCTION_SET::detail {

/// -1/m dJ/da of Coulomb's impulse J (`coulomb`) by the relative velocity a, where it has a slope. Without
/// `coupling` friction that slips does not grow with the normal impulse: the slope is then symmetric and
/// nowhere negative.
template <int D>
Mat<double, D> coulomb_slope(const Vec<double, D>& approach, const Vec<double, D>& normal,
                             const Friction& friction, bool coupling = true) {
  const double closing = approach.dot(normal);
  if (!(closing < 0)) return Mat<double, D>::Zero();
  const Vec<double, D> slip = approach - closing * normal;
  const double speed = slip.norm(), most = friction.coefficient() * -closing;
  if (friction.is_no_slip() || speed <= most) return Mat<double, D>::Identity();
  const Vec<double, D> along = slip / speed;
  const Mat<double, D> across = normal * normal.transpose();
  Mat<double, D> slope =
      across + most / speed * (Mat<double, D>::Identity() - across - along * along.transpose());
  if (coupling) slope -= friction.coefficient() * along * normal.transpose();
  return slope;
}

/// See `balance_twist`.
template <class T, int D>
class ContactBalance {
 public:
  static constexpr int N = D + rotations<D>;
  using R = RigidState<T, D, N>;
  using U = Vec<double, N>;

  ContactBalance(const R& body, const U& free, const Mat<double, N>& inertia, const U& moves, SumOver sum)
      : body_{body}, sum_{sum}, free_{free}, inertia_{inertia}, moves_{moves} {
    U moved = U::Zero();
    for (const auto& t : body.touched_nodes)
      moved += static_cast<double>(t.mass_ratio * t.mass) * map_at(t).colwise().squaredNorm().transpose();
    sum_(moved);
    scale_ = (moved + inertia.diagonal()).cwiseSqrt();
  }

  U solve() {
    look(U::Zero());
    if (touch_ == 0) return free_;
    U x = U::Zero(), best = x;  // scaled, from `free` on
    double least = iterate(x);
    if (least > solved * exchanged_ && !body_.friction.is_no_slip()) {
      // Of a far heavier body, then of ever lighter ones, each from where the one before ended.
      const auto keep_better = [&](double size) {
        if (size < least) best = x, least = size;
      };
      best = x;
      x.setZero();
      for (added_ = 1; added_ > 1e-12 && least > solved * exchanged_; added_ /= 8) {
        added_from_ = x;
        iterate(x);
        const double added = std::exchange(added_, 0.0);
        look(x);
        keep_better(rest_.norm());
        added_ = added;
      }
      added_ = 0;
      keep_better(iterate(x));
      x = best;
    }
    return free_ + x.cwiseQuotient(scale_);
  }

 private:
  static constexpr int most_steps = 60;
  static constexpr double solved = 1e-9;  // of the impulses
  static constexpr double round_off = std::numeric_limits<double>::epsilon();

  static Eigen::Matrix<double, D, N> map_at(const TouchedNode<T, D>& t) {
    return velocity_map<N, D>(t.arm.template cast<double>());
  }

  /// f and its slope, scaled, at x.
  void look(const U& x) {
    const U change = x.cwiseQuotient(scale_), u = free_ + change;
    Eigen::Matrix<double, N, N + 2> sums = Eigen::Matrix<double, N, N + 2>::Zero();
    for (const auto& t : body_.touched_nodes) {
      const auto w = map_at(t);
      const Vec<double, D> v = w * u, approach = t.start.template cast<double>() - v;
      const Vec<double, D> normal = t.normal.template cast<double>();
      const double mass = static_cast<double>(t.mass_ratio * t.mass);
      const auto given = t.inside ? stick<double, D>(approach, mass)
                                  : coulomb<double, D>(approach, normal, mass, body_.friction);
      if (given.impulse.squaredNorm() == 0) continue;
      const Mat<double, D> slope = t.inside ? Mat<double, D>(Mat<double, D>::Identity())
                                            : coulomb_slope<D>(approach, normal, body_.friction);
      const U share = w.transpose() * given.impulse;
      sums.col(N) += share;
      sums.col(N + 1) += share.cwiseAbs();
      sums.template leftCols<N>() += mass * (w.transpose() * slope * w);
    }
    sum_(sums);
    const U by = moves_.cwiseQuotient(scale_), own = inertia_ * change;
    touch_ = sums.col(N + 1).sum();
    rest_ = by.cwiseProduct(own + sums.col(N));
    exchanged_ = by.cwiseProduct(own.cwiseAbs() + sums.col(N + 1)).norm();
    slope_ = by.asDiagonal() * (inertia_ + sums.template leftCols<N>()) * by.asDiagonal();
    slope_.diagonal() += U::Ones() - moves_;
    if (added_ > 0) {
      rest_ += added_ * (x - added_from_);
      slope_.diagonal().array() += added_;
    }
  }

  /// Newton steps from x on; returns the least size of f found, and x there.
  double iterate(U& x) {
    look(x);
    U best = x;
    double least = rest_.norm();
    for (int k = 0; k < most_steps && least > 0; ++k) {
      const U begin = rest_;
      U direction = -slope_.partialPivLu().solve(begin);
      if (!direction.allFinite() || !(direction.dot(begin) < 0)) direction = -begin;
      const double share = follow(x, direction, direction.dot(begin));
      x += share * direction;
      const double size = rest_.norm();
      const bool better = size < least;
      if (better) {
        best = x;
        least = size;
      }
      if (size <= solved * exchanged_ && !better) break;  // round-off
      if (share * direction.norm() <= round_off * x.norm()) break;
    }
    x = best;
    return least;
  }

  /// Looks along a direction, first at all of it, until f points ahead by less than it did or nearly across.
  /// Returns the share of the direction; f is that there.
  double follow(const U& x, const U& direction, double begin) {
    double near = 0, far = 1, at_near = begin;
    look(x + direction);
    double ahead = direction.dot(rest_);
    if (ahead <= 0.9 * std::abs(begin) || rest_.norm() <= solved * exchanged_) return 1;
    double share = 1, at_far = ahead;
    for (int k = 0; k < 40; ++k) {
      share = k % 3 == 2 ? (near + far) / 2 : near + (far - near) * at_near / (at_near - at_far);
      look(x + share * direction);
      ahead = direction.dot(rest_);
      if (std::abs(ahead) <= 0.1 * std::abs(begin)) break;
      (ahead < 0 ? near : far) = share;
      (ahead < 0 ? at_near : at_far) = ahead;
    }
    return share;
  }

  const R& body_;
  SumOver sum_;
  U free_, scale_;
  Mat<double, N> inertia_;
  U moves_;
  U rest_;
  Mat<double, N> slope_;
  double exchanged_ = 0, touch_ = 0;
  double added_ = 0;          // mass that is added to the body, as a share of what each component moves
  U added_from_ = U::Zero();  // where it rests
};

template <class T, int D>
ARENITE_COLD T balance_speed(const RigidState<T, D, D>& body, const Vec<T, D>& axis, T trial, T mass,
                             SumOver sum) {
  const auto own_impulse = [&](T s) {
    T own = 0;
    const Vec<T, D> velocity = s * axis;
    for (const auto& t : body.touched_nodes)
      own += contact_at<T, D, D>(t, velocity, body.friction).impulse.dot(axis);
    return own;
  };
  const auto contact_impulse = [&](T s) {
    T all = own_impulse(s);
    sum(all);
    return all;
  };
  constexpr T round_off = std::numeric_limits<T>::epsilon();
  T s = trial, soil = 0, j = own_impulse(s);  // J(s)
  for (const auto& t : body.touched_nodes) soil += t.mass_ratio * t.mass;
  sum(soil, j);
  T f = j;
  if (f == 0) return trial;
  const T sign = f > 0 ? T(1) : T(-1);
  T near = trial;            // f has the sign of the start here, and the other one (or none) at `far`
  T far = trial - f / mass;  // where the body alone would take up the impulse at the trial speed
  T before = std::numeric_limits<T>::infinity();
  for (int k = 0; k < 200; ++k) {
    const T h = -sign * std::sqrt(round_off) * std::max(std::abs(s - trial), std::abs(f) / (mass + soil));
    const T slope = mass + (contact_impulse(s + h) - j) / h;
    T next = s - f / slope;
    if (!((next - near) * (next - far) < 0) || 2 * std::abs(f) > before) next = near + (far - near) / 2;
    before = std::abs(f);
    const T change = std::abs(next - s);
    s = next;
    j = contact_impulse(s);
    f = mass * (s - trial) + j;
    (f * sign > 0 ? near : far) = s;
    if (f == 0 || change <= 4 * round_off * std::abs(s - trial)) break;
  }
  return s;
}

template <class T, int D>
ARENITE_COLD Twist<double, D> balance_twist(const RigidState<T, D, D + rotations<D>>& body,
                                            const Twist<double, D>& free,
                                            const Mat<double, D + rotations<D>>& inertia,
                                            const Twist<double, D>& moves, SumOver sum) {
  return ContactBalance<T, D>(body, free, inertia, moves, sum).solve();
}

template <class T, int D, int N>
ARENITE_COLD Mat<double, N> resistance_of_matter(const RigidState<T, D, N>& body, const Vec<T, N>& velocity,
                                                 bool coupling, SumOver sum) {
  Mat<double, N> all = Mat<double, N>::Zero();
  for (const auto& t : body.touched_nodes) {
    const auto w = velocity_map<N, D>(t.arm.template cast<double>());
    const Vec<double, D> v = w * velocity.template cast<double>(),
                         approach = t.start.template cast<double>() - v;
    const Mat<double, D> slope =
        t.inside ? Mat<double, D>(Mat<double, D>::Identity())
                 : coulomb_slope<D>(approach, t.normal.template cast<double>(), body.friction, coupling);
    all += static_cast<double>(t.mass) * (w.transpose() * slope * w);
  }
  sum(all);
  return all;
}

template <int N>
ARENITE_COLD bool gains_energy(const Mat<double, N>& mobility) {
  Mat<double, N> twice = mobility + mobility.transpose();
  for (int k = 0; k < N; ++k)
    if (twice(k, k) == 0) twice(k, k) = 1;
  return !(twice.llt().info() == Eigen::Success);
}

#define ARENITE_INSTANCES(T, D)                                                                              \
  template T balance_speed(const RigidState<T, D, D>&, const Vec<T, D>&, T, T, SumOver);                     \
  template Twist<double, D> balance_twist(const RigidState<T, D, D + rotations<D>>&,                         \
                                          const Twist<double, D>&, const Mat<double, D + rotations<D>>&,     \
                                          const Twist<double, D>&, SumOver);                                 \
  template Mat<double, D> resistance_of_matter(const RigidState<T, D, D>&, const Vec<T, D>&, bool, SumOver); \
  template Mat<double, D + rotations<D>> resistance_of_matter(const RigidState<T, D, D + rotations<D>>&,     \
                                                              const Twist<T, D>&, bool, SumOver);
ARENITE_FOR_NUMBERS_AND_DIMENSIONS(ARENITE_INSTANCES)
#undef ARENITE_INSTANCES
#ifdef ARENITE_COLD_LIBRARY
template bool gains_energy(const Mat<double, 2>&);
template bool gains_energy(const Mat<double, 3>&);
template bool gains_energy(const Mat<double, 6>&);
#endif

}  // namespace arenite::inline ARENITE_INSTRUCTION_SET::detail
