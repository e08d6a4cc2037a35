// Runs two units that were compiled with other flags in one program: FIRST and SECOND name their functions.
#include <arenite/core/parallel.hpp>
#include <cmath>
#include <cstdio>

#include "units.hpp"

int main() {
  arenite::set_threads(2);
  const Result a = FIRST("first_"), b = SECOND("second_");
  bool good = a.threads == 2 && b.threads == 2 && a.cells == 1 && b.cells == 1;
  for (std::size_t k = 0; k < a.sums.size(); ++k) {
    std::printf("scene %zu: %.17g, %.17g\n", k, a.sums[k], b.sums[k]);
    good = good && std::abs(a.sums[k] - b.sums[k]) <= 1e-6 * std::abs(a.sums[k]);
  }
  return good ? 0 : 1;
}
