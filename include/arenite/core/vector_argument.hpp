// Vectors of a user, always {x, y, z}, and those of a scene, which have as many components as the scene has
// dimensions.
#pragma once
// SPDX-License-Identifier: BSD-3-Clause

#include <array>
#include <cstddef>
#include <string_view>

#include <arenite/core/cold.hpp>
#include <arenite/core/error.hpp>
#include <arenite/core/tensor.hpp>

namespace arenite::inline ARENITE_INSTRUCTION_SET {

/// {x, y, z} of a vector of the scene, z = 0 in two dimensions: what functions of a user are given.
template <class T, int D>
std::array<double, 3> in_space(const Vec<T, D>& v) {
  std::array<double, 3> all{};
  for (int k = 0; k < D; ++k) all[static_cast<std::size_t>(k)] = static_cast<double>(v[k]);
  return all;
}

/// The vector [D] of the first components of {x, y, z}: the way back from `in_space`.
template <int D, class T = double>
Vec<T, D> in_scene(const std::array<double, 3>& all) {
  Vec<T, D> v;
  for (int k = 0; k < D; ++k) v[k] = static_cast<T>(all[static_cast<std::size_t>(k)]);
  return v;
}

/// Throws `error` unless all components of the parameter `name` are finite and those along axes beyond
/// the scene's `dimensions` are zero.
void check_vector_argument(std::string_view name, const std::array<double, 3>& given, int dimensions);

/// The vector [D] that a user gave as the parameter `name`, once it is checked.
template <class T, int D>
Vec<T, D> vector_argument(std::string_view name, const std::array<double, 3>& given) {
  check_vector_argument(name, given, D);
  return in_scene<D, T>(given);
}

/// A user's direction as a vector of the scene; it must have a length, and is not made a unit vector.
template <class T, int D>
Vec<T, D> direction_argument(std::string_view name, const std::array<double, 3>& given) {
  Vec<T, D> v;
  T squared = 0;
  for (int k = 0; k < D; ++k) {
    v[k] = static_cast<T>(given[static_cast<std::size_t>(k)]);
    squared += v[k] * v[k];
  }
  require(squared > 0, name, vector_text(v), "must have a length in the scene's dimensions");
  return vector_argument<T, D>(name, given);
}

}  // namespace arenite::inline ARENITE_INSTRUCTION_SET

#if ARENITE_HAS_COLD

#include <cmath>

namespace arenite::inline ARENITE_INSTRUCTION_SET {

ARENITE_COLD void check_vector_argument(std::string_view name, const std::array<double, 3>& given,
                                        int dimensions) {
  for (int k = 0; k < 3; ++k) {
    const double component = given[static_cast<std::size_t>(k)];
    require(std::isfinite(component), name, component, "must be finite");
    require(k < dimensions || component == 0, name, component,
            "must be zero along an axis that the scene does not have");
  }
}

}  // namespace arenite::inline ARENITE_INSTRUCTION_SET

#endif  // ARENITE_HAS_COLD
