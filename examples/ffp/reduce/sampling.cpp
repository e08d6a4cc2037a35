#include "sampling.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

#include <arenite/core/error.hpp>

#include "../text/words.hpp"

namespace arenite::ffp {

std::vector<std::string> sampling_warnings(const Measurement& m, double release, double impact, double rest,
                                           double gravity) {
  std::vector<std::string> warnings;
  const auto at = [&](double t) {
    return static_cast<std::size_t>(std::lower_bound(m.time.begin(), m.time.end(), t) - m.time.begin());
  };
  const std::size_t first = at(release), end = at(rest), hit = at(impact);
  if (end - hit < 10)
    warnings.push_back(joined_text({"there are ", end - hit,
                                    " samples between impact and rest, too few for a peak or a depth; "
                                    "is the unit of the time that of the record (--time-unit)?"}));
  if (end - first < 4 || end == hit) return warnings;

  std::vector<double> intervals;
  std::size_t widest = first + 1;
  for (std::size_t i = first + 1; i < end; ++i) {
    intervals.push_back(m.time[i] - m.time[i - 1]);
    if (m.time[i] - m.time[i - 1] > m.time[widest] - m.time[widest - 1]) widest = i;
  }
  const auto usual = intervals.begin() + static_cast<std::ptrdiff_t>(intervals.size() * 19 / 20);
  std::nth_element(intervals.begin(), usual, intervals.end());
  const double gap = m.time[widest] - m.time[widest - 1];
  if (gap > 1.5 * *usual)
    warnings.push_back(
        joined_text({"the record has a gap of ", rounded(gap * 1e3), " ms at ", m.time[widest - 1],
                     " s, where others have at most ", rounded(*usual * 1e3),
                     " ms between samples; it is taken as straight there"}));

  // Equal samples at the largest, which end with a jump: the top of a curve ends with the resolution's steps.
  const auto& a = m.deceleration;
  const auto flat = [&](std::size_t samples) {
    return joined_text(
        {"the record stays at its largest, ",
         rounded(*std::max_element(a.begin() + static_cast<std::ptrdiff_t>(hit),
                                   a.begin() + static_cast<std::ptrdiff_t>(end)) /
                 gravity),
         " g, for ", samples,
         " samples, as an accelerometer at the end of its range: the peak is larger, the depth less"});
  };
  double step = std::numeric_limits<double>::infinity();
  for (std::size_t i = first + 1; i < end; ++i)
    if (a[i] != a[i - 1]) step = std::min(step, std::abs(a[i] - a[i - 1]));
  const auto largest = std::max_element(a.begin() + static_cast<std::ptrdiff_t>(hit),
                                        a.begin() + static_cast<std::ptrdiff_t>(end));
  const auto begin = static_cast<std::size_t>(largest - a.begin());
  std::size_t behind = begin;
  while (behind < end && a[behind] == *largest) ++behind;
  const double before = begin > 0 ? *largest - a[begin - 1] : 0,
               after = behind < a.size() ? *largest - a[behind] : 0;
  const bool exact = behind - begin >= 4 && std::max(before, after) > 3 * step;
  if (exact) warnings.push_back(flat(behind - begin));
  // The same with noise: samples within it, and a fall beside them that no rounded top has (2.25 times it).
  std::vector<double> noise;
  for (std::size_t i = first + 1; i < hit; ++i) noise.push_back(std::abs(a[i] - a[i - 1]));
  if (noise.empty()) return warnings;
  const auto half = noise.begin() + static_cast<std::ptrdiff_t>(noise.size() / 2);
  std::nth_element(noise.begin(), half, noise.end());
  const double within = 8 * *half;
  std::size_t from = begin, to = begin;
  while (from > hit && a[from - 1] >= *largest - within) --from;
  while (to + 1 < end && a[to + 1] >= *largest - within) ++to;
  const std::size_t n = to + 1 - from, beside = n / 4 + 1;
  if (!exact && n >= 6 && from >= beside && to + beside < a.size() &&
      std::min(*largest - a[from - beside], *largest - a[to + beside]) > 6 * std::max(within, step))
    warnings.push_back(flat(n));
  return warnings;
}

}  // namespace arenite::ffp
