// Cold functions of measures.hpp.
#pragma once
// SPDX-License-Identifier: BSD-3-Clause

#include <arenite/particles/measures.hpp>

namespace arenite::inline ARENITE_INSTRUCTION_SET {

template <class T>
ARENITE_COLD double sum_column(const T* values, std::size_t count) {
  return sum_points(count, 0.0, [=](std::size_t p) { return static_cast<double>(values[p]); });
}

template <class T>
ARENITE_COLD double kinetic_energy(std::size_t count, const T* mass, int dimension,
                                   const std::array<const T*, 3>& velocity) {
  return sum_points(count, 0.0, [&](std::size_t p) {
    T square = velocity[0][p] * velocity[0][p] + velocity[1][p] * velocity[1][p];
    if (dimension == 3) square += velocity[2][p] * velocity[2][p];
    return 0.5 * static_cast<double>(mass[p] * square);
  });
}

template <class T>
ARENITE_COLD std::array<double, 3> moment_of_mass(std::size_t count, const T* mass, int dimension,
                                                  const std::array<const T*, 3>& position) {
  std::array<double, 3> moment{};
  for (std::size_t k = 0; k < static_cast<std::size_t>(dimension); ++k)
    moment[k] = sum_points(count, 0.0, [&](std::size_t p) {
      return static_cast<double>(mass[p]) * static_cast<double>(position[k][p]);
    });
  return moment;
}

#define ARENITE_INSTANCES(T)                                                                  \
  template double sum_column(const T*, std::size_t);                                          \
  template double kinetic_energy(std::size_t, const T*, int, const std::array<const T*, 3>&); \
  template std::array<double, 3> moment_of_mass(std::size_t, const T*, int, const std::array<const T*, 3>&);
ARENITE_FOR_NUMBERS(ARENITE_INSTANCES)
#undef ARENITE_INSTANCES

}  // namespace arenite::inline ARENITE_INSTRUCTION_SET
