// Relaxation of one contact with Coulomb friction: what a sweep of projected Gauss-Seidel does to it.
#pragma once
// SPDX-License-Identifier: BSD-3-Clause

#include <algorithm>
#include <cmath>

#include <arenite/core/tensor.hpp>

namespace arenite::inline ARENITE_INSTRUCTION_SET {

/// Axes of a contact, [D x D]: the rows are the unit normal and the tangents.
template <int D>
Mat<double, D> contact_axes(const Vec<double, D>& normal) {
  Mat<double, D> axes;
  axes.row(0) = normal.transpose();
  if constexpr (D == 2) {
    axes.row(1) << -normal[1], normal[0];
  } else {
    const Vec<double, D> beside = normal.unitOrthogonal();
    axes.row(1) = beside.transpose();
    axes.row(2) = normal.cross(beside).transpose();
  }
  return axes;
}

// In the axes of a contact: w is its relative velocity, m/s; `response`, 1/kg, the change of w by an impulse.

/// Bound of the response along the tangents; in the plane the response itself. Where no impulse moves
/// anything along them, the share `floor` of the normal response takes its place.
template <int D>
double tangential_response(const Mat<double, D>& response, double floor) {
  return std::max(response.trace() - response(0, 0), floor * response(0, 0));
}

/// The impulse, N s, that one contact takes while all others keep theirs: first along the normal, so that
/// w_n >= least, j_n >= 0 and one of them is an equality; then along the tangents, with the velocity that
/// this leaves, cut to |j_t| <= friction j_n. An impulse that it leaves as it is keeps to all laws of contact.
/// `across`: `tangential_response`; `friction`: coefficient, infinite for no slip.
template <int D>
Vec<double, D> relaxed_impulse(const Vec<double, D>& impulse, Vec<double, D> w, double least,
                               const Mat<double, D>& response, double across, double friction) {
  Vec<double, D> next = Vec<double, D>::Zero();
  next[0] = std::max(0.0, impulse[0] - (w[0] - least) / response(0, 0));
  if (next[0] == 0) return next;
  w += (next[0] - impulse[0]) * response.col(0);
  Vec<double, D - 1> along = impulse.template tail<D - 1>() - w.template tail<D - 1>() / across;
  if (const double size = along.norm(), most = friction * next[0]; size > most) along *= most / size;
  next.template tail<D - 1>() = along;
  return next;
}

/// Size of a change of impulse, as a velocity, m/s.
template <int D>
double velocity_change(const Vec<double, D>& change, const Mat<double, D>& response, double across) {
  return std::max(std::abs(change[0]) * response(0, 0), change.template tail<D - 1>().norm() * across);
}

}  // namespace arenite::inline ARENITE_INSTRUCTION_SET
