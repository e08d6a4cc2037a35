// Declarations shared by the units of this test.
#pragma once

#include <array>
#include <cstddef>

struct Result {
  std::array<double, 2> sums;  ///< of the stresses of each scene, Pa, and its kinetic energy
  std::size_t cells;           ///< read from a file
  int threads;                 ///< of the pool that the unit sees
};

extern int heard;  ///< warnings, by the hook of the first unit

// The same source, compiled with other flags. The unit to which `threads` > 0 is given sets the threads and
// the hook of warnings for all.
Result run_sse2(const char* prefix, int threads);
Result run_avx2(const char* prefix, int threads);
Result run_avx512(const char* prefix, int threads);
