// What the units of this test tell each other.
#pragma once

#include <array>
#include <cstddef>
#include <string>

struct Result {
  std::array<double, 2> sums;  ///< of the stresses of each scene, Pa, and its kinetic energy
  std::size_t cells;           ///< read from a file
  int threads;                 ///< of the pool that the unit sees
};

// The same source, compiled with other flags.
Result run_sse2(const std::string& prefix);
Result run_avx2(const std::string& prefix);
Result run_avx512(const std::string& prefix);
