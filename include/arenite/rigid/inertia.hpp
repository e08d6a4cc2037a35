// Moments of inertia of a rigid body, as a user gives them.
#pragma once
// SPDX-License-Identifier: BSD-3-Clause

#include <array>
#include <initializer_list>
#include <limits>

#include <arenite/core/cold.hpp>
#include <arenite/core/tensor.hpp>

namespace arenite::inline ARENITE_INSTRUCTION_SET {

/// Moments of inertia about the centre of mass, kg m2, along the axes of the scene at the start: one number
/// (the same about all axes; the only one in the plane), three about x, y and z, or six: xx, yy, zz, xy, yz,
/// zx of the tensor, integral of (|r|^2 delta_ij - r_i r_j) dm.
class Inertia {
 public:
  Inertia() { parts_.fill(std::numeric_limits<double>::quiet_NaN()); }
  Inertia(double about_any_axis) : parts_{about_any_axis, about_any_axis, about_any_axis, 0, 0, 0} {}
  Inertia(std::initializer_list<double> parts);
  template <class Tensor>
  requires(Tensor::RowsAtCompileTime == 3 && Tensor::ColsAtCompileTime == 3) Inertia(const Tensor& m)
      : parts_{m(0, 0), m(1, 1), m(2, 2), m(0, 1), m(1, 2), m(0, 2)} {}

  double about_z() const { return parts_[2]; }
  template <int D = 3>
  Mat<double, D> tensor() const {
    const auto& [xx, yy, zz, xy, yz, zx] = parts_;
    Mat<double, D> m;
    m << xx, xy, zx, xy, yy, yz, zx, yz, zz;
    return m;
  }
  /// Throws `error` unless some distribution of mass has these moments: in the plane one number above zero;
  /// in space a positive definite tensor none of whose principal moments is greater than the others together.
  template <int D>
  void check() const;

 private:
  std::array<double, 6> parts_;
};

}  // namespace arenite::inline ARENITE_INSTRUCTION_SET

#ifndef ARENITE_COLD_LIBRARY
#include <arenite/rigid/inertia_cold.hpp>
#endif
