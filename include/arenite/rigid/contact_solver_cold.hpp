// Cold functions of contact_solver.hpp.
#pragma once
// SPDX-License-Identifier: BSD-3-Clause

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <limits>

#include <arenite/rigid/contact_solver.hpp>

namespace arenite::inline ARENITE_INSTRUCTION_SET {

template <int D>
Vec<double, D> ContactConstraint<D>::velocity(const std::vector<Twist<double, D>>& u) const {
  return to[0] * u[body[0]] + to[1] * u[body[1]];
}
template <int D>
void ContactConstraint<D>::add(const Vec<double, D>& change, std::vector<Twist<double, D>>& u) {
  this->impulse += change;
  u[body[0]] += by[0] * change;
  u[body[1]] += by[1] * change;
}

namespace detail {

constexpr std::size_t most_rows = 200;
constexpr double solver_floor = 1e-12;

/// An impulse far above what stops the heaviest body, N s. Contacts that hold each other, as a wedge with
/// friction does, have none of their own: any multiple would do, and of great ones round-off alone is left.
template <int D>
double greatest_impulse(const std::vector<ContactConstraint<D>>& rows, double scale) {
  double least = std::numeric_limits<double>::infinity();  // m/s per N s, of a body alone
  for (const auto& row : rows)
    for (int i = 0; i < 2; ++i) {
      const double of_body = row.to[i].row(0).dot(row.by[i].col(0));
      if (of_body > 0) least = std::min(least, of_body);
    }
  return 1e4 * scale / least;
}

/// One sweep; returns the greatest change, as a velocity.
template <int D>
double sweep(std::vector<ContactConstraint<D>>& rows, std::vector<Twist<double, D>>& u) {
  double most = 0;
  for (auto& row : rows) {
    // First along the normal, then across it with the velocity that this leaves.
    Vec<double, D> change = Vec<double, D>::Zero();
    change[0] = row.lawful(row.wanted(row.velocity(u), solver_floor))[0] - row.impulse[0];
    row.add(change, u);
    Vec<double, D> next = row.lawful(row.wanted(row.velocity(u), solver_floor));
    next[0] = row.impulse[0];
    const Vec<double, D> along = row.lawful(next) - row.impulse;
    row.add(along, u);
    change += along;
    most = std::max(most, row.velocity_of(change, solver_floor));
  }
  return most;
}

template <int D>
double residual(const std::vector<ContactConstraint<D>>& rows, const std::vector<Twist<double, D>>& u) {
  double most = 0;
  for (const auto& row : rows) {
    const Vec<double, D> off = row.lawful(row.wanted(row.velocity(u), solver_floor)) - row.impulse;
    const double size = row.velocity_of(off, solver_floor);
    if (!(size <= most)) most = size;
  }
  return most;
}

/// Velocity along an axis of one contact by an impulse at another.
template <int D>
double between(const ContactConstraint<D>& at, const ContactConstraint<D>& of, int axis,
               const Vec<double, D>& impulse) {
  double sum = 0;
  for (int i = 0; i < 2; ++i)
    for (int k = 0; k < 2; ++k)
      if (at.body[i] == of.body[k]) sum += at.to[i].row(axis).dot(of.by[k] * impulse);
  return sum;
}

}  // namespace detail

template <int D>
ARENITE_COLD double ContactSolver<D>::solve(Rows& rows, Twists& u, double scale) {
  const double enough = 1e-13 * scale, most = detail::greatest_impulse(rows, scale);
  double rest = 0;
  for (int round = 0; round < 20; ++round) {
    for (int k = 0; k < 20; ++k) {
      rest = detail::sweep(rows, u);
      if (rest <= enough) return rest;
    }
    if (rows.size() > detail::most_rows) continue;
    const Rows swept = rows;
    const Twists before = u;
    double left = 0;  // not a number: no use
    for (int k = 0; k < 12; ++k) {
      solve_active(rows, u);
      const bool bounded =
          std::ranges::all_of(rows, [&](const auto& row) { return row.impulse.norm() <= most; });
      left = bounded ? detail::residual(rows, u) : std::numeric_limits<double>::quiet_NaN();
      if (left <= enough) return left;
      if (!std::isfinite(left)) break;
    }
    // Small enough for round-off of masses that differ much, or not a solution at all.
    if (left <= 1e-10 * scale) return left;
    if (!(left <= rest)) rows = swept, u = before;
  }
  return rest;
}

/// One Newton step: the contacts that act now stick or slip as they do now, the others give nothing.
template <int D>
ARENITE_COLD void ContactSolver<D>::solve_active(Rows& rows, Twists& u) {
  unknowns_.clear();
  for (std::size_t c = 0; c < rows.size(); ++c) {
    auto& row = rows[c];
    const Vec<double, D> w = row.velocity(u);
    const Vec<double, D> wanted = row.wanted(w, detail::solver_floor);
    const double normal = wanted[0];
    if (normal <= 0) {
      row.add(-row.impulse, u);
      continue;
    }
    const Vec<double, D - 1> t = wanted.template tail<D - 1>();
    Vec<double, D> along = Vec<double, D>::Unit(0);
    const double size = t.norm();
    if (size <= row.friction * normal && row.friction > 0) {
      for (int k = 0; k < D; ++k) unknowns_.push_back({c, k, Vec<double, D>::Unit(k)});
    } else {
      if (size > 0) along.template tail<D - 1>() = row.friction / size * t;
      // From now on the impulse lies along this line.
      row.add(row.impulse[0] * along - row.impulse, u);
      unknowns_.push_back({c, 0, along});
    }
  }
  const auto count = static_cast<Eigen::Index>(unknowns_.size());
  if (count == 0) return;
  Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic> a(count, count);
  Eigen::Matrix<double, Eigen::Dynamic, 1> b(count);
  for (Eigen::Index p = 0; p < count; ++p) {
    const auto& [row_p, axis, unused] = unknowns_[static_cast<std::size_t>(p)];
    const auto& row = rows[row_p];
    b[p] = (axis == 0 ? row.least : 0) - row.velocity(u)[axis];
    for (Eigen::Index q = 0; q < count; ++q) {
      const auto& unknown = unknowns_[static_cast<std::size_t>(q)];
      a(p, q) = detail::between(row, rows[unknown.row], axis, unknown.along);
    }
    a(p, p) += 1e-11 * row.response(axis, axis);  // where contacts share one load
  }
  const Eigen::Matrix<double, Eigen::Dynamic, 1> x = a.partialPivLu().solve(b);
  for (Eigen::Index q = 0; q < count; ++q) {
    const auto& unknown = unknowns_[static_cast<std::size_t>(q)];
    rows[unknown.row].add(x[q] * unknown.along, u);
  }
}

#define ARENITE_INSTANCES(D)            \
  template struct ContactConstraint<D>; \
  template class ContactSolver<D>;
ARENITE_FOR_DIMENSIONS(ARENITE_INSTANCES)
#undef ARENITE_INSTANCES

}  // namespace arenite::inline ARENITE_INSTRUCTION_SET
