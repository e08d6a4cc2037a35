// Cold functions of constraints.hpp.
#pragma once
// SPDX-License-Identifier: BSD-3-Clause

#include <algorithm>
#include <cmath>
#include <limits>

#include <arenite/boundary/constraints.hpp>

namespace arenite::inline ARENITE_INSTRUCTION_SET {
namespace detail {

template <int D>
ARENITE_COLD void Blocked<D>::add(Vec<double, D> n, std::size_t by, std::size_t wall_of_it) {
  const auto normalize = [&n] {
    const double length = std::sqrt(dot(n, n));
    for (int i = 0; i < D && length > 0; ++i) n[i] /= length;
    return length;
  };
  normalize();
  const Vec<double, D> name = n;
  for (int pass = 0; pass < 2; ++pass)
    for (std::size_t k = 0; k < count; ++k) {
      const double along = dot(directions[k], n);
      for (int i = 0; i < D; ++i) n[i] -= along * directions[k][i];
    }
  if (count == most || !(normalize() > 1e-6)) return;
  normals[count] = name;
  part[count] = by;
  wall[count] = wall_of_it;
  directions[count++] = n;
}

template <int D>
ARENITE_COLD Mat<double, D> Blocked<D>::projector() const {
  Mat<double, D> p;
  for (int i = 0; i < D; ++i)
    for (int j = 0; j < D; ++j) {
      double blocked = 0;
      for (std::size_t k = 0; k < count; ++k) blocked += directions[k][i] * directions[k][j];
      p(i, j) = count == most ? 0 : (i == j ? 1 : 0) - blocked;
    }
  return p;
}

/// w's share of each direction, linear in u. A separate function, so that `lift` calls one: in a function that calls none
/// g++ 12 with AVX wrongly assumes that an array on the stack is aligned (its bug 109780).
template <int D>
ARENITE_COLD std::array<Vec<double, D>, Blocked<D>::most> Blocked<D>::shares(std::size_t of) const {
  std::array<Vec<double, D>, most> along;
  for (std::size_t k = 0; k < count; ++k) {
    along[k] = part[k] == of ? normals[k] : zeros<Vec<double, D>>();
    for (std::size_t j = 0; j < k; ++j) along[k] -= normals[k].dot(directions[j]) * along[j];
    along[k] /= normals[k].dot(directions[k]);
  }
  return along;
}

template <int D>
ARENITE_COLD Mat<double, D> Blocked<D>::lift(std::size_t of) const {
  const auto along = shares(of);
  Mat<double, D> all = zeros<Mat<double, D>>();
  for (std::size_t k = count; k-- > 0;)
    for (int column = 0; column < D; ++column)
      for (int row = 0; row < D; ++row)
        all(row, column) = directions[k][row] * along[k][column] + all(row, column);
  return all;
}

}  // namespace detail

template <int D>
ARENITE_COLD BoundaryNodes<D>::BoundaryNodes(const void* mesh, Index count, double epsilon)
    : mesh_{mesh}, epsilon_{epsilon}, position_(count), blocked_(count) {}

template <int D>
ARENITE_COLD void BoundaryNodes<D>::find_box() {
  for (int k = 0; k < D; ++k) {
    lower_[k] = std::numeric_limits<double>::infinity();
    upper_[k] = -lower_[k];
    for (Index i = 0; i < size(); ++i) {
      if (!is_used(i)) continue;
      lower_[k] = std::min(lower_[k], position_[i][k]);
      upper_[k] = std::max(upper_[k], position_[i][k]);
    }
  }
}

template <int D>
ARENITE_COLD double BoundaryNodes<D>::tolerance() const {
  V size;
  for (int k = 0; k < D; ++k) size[k] = upper_[k] - lower_[k];
  return 1e3 * epsilon_ * std::sqrt(dot(size, size));
}

#define ARENITE_INSTANCES(D)          \
  template struct detail::Blocked<D>; \
  template class BoundaryNodes<D>;
ARENITE_FOR_DIMENSIONS(ARENITE_INSTANCES)
#undef ARENITE_INSTANCES

}  // namespace arenite::inline ARENITE_INSTRUCTION_SET
