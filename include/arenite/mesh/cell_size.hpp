// Sizes of cells that a scalar allows: at others, volumes or gradients overflow or underflow.
#pragma once
// SPDX-License-Identifier: BSD-3-Clause

#include <cmath>
#include <limits>
#include <string_view>

#include <arenite/core/error.hpp>
#include <arenite/core/instruction_set.hpp>
#include <arenite/core/scalar.hpp>

namespace arenite::inline ARENITE_INSTRUCTION_SET::detail {

/// Least volume of a cell that is not flat, over the D-th power of its longest edge.
template <real_scalar T>
inline constexpr T flattest = 1000 * std::numeric_limits<T>::epsilon();

/// Throws `error` unless the volume, the gradients and their squares of any cell with this longest edge [m]
/// that is not flat are normal numbers in T.
template <real_scalar T>
void check_edge(std::string_view name, double edge) {
  using Limits = std::numeric_limits<T>;
  const double least = std::cbrt(static_cast<double>(Limits::min() / flattest<T>)),
               greatest = std::cbrt(static_cast<double>(Limits::max())) / 2;
  require(edge >= least && edge <= greatest, name, edge,
          {"must lie between ", least, " and ", greatest,
           " m in the scalar of the mesh, or the cell's volume or size is not a number"});
}

}  // namespace arenite::inline ARENITE_INSTRUCTION_SET::detail
