// Small tensors: vectors and matrices are Eigen's; symmetric tensors are our own, because a plane problem
// carries an out-of-plane component and because a law's scalar may be a pack.
#pragma once
// SPDX-License-Identifier: BSD-3-Clause

#include <Eigen/Core>
#include <array>
#include <cstddef>
#include <utility>

#include <arenite/core/scalar.hpp>

namespace arenite::inline ARENITE_INSTRUCTION_SET {

/// Vector of the space, shape [D]. Unaligned, so that a column of them has no holes.
template <class T, int D>
using Vec = Eigen::Matrix<T, D, 1, Eigen::DontAlign>;

/// Matrix, shape [D x D].
template <class T, int D>
using Mat = Eigen::Matrix<T, D, D, Eigen::DontAlign>;

/// A vector or matrix of one number. Eigen's `Constant` and `Zero` are expressions: for each type two classes more to compile, and an
/// assignment.
template <class V>
V filled(typename V::Scalar number) {
  V v;
  for (Eigen::Index k = 0; k < v.size(); ++k) v.data()[k] = number;
  return v;
}
template <class V>
V zeros() {
  return filled<V>(0);
}

/// v . w, from the first component on.
template <class T, int D>
T dot(const Vec<T, D>& v, const Vec<T, D>& w) {
  T sum = v[0] * w[0];
  for (int k = 1; k < D; ++k) sum += v[k] * w[k];
  return sum;
}

/// Symmetric second-order tensor in 3-D space, as its independent components.
/// D = 2: (xx, yy, zz, xy), with z out of plane (plane strain) or hoop (axisymmetric; x = r, y = axial).
/// D = 3: (xx, yy, zz, xy, yz, zx). Shear components are those of the tensor, not engineering strains.
template <class T, int D>
struct Sym {
  static_assert(D == 2 || D == 3);
  static constexpr std::size_t size = D == 2 ? 4 : 6;
  std::array<T, size> c{};

  constexpr T& operator[](std::size_t i) { return c[i]; }
  constexpr const T& operator[](std::size_t i) const { return c[i]; }

  /// Place of the component (i, j), i, j < D.
  static constexpr std::size_t index(std::size_t i, std::size_t j) {
    return i == j ? i : i + j == 1 ? 3 : i + j == 3 ? 4 : 5;
  }

  /// Component (i, j) of the full tensor, i, j < 3.
  constexpr T operator()(int i, int j) const {
    if (i == j) return c[static_cast<std::size_t>(i)];
    if (i + j == 1) return c[3];
    if constexpr (D == 3) return i + j == 3 ? c[4] : c[5];
    return T(0);
  }

  /// Component by component; unrolled by the language, not left to an optimiser's level.
  template <class F>
  static constexpr Sym each(F&& f) {
    return [&]<std::size_t... At>(std::index_sequence<At...>) { return Sym{{f(At)...}}; }
    (std::make_index_sequence<size>{});
  }
  constexpr Sym& operator+=(const Sym& o) { return *this = *this + o; }
  constexpr Sym& operator-=(const Sym& o) { return *this = *this - o; }
  constexpr Sym& operator*=(const T& s) { return *this = *this * s; }
  friend constexpr Sym operator+(const Sym& a, const Sym& b) {
    return each([&](std::size_t i) { return a.c[i] + b.c[i]; });
  }
  friend constexpr Sym operator-(const Sym& a, const Sym& b) {
    return each([&](std::size_t i) { return a.c[i] - b.c[i]; });
  }
  friend constexpr Sym operator*(const Sym& a, const T& s) {
    return each([&](std::size_t i) { return a.c[i] * s; });
  }
  friend constexpr Sym operator*(const T& s, const Sym& a) { return a * s; }
};

/// xx + yy + zz
template <class T, int D>
constexpr T trace(const Sym<T, D>& a) {
  return a[0] + a[1] + a[2];
}

/// a + s I
template <class T, int D>
constexpr Sym<T, D> add_isotropic(const Sym<T, D>& a, const T& s) {
  Sym<T, D> r = a;
  r[0] = a[0] + s;
  r[1] = a[1] + s;
  r[2] = a[2] + s;
  return r;
}

/// a - tr(a)/3 I
template <class T, int D>
constexpr Sym<T, D> deviator(const Sym<T, D>& a) {
  return add_isotropic(a, T(trace(a) * T(-1.0 / 3)));
}

/// Double contraction a : b.
template <class T, int D>
constexpr T contract(const Sym<T, D>& a, const Sym<T, D>& b) {
  T shear = a[3] * b[3];
  if constexpr (D == 3) shear = shear + a[4] * b[4] + a[5] * b[5];
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2] + T(2) * shear;
}

}  // namespace arenite::inline ARENITE_INSTRUCTION_SET
