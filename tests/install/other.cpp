// The second translation unit: includes what the first includes, and uses it too.
#include "other.hpp"

using namespace arenite;

double mean_stress_elsewhere() {
  const double sum = parallel_reduce(
      3, 0.0,
      [](std::size_t begin, std::size_t end) {
        double part = 0;
        for (std::size_t i = begin; i < end; ++i) part += static_cast<double>(i + 1) * 1_kPa;
        return part;
      },
      [](double a, double b) { return a + b; });
  require(sum > 0, "sum", sum, "must be positive");
  return sum / 3;
}
