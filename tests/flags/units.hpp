// What the units of this test promise each other.
#pragma once

#include <array>
#include <cstddef>
#include <string>

struct Result {
  std::array<double, 3> stresses;
  std::size_t cells;
  int threads;
};
