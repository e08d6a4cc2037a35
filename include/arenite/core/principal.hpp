// Principal values of a symmetric tensor and the way back, without eigenvectors and without a branch: what an
// isotropic law needs to work in principal space, on a scalar or on a pack. Derivation:
// docs/return_mapping.md.
#pragma once
// SPDX-License-Identifier: BSD-3-Clause

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstddef>

#include <arenite/core/tensor.hpp>

namespace arenite::inline ARENITE_INSTRUCTION_SET {

/// Determinant of the full 3 x 3 tensor.
template <class T>
constexpr T determinant(const Sym<T, 3>& a) {
  return a[0] * (a[1] * a[2] - a[4] * a[4]) - a[3] * (a[3] * a[2] - a[4] * a[5]) +
         a[5] * (a[3] * a[4] - a[1] * a[5]);
}

/// Adjugate: determinant times inverse, defined for a singular tensor too.
template <class T>
constexpr Sym<T, 3> adjugate(const Sym<T, 3>& a) {
  return {{a[1] * a[2] - a[4] * a[4], a[0] * a[2] - a[5] * a[5], a[0] * a[1] - a[3] * a[3],
           a[4] * a[5] - a[3] * a[2], a[3] * a[5] - a[4] * a[0], a[3] * a[4] - a[1] * a[5]}};
}

/// Below this, Pa, a difference of stresses counts as none: far below the round-off of any stress, far above
/// the smallest float.
inline constexpr double smallest_divisor = 1e-30;

namespace detail {

/// `smallest_divisor` for a square, Pa2.
template <class T>
inline constexpr double smallest_square = sizeof(scalar_of<T>) == 8 ? 1e-60 : 1e-30;

/// sum of c[i] x^i for i in [First, First + Count), divided by x^First, by halves (Estrin): short chains of
/// products. `power[k]` is x^(2^k).
template <std::size_t First, std::size_t Count, class T, std::size_t N, std::size_t M>
constexpr T estrin(const std::array<double, N>& c, const std::array<T, M>& power) {
  if constexpr (Count == 1) {
    return T(c[First]);
  } else {
    constexpr std::size_t k = std::bit_width(Count - 1) - 1;
    constexpr std::size_t low = std::size_t{1} << k;
    return estrin<First, low>(c, power) + estrin<First + low, Count - low>(c, power) * power[k];
  }
}

/// cos(acos(x) / 3) on [0, 1]: the largest root of 4 h^3 - 3 h = x. It is analytic there (its singularity is
/// at x = -1), so that one polynomial gives it to 1e-16 (degree 17) or 2e-8 (degree 7); interpolated at the
/// Chebyshev points of [0, 1].
template <class T>
constexpr T largest_root(const T& x) {
  constexpr std::array<double, 18> precise{
      0.86602540378443873005,    0.16666666666661262033,      -0.04811252242660946188,
      0.024691357771510435208,   -0.015592015353421944667,    0.010973855336693904614,
      -0.0082572314241811055956, 0.0064980087625027022798,    -0.005267714315990528889,
      0.0043253746156409206364,  -0.0035013775402922052472,   0.0026791866935705904022,
      -0.0018346099925369495948, 0.0010569235322796502456,    -0.00047872684103641011719,
      0.00015687248194256659165, -0.000032674987080270459479, 3.2232359568001076352e-6};
  constexpr std::array<double, 8> coarse{0.866025416391,    0.166665043063,   -0.0480773503449,
                                         0.0243923838316,   -0.0142895648259, 0.00766430175491,
                                         -0.00292283050216, 0.000542607712772};
  const T x2 = x * x, x4 = x2 * x2;
  if constexpr (sizeof(scalar_of<T>) == 4) {
    return estrin<0, coarse.size()>(coarse, std::array<T, 3>{x, x2, x4});
  } else {
    const T x8 = x4 * x4;
    return estrin<0, precise.size()>(precise, std::array<T, 5>{x, x2, x4, x8, x8 * x8});
  }
}

}  // namespace detail

/// Spectral decomposition of a symmetric tensor. `value` has its principal values, largest first; `with(y)`
/// is the tensor that has the same axes and the principal values y.
template <class T, int D>
class Principal;

/// In a plane problem z is an axis: the other two follow from Mohr's circle.
template <class T>
class Principal<T, 2> {
 public:
  std::array<T, 3> value;  ///< l1 >= l2 >= l3

  explicit Principal(const Sym<T, 2>& s) : half_difference_((s[0] - s[1]) * T(0.5)), shear_(s[3]) {
    using std::max, std::min;
    const T centre = (s[0] + s[1]) * T(0.5);
    const T square = half_difference_ * half_difference_ + shear_ * shear_;
    inverse_radius_ = reciprocal_root(max(square, T(detail::smallest_square<T>)));
    const T radius = square * inverse_radius_;
    const T a = centre + radius, b = centre - radius, z = s[2];
    value = {max(a, z), max(b, min(a, z)), min(b, z)};
    z_ = z;
    a_ = a;
    b_ = b;
  }

  /// The tensor of the same axes with principal values y (y[i] along the axis of value[i]). Where two values
  /// are equal their axes are undefined, and y must be equal there too; near it the error vanishes with the
  /// difference of y.
  Sym<T, 2> with(const std::array<T, 3>& y) const {
    const auto z_first = z_ >= a_, z_last = b_ >= z_;
    const T ya = select(z_first, y[1], y[0]);
    const T yb = select(z_last && !z_first, y[1], y[2]);
    const T yz = select(z_first, y[0], select(z_last, y[2], y[1]));
    const T centre = (ya + yb) * T(0.5);
    const T ratio = (ya - yb) * T(0.5) * inverse_radius_;
    return {{centre + ratio * half_difference_, centre - ratio * half_difference_, yz, ratio * shear_}};
  }

 private:
  T half_difference_, shear_, inverse_radius_, z_, a_, b_;
};

/// In 3-D the value h of n = dev s / q that stands apart comes from the characteristic cubic in its
/// trigonometric form. The other two may be nearly equal: their axis pair is split off, which gives their
/// difference to round-off too.
template <class T>
class Principal<T, 3> {
 public:
  std::array<T, 3> value;  ///< l1 >= l2 >= l3

  explicit Principal(const Sym<T, 3>& s) {
    using std::abs, std::max, std::min;
    const T mean = trace(s) * T(1.0 / 3);
    Sym<T, 3> dev = add_isotropic(s, T(-mean));
    dev[2] = -(dev[0] + dev[1]);  // no trace, even where the mean is far larger than the deviator
    const T q2 = contract(dev, dev) * T(2.0 / 3);  // (2 sqrt(J2/3))^2
    const T least = T(detail::smallest_square<T>);
    const T inverse = select(q2 > least, reciprocal_root(max(q2, least)), T(0));
    const T q = q2 * inverse;
    const Sym<T, 3> n = dev * inverse;

    const T x = T(4) * determinant(n);  // cos of three times Lode's angle
    positive_ = x >= T(0);
    const T size = detail::largest_root(T(min(abs(x), T(1))));
    const T h = select(positive_, size, T(-size));

    // The trace of the adjugate is 3 h^2 - 3/4, at least 3/2 (where n is zero, nothing comes of it).
    apart_ = adjugate(add_isotropic(n, T(-h))) * reciprocal(T(T(3) * h * h - T(0.75)));
    rest_ = add_isotropic(n - apart_ * T(T(1.5) * h), T(T(0.5) * h));
    const T gap2 = T(2) * contract(rest_, rest_);
    inverse_gap_ = reciprocal_root(max(gap2, least));
    const T gap = gap2 * inverse_gap_;

    const T upper = mean + q * (gap - h) * T(0.5), lower = mean - q * (gap + h) * T(0.5),
            single = mean + q * h;
    value = {select(positive_, single, upper), select(positive_, upper, lower),
             select(positive_, lower, single)};
  }

  /// The tensor of the same axes with principal values y (y[i] along the axis of value[i]). Where two values
  /// are equal their axes are undefined, and y must be equal there too; near it the error vanishes with the
  /// difference of y.
  Sym<T, 3> with(const std::array<T, 3>& y) const {
    const T single = select(positive_, y[0], y[2]);
    const T upper = select(positive_, y[1], y[0]);
    const T lower = select(positive_, y[2], y[1]);
    const T mean = (upper + lower) * T(0.5);
    const T ratio = (upper - lower) * inverse_gap_;
    return add_isotropic(apart_ * T(single - mean) + rest_ * ratio, mean);
  }

 private:
  decltype(T(0) < T(0)) positive_;  // the value that stands apart is the largest (else the smallest)
  Sym<T, 3> apart_, rest_;          // projector on its axis; what is left of n, with values +-gap/2
  T inverse_gap_;                   // 1 over the gap between the other two
};

}  // namespace arenite::inline ARENITE_INSTRUCTION_SET
