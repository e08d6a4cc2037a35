// MlsGradient: B-splines whose gradients are those of moving least squares, as in MLS-MPM.
#pragma once
// SPDX-License-Identifier: BSD-3-Clause

#include <array>

#include <arenite/shape/cubic_bspline.hpp>
#include <arenite/shape/quadratic_bspline.hpp>

namespace arenite::inline ARENITE_INSTRUCTION_SET {

namespace detail {

/// The functions of `Base` along an axis with the slopes w_i (x_i - x) / sum_j w_j (x_j - x)^2 where that sum is the same in the whole cell.
template <template <class> class Base>
struct MlsLines {
  template <class T>
  class Line : public Base<T> {
   public:
    using Base<T>::Base, Base<T>::nodes;
    static constexpr bool slopes_are_moments = true;

    template <class P>
    std::array<P, nodes> slopes(const P& s, T scale) const {
      const T inverse = this->inverse_inertia();
      if (inverse == 0) return Base<T>::slopes(s, scale);
      auto slope = this->values(s);
      repeat<nodes>([&](std::size_t i) {
        constexpr T first = 1 - static_cast<T>(nodes) / 2;  // place of node 0
        slope[i] = slope[i] * ((P(static_cast<T>(i) + first) - s) * P(inverse * scale));
      });
      return slope;
    }
  };
};

/// The functions of a spline along an axis.
template <class Spline>
struct SplineLines;
template <>
struct SplineLines<QuadraticBSpline> {
  template <class T>
  using Line = QuadraticBSplineLine<T>;
};
template <>
struct SplineLines<CubicBSpline> {
  template <class T>
  using Line = CubicBSplineLine<T>;
};

}  // namespace detail

/// The values of a spline, `QuadraticBSpline` or `CubicBSpline`, with gradients of moving least squares: force
/// -sum V sigma D^-1 (x_i - x_p) w_i and strains of the matrix C that APIC carries, D = sum w (x_i - x_p)
/// (x_i - x_p)^T (Hu et al. 2018, doi:10.1145/3197517.3201293). With APIC and USL that takes one sum where
/// splines take two. Linear fields have their exact gradient, others that of a wider neighbourhood.
///
/// Cells whose D is not the same everywhere, at a face or between cells of unlike sizes, have the gradients of the spline: over each cell
/// both integrate to the same, so that a uniform stress is in balance up to the faces.
///
/// Members: see `ProductShape`. Slope^2 / value sums to 4 (quadratic) or 3 (cubic) away from the faces; the layers at the faces, and with
/// them the stable step, are those of the spline.
template <class Spline>
struct MlsGradient
    : ProductShape<detail::MlsLines<detail::SplineLines<Spline>::template Line>::template Line> {
  static constexpr const char* name = "MlsGradient";
};

}  // namespace arenite::inline ARENITE_INSTRUCTION_SET
