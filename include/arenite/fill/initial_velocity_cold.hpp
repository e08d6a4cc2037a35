// Cold functions of initial_velocity.hpp.
#pragma once
// SPDX-License-Identifier: BSD-3-Clause

#include <algorithm>
#include <cmath>
#include <span>

#include <arenite/fill/initial_velocity.hpp>

namespace arenite::inline ARENITE_INSTRUCTION_SET {

ARENITE_COLD InitialVelocity::InitialVelocity(std::initializer_list<double> v) {
  require(v.size() <= 3, "FillOptions.velocity, components", v.size(), "must be at most 3");
  std::copy(v.begin(), v.end(), uniform_.begin());
}

ARENITE_COLD InitialVelocity::Three InitialVelocity::checked(const Three& x, int dimensions) const {
  const Three v = is_uniform() ? uniform_ : at_(x);
  if (std::isfinite(v[0]) && std::isfinite(v[1]) && std::isfinite(v[2]) && (dimensions == 3 || v[2] == 0))
    return v;
  const std::string place = vector_text(std::span(x).first(static_cast<std::size_t>(dimensions)));
  check_vector_argument(
      is_uniform() ? "FillOptions.velocity" : joined_text({"FillOptions.velocity at ", place, " m"}), v,
      dimensions);
  return v;
}

}  // namespace arenite::inline ARENITE_INSTRUCTION_SET
