// Moments of inertia of a rigid body, as a user gives them.
#pragma once
// SPDX-License-Identifier: BSD-3-Clause

#include <algorithm>
#include <array>
#include <cmath>
#include <initializer_list>
#include <limits>

#include <arenite/core/error.hpp>
#include <arenite/core/tensor.hpp>

namespace arenite::inline ARENITE_INSTRUCTION_SET {

/// Moments of inertia about the centre of mass, kg m2, along the axes of the scene at the start: one number
/// (the same about all axes; the only one in the plane), three about x, y and z, or six: xx, yy, zz, xy, yz,
/// zx of the tensor, integral of (|r|^2 delta_ij - r_i r_j) dm.
class Inertia {
 public:
  Inertia() { parts_.fill(std::numeric_limits<double>::quiet_NaN()); }
  Inertia(double about_any_axis) : parts_{about_any_axis, about_any_axis, about_any_axis, 0, 0, 0} {}
  Inertia(std::initializer_list<double> parts) : parts_{} {
    require(parts.size() == 1 || parts.size() == 3 || parts.size() == 6, "Inertia: numbers", parts.size(),
            "must be 1, 3 or 6");
    std::copy(parts.begin(), parts.end(), parts_.begin());
    if (parts.size() == 1) parts_[1] = parts_[2] = parts_[0];
  }
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
  void check() const {
    require(std::isfinite(about_z()) && about_z() > 0, "Free.inertia", about_z(), "must be given, positive");
    if constexpr (D == 3) {
      const Mat<double, D> m = tensor<D>();
      require(m.allFinite() && is_positive<D>(m, 0), "Free.inertia", vector_text(m.diagonal()),
              "must be finite and positive definite");
      const Mat<double, 3> of_mass = m.trace() / 2 * Mat<double, D>::Identity() - m;  // integral of r r^T dm
      require(is_positive<D>(of_mass, 1e-9 * m.trace()), "Free.inertia", vector_text(m.diagonal()),
              "must be that of a body: no principal moment is greater than the other two together");
    }
  }

 private:
  /// Whether all principal values lie above -margin.
  template <int D>
  static bool is_positive(Mat<double, D> m, double margin) {
    m.diagonal().array() += margin;
    const double second = m(0, 0) * m(1, 1) - m(0, 1) * m(1, 0);
    const double third = m(0, 0) * (m(1, 1) * m(2, 2) - m(1, 2) * m(2, 1)) -
                         m(0, 1) * (m(1, 0) * m(2, 2) - m(1, 2) * m(2, 0)) +
                         m(0, 2) * (m(1, 0) * m(2, 1) - m(1, 1) * m(2, 0));
    return m(0, 0) > 0 && second > 0 && third > 0;
  }

  std::array<double, 6> parts_;
};

}  // namespace arenite::inline ARENITE_INSTRUCTION_SET
