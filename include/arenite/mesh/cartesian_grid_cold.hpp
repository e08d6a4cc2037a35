// Cold functions of cartesian_grid.hpp.
#pragma once
// SPDX-License-Identifier: BSD-3-Clause

#include <cmath>
#include <limits>

#include <arenite/mesh/cartesian_grid.hpp>

namespace arenite::inline ARENITE_INSTRUCTION_SET {

template <int D, real_scalar T>
ARENITE_COLD CartesianGrid<D, T>::CartesianGrid(const Parameters& p) : edge_{static_cast<T>(p.cell)} {
  require(p.cell > 0 && std::isfinite(p.cell), "CartesianGrid.cell", p.cell, "must be positive");
  detail::check_edge<T>("CartesianGrid.cell", p.cell);
  double total = 1;
  for (std::size_t k = 0; k < D; ++k) {
    const double extent = p.upper[k] - p.lower[k];
    require(extent > 0 && std::isfinite(extent), {"CartesianGrid.upper[", k, "]"}, p.upper[k],
            {"must be finite and exceed lower = ", p.lower[k]});
    const double cells = std::round(extent / p.cell);
    require(cells >= 1 && std::abs(cells * p.cell - extent) <= 1e-6 * p.cell, "CartesianGrid.cell", p.cell,
            {"must divide the extent ", extent, " along axis ", k});
    lower_[static_cast<int>(k)] = static_cast<T>(p.lower[k]);
    total *= cells;
    require(total < 2147483648.0, "CartesianGrid.cell", p.cell, "gives more than 2^31 cells");
    count_[k] = static_cast<Index>(cells);
    // A position on the upper face is known to the round-off of its coordinate.
    const double size = cells + std::abs(p.lower[k]) / p.cell;
    end_[k] = static_cast<T>(cells + 4 * static_cast<double>(std::numeric_limits<T>::epsilon()) * size);
  }
  inverse_edge_ = 1 / edge_;
}

#define ARENITE_INSTANCES(T, D) template CartesianGrid<D, T>::CartesianGrid(const Parameters&);
ARENITE_FOR_NUMBERS_AND_DIMENSIONS(ARENITE_INSTANCES)
#undef ARENITE_INSTANCES

}  // namespace arenite::inline ARENITE_INSTRUCTION_SET
