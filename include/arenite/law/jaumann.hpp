// Stress that turns with the matter: the Jaumann rate, integrated so that a rigid turn changes no invariant.
#pragma once
// SPDX-License-Identifier: BSD-3-Clause

#include <arenite/core/tensor.hpp>

namespace arenite::inline ARENITE_INSTRUCTION_SET {

/// R a R^T for the rotation R of a step with spin W dt (StrainStep::spin) in the midpoint form
/// R = (I - W/2)^-1 (I + W/2): orthogonal for a step of any size, so that eigenvalues and energy keep to
/// round-off. Hughes & Winget (1980), Int. J. Numer. Meth. Engng 15, 1862-1867.
template <class T>
Sym<T, 2> turned(const Sym<T, 2>& a, const std::array<T, 1>& spin) {
  // The rotation by 2 atan(w/2); k = sin, v = 1 - cos of it. Mohr's circle turns by twice the angle.
  const T w = spin[0];
  const T scale = reciprocal(T(T(1) + T(0.25) * w * w));
  const T k = w * scale, v = T(0.5) * w * k;
  const T cos = T(1) - v;
  const T sin_double = T(2) * k * cos, versin_double = T(2) * k * k;
  const T half_difference = (a[0] - a[1]) * T(0.5);
  const T change = sin_double * a[3] - versin_double * half_difference;  // of the half difference
  return {{a[0] + change, a[1] - change, a[2], a[3] - sin_double * half_difference - versin_double * a[3]}};
}

template <class T>
Sym<T, 3> turned(const Sym<T, 3>& a, const std::array<T, 3>& spin) {
  // R = I + k (W + W^2/2) = (1 - k w^2/2) I + k (W + w w^T/2), w the axial vector, k = 1/(1 + w^2/4).
  const T x = -spin[1], y = -spin[2], z = -spin[0];
  const T square = x * x + y * y + z * z;
  const T k = reciprocal(T(T(1) + T(0.25) * square));
  const T d = T(1) - T(0.5) * k * square, h = T(0.5) * k;
  const T hx = h * x, hy = h * y;
  const T kx = k * x, ky = k * y, kz = k * z;
  const T xx = d + hx * x, yy = d + hy * y, zz = d + h * z * z;
  const T xy = hx * y, yz = hy * z, zx = hx * z;
  const T yx = xy + kz, zy = yz + kx, xz = zx + ky;  // R below the diagonal, and xz
  const T rxy = xy - kz, ryz = yz - kx, rzx = zx - ky;
  // R a, row by row, and its product with the rows of R.
  const T px = xx * a[0] + rxy * a[3] + xz * a[5];
  const T py = xx * a[3] + rxy * a[1] + xz * a[4];
  const T pz = xx * a[5] + rxy * a[4] + xz * a[2];
  const T qx = yx * a[0] + yy * a[3] + ryz * a[5];
  const T qy = yx * a[3] + yy * a[1] + ryz * a[4];
  const T qz = yx * a[5] + yy * a[4] + ryz * a[2];
  const T axx = px * xx + py * rxy + pz * xz;
  const T ayy = qx * yx + qy * yy + qz * ryz;
  return {{axx, ayy, a[2] + ((a[0] - axx) + (a[1] - ayy)), px * yx + py * yy + pz * ryz,
           qx * rzx + qy * zy + qz * zz, px * rzx + py * zy + pz * zz}};
}

}  // namespace arenite::inline ARENITE_INSTRUCTION_SET
