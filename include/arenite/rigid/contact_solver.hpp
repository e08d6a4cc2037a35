// Impulses of all contacts between rigid bodies, found together.
#pragma once
// SPDX-License-Identifier: BSD-3-Clause

#include <cstddef>
#include <vector>

#include <arenite/rigid/local_contact.hpp>
#include <arenite/rigid/pose.hpp>

namespace arenite::inline ARENITE_INSTRUCTION_SET {

/// One contact of two bodies for the solver, in axes of its own: the normal first, out of the second body,
/// then the tangents. Its velocity is that of the first body against the second, w = W_1 u_1 - W_2 u_2.
template <int D>
struct ContactConstraint : LocalContact<D> {
  static constexpr int N = D + rotations<D>;
  std::size_t body[2];                ///< first, second
  Eigen::Matrix<double, D, N> to[2];  ///< W_1, -W_2: from a body's twist
  Eigen::Matrix<double, N, D> by[2];  ///< change of each twist by the impulse

  Vec<double, D> velocity(const std::vector<Twist<double, D>>& u) const;
  void add(const Vec<double, D>& change, std::vector<Twist<double, D>>& u);
};

/// Finds impulses j that keep to the laws of contact: w_n >= least, j_n >= 0 and one of them an equality;
/// |j_t| <= mu j_n, and where contact slips j_t = -mu j_n w_t / |w_t|. Projected Gauss-Seidel sweeps find
/// which contacts act, stick and slip; the linear equations of these are then solved together, so that
/// masses may differ by any factor (Alart and Curnier 1991, doi:10.1016/0045-7825(91)90022-X). Serial.
template <int D>
class ContactSolver {
 public:
  using Rows = std::vector<ContactConstraint<D>>;
  using Twists = std::vector<Twist<double, D>>;

  /// Starts from the impulses in `rows` and the twists `u` that they have led to. Returns by how much the
  /// worst contact fails, m/s; `scale`: size of the velocities, m/s.
  double solve(Rows& rows, Twists& u, double scale);

 private:
  void solve_active(Rows& rows, Twists& u);

  struct Unknown {
    std::size_t row;
    int axis;              // of the equation
    Vec<double, D> along;  // impulse of one unit
  };
  std::vector<Unknown> unknowns_{};
};

}  // namespace arenite::inline ARENITE_INSTRUCTION_SET

#ifndef ARENITE_COLD_LIBRARY
#include <arenite/rigid/contact_solver_cold.hpp>
#endif
