#include "levels.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include "../drop/peaks.hpp"
#include "../text/words.hpp"

namespace arenite::ffp {

namespace {

/// The levels around the largest deviation from the median within the windows' samples; `taken`: times
/// around which it is not sought, to which its own is added.
Levels levels_at_largest(const Measurement& m, double gravity, bool in_water, const PeakWindow& window,
                         std::vector<double>& taken) {
  constexpr double least = 0.02, longest = 1, quiet = 0.1;  // s, s, g
  constexpr double margin = 0.02;                           // s, around the release
  const double longest_fall = in_water ? 10 : 2;            // s
  Levels levels;
  const auto& t = m.time;
  const std::vector<double> means = interval_means(m);
  const StepIntegral integral{t, means};
  const auto mean = [&](double from, double to) {
    return (integral(to) - integral(from)) / (to - from) / gravity;
  };
  const auto level = [&](double from, double to) -> std::optional<double> {
    if (!(from >= t.front() && to <= t.back() && to - from >= least * (1 - 1e-9))) return std::nullopt;
    const auto samples =
        std::lower_bound(t.begin(), t.end(), to) - std::lower_bound(t.begin(), t.end(), from);
    if (samples < 4) return std::nullopt;
    const double first = mean(from, (from + to) / 2), second = mean((from + to) / 2, to);
    return std::abs(first - second) < quiet ? std::optional{(first + second) / 2} : std::nullopt;
  };

  // The peak, whatever its sign.
  std::vector<double> x = m.deceleration;
  const auto middle = x.begin() + static_cast<std::ptrdiff_t>(x.size() / 2);
  std::nth_element(x.begin(), middle, x.end());
  const double median = *middle;
  x = moving_average(t, means, 2e-3);
  constexpr double apart = 0.25;  // s, between two shocks
  const auto counts = [&](std::size_t i) {
    return t[i] >= window.from && t[i] <= window.to &&
           std::ranges::none_of(taken, [&](double other) { return std::abs(t[i] - other) < apart; });
  };
  std::size_t peak = 0;
  double largest = -1;
  for (std::size_t i = 0; i < x.size(); ++i)
    if (std::abs(x[i] - median) > largest && counts(i)) largest = std::abs(x[peak = i] - median);
  if (largest < 1.5 * gravity) {
    if (!taken.empty()) return {};
    peak = static_cast<std::size_t>(std::max_element(x.begin(), x.end()) - x.begin());
  } else {
    levels.peak_sign = x[peak] > median ? 1 : -1;
  }
  taken.push_back(t[peak]);
  const double sign = levels.peak_sign < 0 ? -1 : 1, height = sign * x[peak] / gravity;

  // The fall: the quiet level before the peak that is farthest from it, and of equal ones the last.
  std::size_t bottom = peak;
  for (std::size_t i = peak; i > 0 && t[i] > t[peak] - longest_fall; --i)
    if (const auto here = level(t[i] - least, t[i]);
        here && sign * *here < height - 1 && (!levels.fall || sign * *here < sign * *levels.fall - quiet)) {
      levels.fall = here;
      bottom = i;
    }
  if (levels.fall) {  // all of it, and what came before the release
    const auto falls = [&](std::size_t i) {
      return t[i] - least > t.front() && sign * (mean(t[i] - least, t[i]) - *levels.fall) < 0.25;
    };
    std::size_t first = bottom, last = bottom;
    while (first > 0 && falls(first)) --first;
    while (last < peak && falls(last)) ++last;
    const double to = t[first] - least - margin;
    levels.before = level(std::max(t.front(), to - longest), to);
    if (t[last] - least > t[first] + least) levels.fall = mean(t[first], t[last] - least);
  }

  // The rest after the end, at most 1 g above the fall.
  const double end = std::min(t.back(), t[peak] + 0.4), from = std::max(end - 0.1, (t[peak] + end) / 2);
  levels.after = level(from, end);
  const double ground = levels.fall.value_or(-sign);
  if (levels.after && !(sign * (*levels.after - ground) > -0.3 &&
                        sign * (*levels.after - ground) < (levels.fall ? 1.3 : 2.3)))
    levels.after.reset();
  return levels;
}

}  // namespace

Levels levels_of(const Measurement& m, double gravity, bool in_water,
                 const std::optional<PeakWindow>& window) {
  std::vector<double> taken;
  const Levels of_largest = levels_at_largest(m, gravity, in_water, window.value_or(PeakWindow{}), taken);
  if (window) return of_largest;
  constexpr int most = 6;  // shocks: a knock may be larger than the drop
  Levels levels = of_largest;
  for (int k = 1; k < most && levels.peak_sign != 0 && !(levels.fall && levels.offset()); ++k)
    levels = levels_at_largest(m, gravity, in_water, {}, taken);
  return levels.fall && levels.offset() ? levels : of_largest;
}

namespace {

/// Whether the levels are those of a record that is read as it should be; `sign`, `shift`: another reading,
/// sign x level + shift.
bool fits(const Levels& levels, bool in_water, double sign = 1, double shift = 0) {
  const auto is = [&](const std::optional<double>& level, double right) {
    return !level || std::abs(sign * *level + shift - right) < 0.3;
  };
  return is(levels.offset(), 0) && (in_water || is(levels.fall, -1)) && sign * levels.peak_sign >= 0;
}

/// Whether they show anything; in water the fall need not be free.
bool tells(const Levels& levels, bool in_water) { return levels.offset() || (!in_water && levels.fall); }

}  // namespace

std::string text_of(const Levels& levels, double sign, double shift) {
  std::string text;
  for (const auto& [level, where] : {std::pair{levels.before, " g before the release"},
                                     {levels.fall, " g in the fall"},
                                     {levels.after, " g after the end"}})
    if (level)
      text +=
          (text.empty() ? "" : ", ") + rounded(std::round((sign * *level + shift) * 1e4) / 1e4 + 0.0) + where;
  return text;
}

std::optional<ReadingProblem> reading_problem(const Measurement& m, const Levels& levels,
                                              const ReduceOptions& o, double gravity,
                                              const std::optional<PeakWindow>& window) {
  const bool water = o.medium == Medium::water;
  if (fits(levels, water) || !tells(levels, water)) return std::nullopt;
  const double sign = o.invert ? -1 : 1, shift = o.reads == Reading::proper ? 1 : 0;
  const std::string told = "the record reads " + text_of(levels, sign, sign * shift) + "; ";
  // A record in m/s^2 that is read in g, or the other way round, has another unit.
  for (const double unit : {1.0, gravity, 1 / gravity}) {
    const Levels in_unit = unit == 1 ? levels : levels_of(m, gravity * unit, water, window);
    if (unit != 1 &&
        (!in_unit.fall || !in_unit.offset() || std::abs(*in_unit.offset() - *in_unit.fall) < 0.7))
      continue;  // no step of 1 g shows the unit
    for (const bool invert : {o.invert, !o.invert})
      for (const Reading reads : {o.reads, o.reads == Reading::net ? Reading::proper : Reading::net}) {
        const double turned = invert == o.invert ? 1 : -1;
        const double moved = turned * shift / unit - (reads == Reading::proper ? 1 : 0);
        if (!tells(in_unit, water) || !fits(in_unit, water, turned, moved)) continue;
        std::string give;
        const auto add = [&](const std::string& text) { give += (give.empty() ? "give " : " and ") + text; };
        if (unit != 1) add(unit > 1 ? "--deceleration-unit m_s2" : "--deceleration-unit g");
        if (reads != o.reads) add("--reads " + word_of(reading_words, reads));
        if (invert && !o.invert) add("--invert");
        const std::string leave = o.invert && !invert ? "leave out --invert" : "";
        return ReadingProblem{told + leave + (leave.empty() || give.empty() ? "" : "; ") + give, true};
      }
  }
  return ReadingProblem{told +
                            "a net record reads 0, -1 and 0, a proper one 1, 0 and 1: are unit, scale, "
                            "--gravity and --medium those of the record?",
                        false};
}

}  // namespace arenite::ffp
