// Impulses of all contacts between rigid bodies, found together.
#pragma once
// SPDX-License-Identifier: BSD-3-Clause

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

#include <arenite/contact/relaxed_impulse.hpp>
#include <arenite/core/linear_solve.hpp>
#include <arenite/rigid/body/twist.hpp>

namespace arenite::inline ARENITE_INSTRUCTION_SET {

/// One contact of two bodies for the solver, in its own axes: the normal first, out of the second body,
/// then the tangents. Its velocity is that of the first body against the second, w = W_1 u_1 - W_2 u_2.
template <int D>
struct ContactConstraint {
  static constexpr int N = D + rotations<D>;
  std::size_t body[2];                              ///< first, second
  Eigen::Matrix<double, D, N> to[2];                ///< W_1, -W_2: from a body's twist
  Eigen::Matrix<double, N, D> by[2];                ///< change of each twist by the impulse
  Mat<double, D> response;                          ///< of the velocity to the impulse, m/s per N s
  double friction = 0;                              ///< coefficient; infinite: no slip
  double least = 0;                                 ///< least normal velocity, m/s
  Vec<double, D> impulse = Vec<double, D>::Zero();  ///< on the first body, N s

  Vec<double, D> velocity(const std::vector<Vec<double, N>>& u) const {
    return to[0] * u[body[0]] + to[1] * u[body[1]];
  }
  void add(const Vec<double, D>& change, std::vector<Vec<double, N>>& u) {
    impulse += change;
    u[body[0]] += by[0] * change;
    u[body[1]] += by[1] * change;
  }
};

/// Finds impulses j that keep to the laws of contact: w_n >= least, j_n >= 0 and one of them an equality;
/// |j_t| <= mu j_n, and where contact slips j_t = -mu j_n w_t / |w_t|. Projected Gauss-Seidel sweeps find
/// which contacts act, stick and slip; the linear equations of these are then solved together, so that
/// masses may differ by any factor (Alart and Curnier 1991, doi:10.1016/0045-7825(91)90022-X). Serial.
template <int D>
class ContactSolver {
 public:
  static constexpr int N = D + rotations<D>;
  using Rows = std::vector<ContactConstraint<D>>;
  using Twists = std::vector<Vec<double, N>>;

  /// Starts from the impulses in `rows` and the twists `u` that they have led to. Returns by how much the
  /// worst contact fails, m/s; `scale`: size of the velocities, m/s.
  double solve(Rows& rows, Twists& u, double scale) {
    const double enough = 1e-13 * scale, most = greatest_impulse(rows, scale);
    double rest = 0;
    for (int round = 0; round < 20; ++round) {
      for (int k = 0; k < 20; ++k) {
        rest = sweep(rows, u);
        if (rest <= enough) return rest;
      }
      if (rows.size() > most_rows) continue;
      const Rows swept = rows;
      const Twists before = u;
      double left = 0;  // not a number: no use
      for (int k = 0; k < 12; ++k) {
        solve_active(rows, u);
        const bool bounded =
            std::ranges::all_of(rows, [&](const auto& row) { return row.impulse.norm() <= most; });
        left = bounded ? residual(rows, u) : std::numeric_limits<double>::quiet_NaN();
        if (left <= enough) return left;
        if (!std::isfinite(left)) break;
      }
      // Small enough for round-off of masses that differ much, or not a solution at all.
      if (left <= 1e-10 * scale) return left;
      if (!(left <= rest)) rows = swept, u = before;
    }
    return rest;
  }

 private:
  static constexpr std::size_t most_rows = 200;

  /// Bound on impulses, far above what stops the heaviest body, N s. Impulses of contacts that lock each
  /// other, as a wedge with friction does, are not unique: any multiple is a solution, and great ones leave
  /// only round-off.
  static double greatest_impulse(const Rows& rows, double scale) {
    double least = std::numeric_limits<double>::infinity();  // m/s per N s, of one body
    for (const auto& row : rows)
      for (int i = 0; i < 2; ++i) {
        const double of_body = row.to[i].row(0).dot(row.by[i].col(0));
        if (of_body > 0) least = std::min(least, of_body);
      }
    return 1e4 * scale / least;
  }

  static double across(const ContactConstraint<D>& row) { return tangential_response(row.response, 1e-12); }
  /// Change of an impulse by its relaxation.
  static Vec<double, D> relaxation(const ContactConstraint<D>& row, const Twists& u) {
    return relaxed_impulse<D>(row.impulse, row.velocity(u), row.least, row.response, across(row),
                              row.friction) -
           row.impulse;
  }

  /// One sweep; returns the greatest change, as a velocity.
  static double sweep(Rows& rows, Twists& u) {
    double most = 0;
    for (auto& row : rows) {
      const Vec<double, D> change = relaxation(row, u);
      row.add(change, u);
      most = std::max(most, velocity_change<D>(change, row.response, across(row)));
    }
    return most;
  }

  static double residual(const Rows& rows, const Twists& u) {
    double most = 0;
    for (const auto& row : rows) {
      const double size = velocity_change<D>(relaxation(row, u), row.response, across(row));
      if (!(size <= most)) most = size;
    }
    return most;
  }

  /// One Newton step: the contacts that act now stick or slip as they do now, the others give nothing.
  void solve_active(Rows& rows, Twists& u) {
    unknowns_.clear();
    for (std::size_t c = 0; c < rows.size(); ++c) {
      auto& row = rows[c];
      const Vec<double, D> w = row.velocity(u);
      const double normal = row.impulse[0] - (w[0] - row.least) / row.response(0, 0);
      if (normal <= 0) {
        row.add(-row.impulse, u);
        continue;
      }
      const Vec<double, D - 1> t =
          row.impulse.template tail<D - 1>() - w.template tail<D - 1>() / across(row);
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
    const std::size_t count = unknowns_.size();
    if (count == 0) return;
    std::vector<double> a(count * count), b(count);  // by columns
    for (std::size_t p = 0; p < count; ++p) {
      const auto& [row_p, axis, unused] = unknowns_[p];
      const auto& row = rows[row_p];
      b[p] = (axis == 0 ? row.least : 0) - row.velocity(u)[axis];
      for (std::size_t q = 0; q < count; ++q)
        a[p + q * count] = between(row, rows[unknowns_[q].row], axis, unknowns_[q].along);
      a[p + p * count] += 1e-11 * row.response(axis, axis);  // where contacts share one load
    }
    solve_in_place(a.data(), b.data(), count, 1);
    for (std::size_t q = 0; q < count; ++q) rows[unknowns_[q].row].add(b[q] * unknowns_[q].along, u);
  }

  /// Velocity along an axis of one contact by an impulse at another.
  static double between(const ContactConstraint<D>& at, const ContactConstraint<D>& of, int axis,
                        const Vec<double, D>& impulse) {
    double sum = 0;
    for (int i = 0; i < 2; ++i)
      for (int k = 0; k < 2; ++k)
        if (at.body[i] == of.body[k]) sum += at.to[i].row(axis).dot(of.by[k] * impulse);
    return sum;
  }

  struct Unknown {
    std::size_t row;
    int axis;              // of the equation
    Vec<double, D> along;  // impulse of one unit
  };
  std::vector<Unknown> unknowns_{};
};

}  // namespace arenite::inline ARENITE_INSTRUCTION_SET
