// Check of a condition in a fuzz target, in every build.
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstdlib>

inline void must(bool holds) {
  if (!holds) std::abort();
}
