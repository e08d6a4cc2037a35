// Lines cut into pieces whose length follows a wish that changes along the line.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include <arenite/core/error.hpp>

namespace arenite::ffp {

/// Cuts [from, to] into pieces of about `size(x)` (m, positive): as many as fit best, at least one, each the
/// same share of the integral of dx / size. Returns all ends, the first and the last exactly `from` and `to`.
template <class Size>
std::vector<double> graded(double from, double to, Size&& size) {
  require(to > from, "graded.to", to, "must be greater than the line's start");
  constexpr std::size_t samples = 4096;
  const double step = (to - from) / samples;
  std::vector<double> pieces(samples + 1, 0.0);  // number of pieces from the start to sample i
  for (std::size_t i = 0; i < samples; ++i)
    pieces[i + 1] = pieces[i] + step / size(from + (static_cast<double>(i) + 0.5) * step);
  const auto n = std::max<long>(1, std::lround(pieces.back()));
  std::vector<double> x{from};
  std::size_t i = 0;
  for (long k = 1; k < n; ++k) {
    const double wanted = pieces.back() * static_cast<double>(k) / static_cast<double>(n);
    while (pieces[i + 1] < wanted) ++i;
    const double inside = (wanted - pieces[i]) / (pieces[i + 1] - pieces[i]);
    x.push_back(from + (static_cast<double>(i) + inside) * step);
  }
  x.push_back(to);
  return x;
}

/// The same with pieces of equal length.
inline std::vector<double> even(double from, double to, double size) {
  return graded(from, to, [&](double) { return size; });
}

}  // namespace arenite::ffp
