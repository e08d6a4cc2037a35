// Coulomb's law at one contact, as relaxation takes an impulse to it.
#pragma once
// SPDX-License-Identifier: BSD-3-Clause

#include <algorithm>
#include <cmath>

#include <arenite/core/tensor.hpp>

namespace arenite::inline ARENITE_INSTRUCTION_SET {

/// A contact in axes of its own, the normal first, then the tangents: normal velocity w_n >= least, j_n >= 0 and
/// one of them an equality; |j_t| <= friction j_n, and where it slips j_t = -friction j_n w_t / |w_t|.
template <int D>
struct LocalContact {
  using V = Vec<double, D>;
  Mat<double, D> response = zeros<Mat<double, D>>();  ///< of the velocity to the impulse, m/s per N s
  double friction = 0;                                ///< coefficient; infinite: no slip
  double least = 0;                                   ///< least normal velocity, m/s
  V impulse = zeros<V>();                             ///< N s

  /// Bound of the response across the normal; in the plane the response itself. Where no impulse moves anything
  /// across the normal it would find none: it is at least `floor` times that along the normal.
  double across(double floor) const {
    return std::max(response.trace() - response(0, 0), floor * response(0, 0));
  }
  /// The impulse that would take the velocity w to its bound along the normal and to zero across it.
  V wanted(const V& w, double floor) const {
    V j;
    j[0] = impulse[0] - (w[0] - least) / response(0, 0);
    j.template tail<D - 1>() = impulse.template tail<D - 1>() - w.template tail<D - 1>() / across(floor);
    return j;
  }
  /// The nearest one along each that pushes and keeps to friction.
  V lawful(V j) const {
    j[0] = std::max(0.0, j[0]);
    auto along = j.template tail<D - 1>();
    if (j[0] == 0)
      along.setZero();
    else if (const double size = along.norm(), most = friction * j[0]; size > most)
      along *= most / size;
    return j;
  }
  /// Size of a change of the impulse, as a velocity, m/s.
  double velocity_of(const V& change, double floor) const {
    return std::max(std::abs(change[0]) * response(0, 0),
                    change.template tail<D - 1>().norm() * across(floor));
  }
};

}  // namespace arenite::inline ARENITE_INSTRUCTION_SET
