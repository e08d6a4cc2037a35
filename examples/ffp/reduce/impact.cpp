#include "impact.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

#include <arenite/core/error.hpp>

#include "../text/words.hpp"

namespace arenite::ffp {

namespace {

/// The deceleration, its filter and its integral, while the impact is looked for.
class ImpactSearch {
 public:
  ImpactSearch(Measurement m, const ImpactSettings& s)
      : m_{std::move(m)}, s_{s}, means_{interval_means(m_)}, integral_{m_.time, means_} {
    filtered_ = s_.window > 0 ? moving_average(m_.time, means_, s_.window) : m_.deceleration;
    peak_ =
        static_cast<std::size_t>(std::max_element(filtered_.begin(), filtered_.end()) - filtered_.begin());
    require(filtered_[peak_] > 0, "largest deceleration", filtered_[peak_] / s_.gravity,
            "must be positive, in g; is the record positive when the penetrometer gets faster (--invert)?");
  }

  const Measurement& measurement() const { return m_; }
  const std::vector<double>& means() const { return means_; }
  const std::vector<double>& filtered() const { return filtered_; }

  /// Time at which the deceleration leaves the fall for the last time before its peak.
  double impact() const {
    if (s_.impact_time) {
      require(*s_.impact_time >= m_.time.front() && *s_.impact_time < m_.time.back(), "--impact-time",
              *s_.impact_time, {"must lie in the record, [", m_.time.front(), ", ", m_.time.back(), ") s"});
      return *s_.impact_time;
    }
    const double level = s_.threshold * s_.gravity;
    const auto before = last_at_most(filtered_, peak_, level);
    if (!before)
      throw error(joined_text({"no sample before the peak lies at or below ", s_.threshold,
                               " g, so that the impact cannot be found, in ",
                               rounded(m_.time.back() - m_.time.front()), " s with a peak of ",
                               rounded(filtered_[peak_] / s_.gravity),
                               " g; are these units and sign (--invert) of the record? Else give "
                               "--impact-time, or another --threshold"}));
    // The filter smears the rise over its window: the samples tell where in it.
    std::size_t until = *before;
    while (until + 1 < peak_ && m_.time[until + 1] <= m_.time[*before] + s_.window) ++until;
    const auto exact = last_at_most(m_.deceleration, until, level);
    const std::size_t i = exact && m_.time[*exact] >= m_.time[*before] - s_.window ? *exact : *before;
    const double a = m_.deceleration[i], b = m_.deceleration[i + 1];
    if (m_.step_means || !(b > level) || !(a <= level)) return m_.time[i];
    return m_.time[i] + (level - a) / (b - a) * (m_.time[i + 1] - m_.time[i]);
  }

  /// Time at which the fall to an impact begins; none if the record begins in the fall.
  std::optional<double> release(double impact) const {
    std::size_t i = at(impact);
    if (s_.in_water) {  // anywhere in the last seconds, by the largest acceleration
      constexpr double longest = 10;
      std::size_t from = i;
      while (from > 0 && m_.time[from - 1] > impact - longest) --from;
      i = static_cast<std::size_t>(std::min_element(filtered_.begin() + static_cast<std::ptrdiff_t>(from),
                                                    filtered_.begin() + static_cast<std::ptrdiff_t>(i) + 1) -
                                   filtered_.begin());
    } else {
      while (i > 0 && m_.time[i] > impact - s_.window) --i;  // out of the filtered rise
    }
    const double level = s_.in_water ? filtered_[i] / 2 : -0.5 * s_.gravity;
    if (filtered_[i] > std::min(level, -0.3 * s_.gravity)) return std::nullopt;
    while (i > 0 && filtered_[i - 1] <= level) --i;
    if (i == 0) return std::nullopt;
    const double share = (level - filtered_[i - 1]) / (filtered_[i] - filtered_[i - 1]);
    return m_.time[i - 1] + share * (m_.time[i] - m_.time[i - 1]);
  }

  /// Time at which it stands, some while after the peak; none if the record ends before.
  std::optional<double> rest() const {
    constexpr double after = 0.3, over = 0.02;  // s
    const double end = std::min(m_.time.back(), m_.time[peak_] + after);
    if (end - over <= m_.time[peak_]) return std::nullopt;
    const double mean = (integral_(end) - integral_(end - over)) / over;
    return std::abs(mean) < 0.3 * s_.gravity ? std::optional{end} : std::nullopt;
  }

  /// Change of velocity between two times, m/s: positive when it slows.
  double slowed(double from, double to) const { return integral_(to) - integral_(from); }

  /// The last sample at or before a time.
  std::size_t at(double t) const {
    return static_cast<std::size_t>(std::max<std::ptrdiff_t>(
        std::upper_bound(m_.time.begin(), m_.time.end(), t) - m_.time.begin() - 1, 0));
  }

 private:
  static std::optional<std::size_t> last_at_most(const std::vector<double>& values, std::size_t from,
                                                 double level) {
    for (std::size_t i = from + 1; i-- > 0;)
      if (values[i] <= level) return i;
    return std::nullopt;
  }

  Measurement m_;
  ImpactSettings s_;
  std::vector<double> means_;
  StepIntegral integral_;
  std::vector<double> filtered_;
  std::size_t peak_ = 0;
};

/// Time of the first rest after the impact, interpolated. `left`: velocity that stands for rest, m/s.
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
  const ImpactSearch search{std::move(record), s};
  const Measurement& m = search.measurement();
  const double impact = search.impact();
  motion.impact_time = impact;
  motion.impact_from = s.impact_time ? "given" : "threshold";

  const auto release = search.release(impact), rest = search.rest();
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
  motion.depth = {s.impact_depth};
  for (std::size_t i = first; i < m.time.size(); ++i) {
    const double t = m.time[i] - impact, dt = t - motion.time.back();
    const double mean =
        i > first || m.step_means ? search.means()[i] : (motion.deceleration.front() + m.deceleration[i]) / 2;
    const double v = motion.velocity.back();
    motion.velocity.push_back(v - mean * dt);
    motion.depth.push_back(motion.depth.back() + (v + motion.velocity.back()) / 2 * dt);
    motion.time.push_back(t);
    motion.deceleration.push_back(m.deceleration[i]);
    motion.filtered.push_back(search.filtered()[i]);
  }
  // A small velocity that the integral of samples leaves at rest is no motion. Back from rest it leaves
  // nothing there, but creeps before: half a per cent.
  const double left =
      motion.velocity_from == "rest" ? 5e-3 * motion.impact_velocity : motion.velocity_left.value_or(0);
  const bool is_rest = !m.step_means && left > 0 && left < 0.1 * motion.impact_velocity;
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
