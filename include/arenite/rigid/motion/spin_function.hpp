// Angular velocities and moments as a user gives them: {x, y, z}, in the plane only z.
#pragma once
// SPDX-License-Identifier: BSD-3-Clause

#include <array>
#include <cmath>
#include <string_view>

#include <arenite/core/error.hpp>
#include <arenite/functions/place_function.hpp>
#include <arenite/rigid/body/pose.hpp>

namespace arenite::inline ARENITE_INSTRUCTION_SET {

/// One that a user gave as the parameter `name`. Throws `error` unless it is finite, and about z in the
/// plane.
template <int D>
Spin<double, D> spin_argument(std::string_view name, const std::array<double, 3>& given) {
  Spin<double, D> spin;
  for (std::size_t k = 0; k < 3; ++k) {
    require(std::isfinite(given[k]), name, given[k], "must be finite");
    if (D == 3)
      spin[static_cast<int>(k) % rotations<D>] = given[k];
    else
      require(k == 2 || given[k] == 0, name, given[k], "must be about z in a plane scene");
  }
  if (D == 2) spin[0] = given[2];
  return spin;
}

/// Angular velocity or moment that a function gives at a position, m, and time, s. Throws `run_error`.
template <int D>
Spin<double, D> spin_value_at(const VectorFunction& f, const Vec<double, D>& position, double time,
                              std::string_view name) {
  const Triple all = f(in_space(position), time);
  try {
    return spin_argument<D>(name, all);
  } catch (const error& e) {
    throw run_error(joined_text({"t = ", time, " s: ", e.what()}));
  }
}

}  // namespace arenite::inline ARENITE_INSTRUCTION_SET
