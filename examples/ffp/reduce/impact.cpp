#include "impact.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

#include <arenite/core/error.hpp>

#include "../text/words.hpp"

namespace arenite::ffp {

namespace {

/// The fall that is meant.
struct ChosenFall {
  double impact = 0, peak_time = 0;          // s
  std::optional<double> release, uncertain;  // s
};

ChosenFall chosen_fall(const RecordSearch& search, const ImpactSettings& s) {
  const Measurement& m = search.measurement();
  if (s.impact_time) {
    require(*s.impact_time >= m.time.front() && *s.impact_time < m.time.back(), "--impact-time",
            *s.impact_time, {"must lie in the record, [", m.time.front(), ", ", m.time.back(), ") s"});
    return {*s.impact_time, search.peak_after(*s.impact_time), search.release(*s.impact_time), {}};
  }
  const auto falls = search.falls();
  if (falls.empty()) {
    const auto& filtered = search.filtered();
    const double peak = *std::max_element(filtered.begin(), filtered.end());
    require(peak > 0, "largest deceleration", peak / s.gravity,
            "must be positive, in g; is the record positive when the penetrometer gets faster (--invert)?");
    const auto last = std::max_element(filtered.begin(), filtered.end());
    std::size_t left = 0;  // the last sample of a fall before the peak
    for (auto i = filtered.begin(); i < last; ++i)
      if (*i <= s.threshold * s.gravity) left = static_cast<std::size_t>(i - filtered.begin()) + 1;
    if (left > 0)
      throw error(joined_text({"the deceleration leaves the fall (", s.threshold, " g) at ",
                               text_of_time(m.time[left - 1]),
                               " s, and no impact follows at once; does the accelerometer hold a level (an "
                               "AC-coupled one does not), and is the fall free? Else give --impact-time, or "
                               "another --threshold"}));
    throw error(
        joined_text({"no sample before the peak lies at or below ", s.threshold,
                     " g, so that the impact cannot be found, in ", rounded(m.time.back() - m.time.front()),
                     " s with a peak of ", rounded(peak / s.gravity),
                     " g; are these units and sign (--invert) of the record? Else give "
                     "--impact-time, or another --threshold"}));
  }
  std::size_t k = search.drops(falls).front();
  for (std::size_t i = 0; s.drop_at && i < falls.size(); ++i)
    if (std::abs(falls[i].at_impact().time - *s.drop_at) < std::abs(falls[k].at_impact().time - *s.drop_at))
      k = i;
  const Descent& fall = falls[k];
  const Contact& c = fall.at_impact();
  ChosenFall chosen{c.time, c.peak_time, fall.contacts.front().release, c.uncertain};
  double highest = c.peak;
  for (std::size_t i = fall.impact; i < fall.contacts.size(); ++i)
    if (fall.contacts[i].peak > highest) {
      highest = fall.contacts[i].peak;
      chosen.peak_time = fall.contacts[i].peak_time;
    }
  return chosen;
}

/// Time of the first rest after the impact, interpolated. `left`: velocity that counts as rest, m/s.
std::optional<double> first_rest(const Motion& m, double left) {
  const double still = left + 1e-9 * m.impact_velocity;
  for (std::size_t i = 1; i < m.time.size(); ++i)
    if (m.velocity[i] <= still) {
      const double over = m.velocity[i - 1] - left,
                   share = over / (over - std::min(m.velocity[i] - left, 0.0));
      return m.time[i - 1] + share * (m.time[i] - m.time[i - 1]);
    }
  return std::nullopt;
}

}  // namespace

Motion motion_of(Measurement record, const ImpactSettings& s) {
  Motion motion;
  for (double& a : record.deceleration) a -= s.offset;
  const RecordSearch search{std::move(record), s};
  const Measurement& m = search.measurement();
  const auto [impact, peak_time, release, uncertain] = chosen_fall(search, s);
  motion.impact_time = impact;
  motion.impact_uncertain = uncertain;
  motion.release = release;
  motion.impact_from = s.impact_time ? "given" : "threshold";

  const auto rest = search.rest(peak_time);
  if (s.impact_velocity) {
    motion.impact_velocity = *s.impact_velocity;
    motion.velocity_from = "given";
  } else if (release) {
    motion.impact_velocity = -search.slowed(*release, impact);
    motion.velocity_from = "release";
  } else if (rest && *rest > impact) {
    motion.impact_velocity = search.slowed(impact, *rest);
    motion.velocity_from = "rest";
  } else {
    throw error("the record holds neither the release nor the rest after the impact; give --impact-velocity");
  }
  require(motion.impact_velocity > 0, "velocity at the impact", motion.impact_velocity,
          "must be positive, in m/s; give --impact-velocity or --impact-time");
  require(motion.impact_velocity <= 100, "velocity at the impact", motion.impact_velocity,
          "must be at most 100 m/s; is the unit of the time that of the record (--time-unit)?");
  if (rest && *rest > impact && motion.velocity_from != "rest")
    motion.velocity_left = motion.impact_velocity - search.slowed(impact, *rest);

  // The impact itself, then every sample after it.
  const std::size_t before = search.at(impact), first = before + 1;
  require(first < m.time.size(), "time of the impact", impact, "no sample of the record comes after it");
  const double share = (impact - m.time[before]) / (m.time[first] - m.time[before]);
  const auto between = [&](const std::vector<double>& v) {
    return v[before] + share * (v[first] - v[before]);
  };
  motion.time = {0};
  motion.deceleration = {m.step_means && share > 0 ? m.deceleration[first] : between(m.deceleration)};
  motion.filtered = {between(search.filtered())};
  motion.velocity = {motion.impact_velocity};
  motion.depth = {m.depth.empty() ? s.impact_depth : between(m.depth)};
  for (std::size_t i = first; i < m.time.size(); ++i) {
    const double t = m.time[i] - impact, dt = t - motion.time.back();
    const double mean =
        i > first || m.step_means ? search.means()[i] : (motion.deceleration.front() + m.deceleration[i]) / 2;
    const double v = motion.velocity.back();
    motion.velocity.push_back(v - mean * dt);
    motion.depth.push_back(m.depth.empty() ? motion.depth.back() + (v + motion.velocity.back()) / 2 * dt
                                           : m.depth[i]);
    motion.time.push_back(t);
    motion.deceleration.push_back(m.deceleration[i]);
    motion.filtered.push_back(search.filtered()[i]);
  }
  // A small velocity that the integral of samples leaves at rest is no motion. Back from rest it leaves
  // nothing there, but creeps before: half a per cent.
  const double left =
      motion.velocity_from == "rest" ? 5e-3 * motion.impact_velocity : motion.velocity_left.value_or(0);
  const bool is_rest = !m.step_means && left > 0 && left < unbelievable_left * motion.impact_velocity;
  motion.stop = first_rest(motion, is_rest ? left : 0);
  if (!motion.stop && motion.velocity_from == "rest") motion.stop = *rest - impact;
  constexpr double shown_after_rest = 0.1, shown_without = 1;  // s
  const double last = motion.stop ? *motion.stop + shown_after_rest : shown_without;
  const auto n = static_cast<std::size_t>(std::upper_bound(motion.time.begin(), motion.time.end(), last) -
                                          motion.time.begin());
  for (auto* column : {&motion.time, &motion.deceleration, &motion.filtered, &motion.velocity, &motion.depth})
    column->resize(std::min(column->size(), std::max<std::size_t>(n, 2)));
  return motion;
}

}  // namespace arenite::ffp
