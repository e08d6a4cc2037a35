// Cold functions of inertia.hpp.
#pragma once
// SPDX-License-Identifier: BSD-3-Clause

#include <algorithm>
#include <cmath>

#include <arenite/core/error.hpp>
#include <arenite/rigid/inertia.hpp>

namespace arenite::inline ARENITE_INSTRUCTION_SET {

namespace detail {
/// Whether all principal values lie above -margin.
template <int D>
bool is_positive(Mat<double, D> m, double margin) {
  m.diagonal().array() += margin;
  const double second = m(0, 0) * m(1, 1) - m(0, 1) * m(1, 0);
  const double third = m(0, 0) * (m(1, 1) * m(2, 2) - m(1, 2) * m(2, 1)) -
                       m(0, 1) * (m(1, 0) * m(2, 2) - m(1, 2) * m(2, 0)) +
                       m(0, 2) * (m(1, 0) * m(2, 1) - m(1, 1) * m(2, 0));
  return m(0, 0) > 0 && second > 0 && third > 0;
}
}  // namespace detail

ARENITE_COLD Inertia::Inertia(std::initializer_list<double> parts) : parts_{} {
  require(parts.size() == 1 || parts.size() == 3 || parts.size() == 6, "Inertia: numbers", parts.size(),
          "must be 1, 3 or 6");
  std::copy(parts.begin(), parts.end(), parts_.begin());
  if (parts.size() == 1) parts_[1] = parts_[2] = parts_[0];
}

template <int D>
ARENITE_COLD void Inertia::check() const {
  require(std::isfinite(about_z()) && about_z() > 0, "Free.inertia", about_z(), "must be given, positive");
  if constexpr (D == 3) {
    const Mat<double, D> m = tensor<D>();
    require(m.allFinite() && detail::is_positive<D>(m, 0), "Free.inertia", vector_text(m.diagonal()),
            "must be finite and positive definite");
    const Mat<double, 3> of_mass = m.trace() / 2 * Mat<double, D>::Identity() - m;  // integral of r r^T dm
    require(detail::is_positive<D>(of_mass, 1e-9 * m.trace()), "Free.inertia", vector_text(m.diagonal()),
            "must be that of a body: no principal moment is greater than the other two together");
  }
}

#define ARENITE_INSTANCES(D) template void Inertia::check<D>() const;
ARENITE_FOR_DIMENSIONS(ARENITE_INSTANCES)
#undef ARENITE_INSTANCES

}  // namespace arenite::inline ARENITE_INSTRUCTION_SET
