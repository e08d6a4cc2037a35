// Runs two units that were compiled with other flags in one program: FIRST and SECOND name their functions,
// the argument "first" leaves the second out. Nothing of Arenite is compiled here.
#include <cmath>
#include <cstdio>
#include <cstring>

#include "units.hpp"

int heard = 0;

int main(int argc, char** argv) {
  const Result a = FIRST("first_", 2);
  const bool alone = argc > 1 && std::strcmp(argv[1], "first") == 0;
  const Result b = alone ? a : SECOND("second_", 0);
  bool good = a.threads == 2 && b.threads == 2 && a.cells == 1 && b.cells == 1 && heard == (alone ? 1 : 2);
  for (std::size_t k = 0; k < a.sums.size(); ++k) {
    std::printf("scene %zu: %.17g, %.17g\n", k, a.sums[k], b.sums[k]);
    good = good && std::abs(a.sums[k] - b.sums[k]) <= 1e-6 * std::abs(a.sums[k]);
  }
  return good ? 0 : 1;
}
