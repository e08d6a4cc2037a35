// Velocity field: the motion around a point, which it hands to the nodes.
#pragma once
// SPDX-License-Identifier: BSD-3-Clause

#include <arenite/simd/lanes.hpp>

namespace arenite::inline ARENITE_INSTRUCTION_SET {

/// v(x) = value + gradient (x - x_p); constant, without a gradient, unless `Linear`.
template <class P, std::size_t D, bool Linear>
struct VelocityField {
  static constexpr bool linear = Linear;
  std::array<P, D> value;                        ///< at the point, m/s
  std::array<P, Linear ? D * D : 0> gradient{};  ///< [D x D] column by column, 1/s

  /// At a node, from the offsets to it along each axis, m: `offset(a)`.
  template <class Offset>
  std::array<P, D> at(Offset&& offset) const {
    auto v = value;
    repeat<D>([&](std::size_t d) {
      repeat<Linear ? D : 0>([&](std::size_t a) { v[d] += gradient[a * D + d] * offset(a); });
    });
    return v;
  }
};
template <class P, std::size_t D>
VelocityField(const std::array<P, D>&) -> VelocityField<P, D, false>;
template <class P, std::size_t D, std::size_t N>
VelocityField(const std::array<P, D>&, const std::array<P, N>&) -> VelocityField<P, D, true>;

}  // namespace arenite::inline ARENITE_INSTRUCTION_SET
