// Small systems of linear equations by Gaussian elimination: one function for all sizes, where Eigen's decompositions would be compiled
// for each.
#pragma once
// SPDX-License-Identifier: BSD-3-Clause

#include <cstddef>

#include <arenite/core/cold.hpp>
#include <arenite/core/tensor.hpp>

namespace arenite::inline ARENITE_INSTRUCTION_SET {

/// Solves A X = B with partial pivoting (Golub and Van Loan, Matrix Computations, 4th edition, 3.4). `a` [n x n] and `b` [n x columns],
/// by columns; `a` is overwritten, `b` becomes X. What a singular A leaves is not finite.
void solve_in_place(double* a, double* b, std::size_t n, std::size_t columns);

namespace detail {

/// Whether a symmetric matrix [n x n] is positive definite: whether elimination without pivoting finds positive pivots only. `a` is
/// overwritten.
bool has_positive_pivots(double* a, std::size_t n);

}  // namespace detail

/// x [N] of A x = b; not finite if A is singular.
template <int N>
Vec<double, N> solve_linear(Mat<double, N> a, Vec<double, N> b) {
  solve_in_place(a.data(), b.data(), static_cast<std::size_t>(N), 1);
  return b;
}

/// The inverse [N x N]; not finite if A is singular.
template <int N>
Mat<double, N> inverse_of(Mat<double, N> a) {
  Mat<double, N> inverse = zeros<Mat<double, N>>();
  for (int k = 0; k < N; ++k) inverse(k, k) = 1;
  solve_in_place(a.data(), inverse.data(), static_cast<std::size_t>(N), static_cast<std::size_t>(N));
  return inverse;
}

/// Whether a symmetric matrix is positive definite.
template <int N>
bool is_positive_definite(Mat<double, N> a) {
  return detail::has_positive_pivots(a.data(), static_cast<std::size_t>(N));
}

}  // namespace arenite::inline ARENITE_INSTRUCTION_SET

#if ARENITE_HAS_COLD

#include <cmath>
#include <utility>

namespace arenite::inline ARENITE_INSTRUCTION_SET {

ARENITE_COLD void solve_in_place(double* a, double* b, std::size_t n, std::size_t columns) {
  for (std::size_t k = 0; k < n; ++k) {
    std::size_t pivot = k;
    for (std::size_t i = k + 1; i < n; ++i)
      if (std::abs(a[i + k * n]) > std::abs(a[pivot + k * n])) pivot = i;
    if (pivot != k) {
      for (std::size_t j = k; j < n; ++j) std::swap(a[k + j * n], a[pivot + j * n]);
      for (std::size_t j = 0; j < columns; ++j) std::swap(b[k + j * n], b[pivot + j * n]);
    }
    for (std::size_t i = k + 1; i < n; ++i) {
      const double factor = a[i + k * n] / a[k + k * n];
      for (std::size_t j = k + 1; j < n; ++j) a[i + j * n] -= factor * a[k + j * n];
      for (std::size_t j = 0; j < columns; ++j) b[i + j * n] -= factor * b[k + j * n];
    }
  }
  for (std::size_t j = 0; j < columns; ++j)
    for (std::size_t k = n; k-- > 0;) {
      double sum = b[k + j * n];
      for (std::size_t i = k + 1; i < n; ++i) sum -= a[k + i * n] * b[i + j * n];
      b[k + j * n] = sum / a[k + k * n];
    }
}

ARENITE_COLD bool detail::has_positive_pivots(double* a, std::size_t n) {
  for (std::size_t k = 0; k < n; ++k) {
    if (!(a[k + k * n] > 0)) return false;
    for (std::size_t i = k + 1; i < n; ++i) {
      const double factor = a[i + k * n] / a[k + k * n];
      for (std::size_t j = k + 1; j < n; ++j) a[i + j * n] -= factor * a[k + j * n];
    }
  }
  return true;
}

}  // namespace arenite::inline ARENITE_INSTRUCTION_SET

#endif  // ARENITE_HAS_COLD
