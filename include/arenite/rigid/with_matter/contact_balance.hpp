// Balance of contact: the velocity and spin of a rigid body at which its impulses and those of all nodes that
// it touches balance.
#pragma once
// SPDX-License-Identifier: BSD-3-Clause

#include <cmath>
#include <limits>
#include <utility>

#include <arenite/contact/coulomb.hpp>
#include <arenite/core/linear_solve.hpp>
#include <arenite/parallel/communicator.hpp>
#include <arenite/rigid/body/twist.hpp>

namespace arenite::inline ARENITE_INSTRUCTION_SET {

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

/// Solves f(u) = M (u - free) + sum_i W_i^T J_i(W_i u) = 0 for the twist u of a body, W_i u its velocity at
/// node i. f is made of pieces that are straight, or nearly so; without friction it is the gradient of a
/// convex function. Newton steps on the pieces, each followed along its direction to where f no longer points
/// ahead, reach the solution in a few steps, whatever the masses. Components are scaled by the square root of
/// the mass that they move. The sums are taken over the touches of all scenes that share the body.
template <class R, class Communicator, int D, int N>
class ContactBalance {
 public:
  using U = Vec<double, N>;

  /// `inertia`: M; `moves`: 1 for each component of the twist that may change, else 0.
  ContactBalance(const R& body, const U& free, const Mat<double, N>& inertia, const U& moves,
                 const Communicator& comm)
      : body_{body}, comm_{comm}, free_{free}, inertia_{inertia}, moves_{moves} {
    U moved = U::Zero();
    for (const auto& t : body.touched_nodes)
      moved += static_cast<double>(t.mass_ratio * t.mass) * matrix_at(t).colwise().squaredNorm().transpose();
    sum_over(comm_, moved);
    scale_ = (moved + inertia.diagonal()).cwiseSqrt();
  }

  U solve() {
    look(U::Zero());
    if (contact_magnitude_ == 0) return free_;
    U x = U::Zero(), best = x;  // scaled, from `free` on
    double least = iterate(x);
    if (least > solved * magnitude_ && !body_.friction.is_no_slip()) {
      // Of a far heavier body, then of ever lighter ones, each from where the one before ended.
      const auto keep_better = [&](double size) {
        if (size < least) best = x, least = size;
      };
      best = x;
      x.setZero();
      for (added_ = 1; added_ > 1e-12 && least > solved * magnitude_; added_ /= 8) {
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

  template <class Touched>
  static Eigen::Matrix<double, D, N> matrix_at(const Touched& t) {
    return velocity_map<D, N>(t.arm.template cast<double>());
  }

  /// f and its slope, scaled, at x.
  void look(const U& x) {
    const U change = x.cwiseQuotient(scale_), u = free_ + change;
    Eigen::Matrix<double, N, N + 2> sums = Eigen::Matrix<double, N, N + 2>::Zero();
    for (const auto& t : body_.touched_nodes) {
      const auto w = matrix_at(t);
      const Vec<double, D> v = w * u, approach = t.start.template cast<double>() - v;
      const Vec<double, D> normal = t.normal.template cast<double>();
      const double mass = static_cast<double>(t.mass_ratio * t.mass);
      const auto contact = t.inside ? stick<double, D>(approach, mass)
                                    : coulomb<double, D>(approach, normal, mass, body_.friction);
      if (contact.impulse.squaredNorm() == 0) continue;
      const Mat<double, D> slope = t.inside ? Mat<double, D>(Mat<double, D>::Identity())
                                            : coulomb_slope<D>(approach, normal, body_.friction);
      const U share = w.transpose() * contact.impulse;
      sums.col(N) += share;
      sums.col(N + 1) += share.cwiseAbs();
      sums.template leftCols<N>() += mass * (w.transpose() * slope * w);
    }
    sum_over(comm_, sums);
    const U by = moves_.cwiseQuotient(scale_), own = inertia_ * change;
    contact_magnitude_ = sums.col(N + 1).sum();
    rest_ = by.cwiseProduct(own + sums.col(N));
    magnitude_ = by.cwiseProduct(own.cwiseAbs() + sums.col(N + 1)).norm();
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
      U direction = -solve_linear<N>(slope_, begin);
      if (!direction.allFinite() || !(direction.dot(begin) < 0)) direction = -begin;
      const double share = follow(x, direction, direction.dot(begin));
      x += share * direction;
      const double size = rest_.norm();
      const bool better = size < least;
      if (better) {
        best = x;
        least = size;
      }
      if (size <= solved * magnitude_ && !better) break;  // round-off
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
    if (ahead <= 0.9 * std::abs(begin) || rest_.norm() <= solved * magnitude_) return 1;
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
  const Communicator& comm_;
  U free_, scale_;
  Mat<double, N> inertia_;
  U moves_;
  U rest_;
  Mat<double, N> slope_;
  double magnitude_ = 0, contact_magnitude_ = 0;
  double added_ = 0;          // mass that is added to the body, as a share of what each component moves
  U added_from_ = U::Zero();  // where it rests
};

}  // namespace arenite::inline ARENITE_INSTRUCTION_SET
