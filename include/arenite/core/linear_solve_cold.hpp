// Cold functions of linear_solve.hpp.
#pragma once
// SPDX-License-Identifier: BSD-3-Clause

#include <cmath>
#include <utility>

#include <arenite/core/cold.hpp>
#include <arenite/core/linear_solve.hpp>

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
