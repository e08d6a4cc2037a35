// Small tensors: vectors and matrices are Eigen's; symmetric tensors and increments of motion are our own,
// because a plane problem carries an out-of-plane component and because a law's scalar may be a pack.
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstddef>

#include <arenite/core/scalar.hpp>

namespace arenite {

/// Vector of the space, shape [D]. Unaligned, so that a column of them has no holes.
template <class T, int D>
using Vec = Eigen::Matrix<T, D, 1, Eigen::DontAlign>;

/// Matrix, shape [D x D].
template <class T, int D>
using Mat = Eigen::Matrix<T, D, D, Eigen::DontAlign>;

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

  /// Component (i, j) of the full tensor, i, j < 3.
  constexpr T operator()(int i, int j) const {
    if (i == j) return c[static_cast<std::size_t>(i)];
    if (i + j == 1) return c[3];
    if constexpr (D == 3) return i + j == 3 ? c[4] : c[5];
    return T(0);
  }

  constexpr Sym& operator+=(const Sym& o) {
    for (std::size_t i = 0; i < size; ++i) c[i] = c[i] + o.c[i];
    return *this;
  }
  constexpr Sym& operator-=(const Sym& o) {
    for (std::size_t i = 0; i < size; ++i) c[i] = c[i] - o.c[i];
    return *this;
  }
  constexpr Sym& operator*=(const T& s) {
    for (std::size_t i = 0; i < size; ++i) c[i] = c[i] * s;
    return *this;
  }
  friend constexpr Sym operator+(Sym a, const Sym& b) { return a += b; }
  friend constexpr Sym operator-(Sym a, const Sym& b) { return a -= b; }
  friend constexpr Sym operator*(Sym a, const T& s) { return a *= s; }
  friend constexpr Sym operator*(const T& s, Sym a) { return a *= s; }
};

template <class T, int D>
constexpr T trace(const Sym<T, D>& a) {
  return a[0] + a[1] + a[2];
}

/// a + s I
template <class T, int D>
constexpr Sym<T, D> add_isotropic(Sym<T, D> a, const T& s) {
  for (std::size_t i = 0; i < 3; ++i) a[i] = a[i] + s;
  return a;
}

template <class T, int D>
constexpr Sym<T, D> deviator(const Sym<T, D>& a) {
  return add_isotropic(a, T(trace(a) * T(-1.0 / 3)));
}

/// Double contraction a : b.
template <class T, int D>
constexpr T contract(const Sym<T, D>& a, const Sym<T, D>& b) {
  T shear = a[3] * b[3];
  for (std::size_t i = 4; i < a.size; ++i) shear = shear + a[i] * b[i];
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2] + T(2) * shear;
}

/// What a law sees of one step's motion at a point.
template <class T, int D>
struct Increment {
  Sym<T, D> strain;  ///< symmetric part of the velocity gradient times dt [-]
  /// Skew part W = (L - L^T)/2 times dt [-]: (W_xy) for D = 2, (W_xy, W_yz, W_zx) for D = 3, W_ij = (v_i,j -
  /// v_j,i)/2.
  std::array<T, D == 2 ? 1 : 3> spin{};
};

}  // namespace arenite
