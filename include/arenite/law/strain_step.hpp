// Input of a law for one step: strain, spin and time.
#pragma once
// SPDX-License-Identifier: BSD-3-Clause

#include <arenite/core/tensor.hpp>

namespace arenite::inline ARENITE_INSTRUCTION_SET {

/// Motion of a point, or of a pack of points, in one step.
template <class T, int D>
struct StrainStep {
  Sym<T, D> strain;  ///< symmetric part of the velocity gradient L times dt, -
  /// Skew part W = (L - L^T)/2 times dt, -: (W_xy) for D = 2, (W_xy, W_yz, W_zx) for D = 3, W_ij = (v_i,j -
  /// v_j,i)/2.
  std::array<T, D == 2 ? 1 : 3> spin{};
  double dt = 0;  ///< duration, s, the same for all points of a pack; 0: no time passes, and there is no rate

  /// Component (i, j) of L dt, i, j < 3, -.
  constexpr T gradient(int i, int j) const {
    const bool ahead = j == (i + 1) % 3;
    const auto k = static_cast<std::size_t>(ahead ? i : j);  // of the spin
    if (i == j || k >= spin.size()) return strain(i, j);
    return ahead ? strain(i, j) + spin[k] : strain(i, j) - spin[k];
  }
  /// 1/dt, 1/s: times the strain it is the rate of strain; 0 where no time passes.
  double per_time() const { return dt > 0 ? 1 / dt : 0; }
};

}  // namespace arenite::inline ARENITE_INSTRUCTION_SET
