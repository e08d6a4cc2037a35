#include "contacts.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace arenite::ffp {

std::vector<Glitch> glitches_of(const Measurement& m, double gravity) {
  constexpr double largest_interval = 2e-3, least = 5;  // s, g
  std::vector<Glitch> found;
  const auto& a = m.deceleration;
  for (std::size_t i = 2; !m.step_means && i + 2 < a.size(); ++i) {
    const double beside = (a[i - 1] + a[i + 1]) / 2, high = std::abs(a[i] - beside);
    if (high < least * gravity || m.time[i + 1] - m.time[i - 1] > 2 * largest_interval) continue;
    if (std::abs(a[i + 1] - a[i - 1]) < 0.1 * high && std::abs(a[i - 2] - beside) < 0.2 * high &&
        std::abs(a[i + 2] - beside) < 0.2 * high)
      found.push_back({i, beside});
  }
  return found;
}

Measurement without(const std::vector<Glitch>& glitches, Measurement m) {
  for (const Glitch& glitch : glitches) m.deceleration[glitch.sample] = glitch.beside;
  return m;
}

RecordSearch::RecordSearch(Measurement m, const ImpactSettings& s)
    : m_{std::move(m)},
      clean_{without(glitches_of(m_, s.gravity), m_)},
      s_{s},
      means_{interval_means(m_)},
      filtered_{filter(m_, means_)},
      clean_means_{interval_means(clean_)},
      clean_filtered_{filter(clean_, clean_means_)},
      integral_{m_.time, means_},
      clean_integral_{m_.time, clean_means_} {
  constexpr double quiet = 0.5, least = 0.1;  // g, s
  const std::size_t n = m_.time.size();
  still_.assign(n + 1, n);
  for (std::size_t i = n, last = n; i-- > 0;) {  // last: of the quiet samples from i on
    const bool is_quiet = std::abs(clean_filtered_[i]) < quiet * s_.gravity;
    if (!is_quiet) last = n;
    if (is_quiet && last == n) last = i;
    still_[i] = is_quiet && m_.time[last] - m_.time[i] >= least ? i : still_[i + 1];
  }
}

std::vector<double> RecordSearch::filter(const Measurement& m, const std::vector<double>& means) const {
  if (s_.window <= 0) return m.deceleration;
  std::vector<double> filtered = moving_average(m.time, means, s_.window);
  // A window that reaches no other sample would only mix the intervals beside it.
  const double reach = s_.window / 2 * (1 + 1e-6);
  for (std::size_t i = 0; !m.step_means && i < filtered.size(); ++i)
    if ((i == 0 || m.time[i] - m.time[i - 1] > reach) &&
        (i + 1 == filtered.size() || m.time[i + 1] - m.time[i] > reach))
      filtered[i] = m.deceleration[i];
  return filtered;
}

std::size_t RecordSearch::at(double t) const {
  return static_cast<std::size_t>(
      std::max<std::ptrdiff_t>(std::upper_bound(m_.time.begin(), m_.time.end(), t) - m_.time.begin() - 1, 0));
}

std::optional<double> RecordSearch::release(double impact) const {
  const auto& filtered = clean_filtered_;
  std::size_t i = at(impact);
  if (s_.in_water) {  // anywhere in the last seconds, by the largest acceleration
    constexpr double longest = 10;
    std::size_t from = i;
    while (from > 0 && m_.time[from - 1] > impact - longest) --from;
    i = static_cast<std::size_t>(std::min_element(filtered.begin() + static_cast<std::ptrdiff_t>(from),
                                                  filtered.begin() + static_cast<std::ptrdiff_t>(i) + 1) -
                                 filtered.begin());
  } else {
    while (i > 0 && m_.time[i] > impact - s_.window) --i;  // out of the filtered rise
  }
  const double level = s_.in_water ? filtered[i] / 2 : -0.5 * s_.gravity;
  if (filtered[i] > std::min(level, -0.3 * s_.gravity)) return std::nullopt;
  while (i > 0 && filtered[i - 1] <= level) --i;
  if (i == 0) return std::nullopt;
  const double share = (level - filtered[i - 1]) / (filtered[i] - filtered[i - 1]);
  return m_.time[i - 1] + share * (m_.time[i] - m_.time[i - 1]);
}

std::optional<double> RecordSearch::rest(double peak_time) const {
  constexpr double after = 0.3, over = 0.02;  // s
  const double end = std::min(m_.time.back(), peak_time + after);
  if (end - over <= peak_time) return std::nullopt;
  const double mean = (clean_integral_(end) - clean_integral_(end - over)) / over;
  return std::abs(mean) < 0.3 * s_.gravity ? std::optional{end} : std::nullopt;
}

double RecordSearch::peak_after(double impact) const {
  constexpr double longest = 0.5;  // s
  const std::size_t from = at(impact), still = still_[from];
  std::size_t peak = from;
  for (std::size_t i = from; i < m_.time.size(); ++i) {
    if (!m_.step_means && m_.time[i] > impact + longest && i >= still) break;
    if (clean_filtered_[i] > clean_filtered_[peak]) peak = i;
  }
  return m_.time[peak];
}

/// The contact after sample `before`, the last of the fall; samples from `end` on are not its own.
Contact RecordSearch::contact(std::size_t before, std::size_t end) const {
  const double level = s_.threshold * s_.gravity;
  std::size_t peak = before + 1;
  for (std::size_t k = peak; k < end; ++k)
    if (clean_filtered_[k] > clean_filtered_[peak]) peak = k;
  // The filter smears the rise over its window: the samples show where in it.
  std::size_t i = before;
  while (i + 1 < peak && m_.time[i + 1] <= m_.time[before] + s_.window) ++i;
  while (i > 0 && clean_.deceleration[i] > level && m_.time[i - 1] >= m_.time[before] - s_.window) --i;
  if (clean_.deceleration[i] > level) i = before;
  const double a = clean_.deceleration[i], b = clean_.deceleration[i + 1];
  Contact c;
  c.time = m_.time[i];
  const double interval = m_.time[i + 1] - m_.time[i];
  const double share = (level - a) / (b - a);
  if (!m_.step_means && b > level && a <= level) c.time += share * interval;
  c.uncertain = std::max(c.time - m_.time[i], m_.time[i + 1] - c.time);
  // Samples farther apart than the window reaches: the rise is taken back to where it began.
  if (!m_.step_means && i + 2 < m_.time.size() && interval > s_.window && s_.window > 0) {
    const double slope = (clean_.deceleration[i + 2] - b) / (m_.time[i + 2] - m_.time[i + 1]);
    c.time = slope > 0 ? std::max(m_.time[i], m_.time[i + 1] - (b - a) / slope) : m_.time[i] + interval / 2;
    c.uncertain = interval / 2;
  }
  c.peak_time = m_.time[peak];
  c.peak = clean_filtered_[peak];
  c.release = release(c.time);
  if (c.release) c.velocity = clean_integral_(*c.release) - clean_integral_(c.time);
  return c;
}

/// Sets depth and end: from the contact on, until it stands.
void RecordSearch::follow(Contact& c, double until) const {
  const double first = c.velocity.value_or(0);
  double v = first, t = c.time;
  c.depth = 0;
  c.end = until;
  for (std::size_t i = at(c.time) + 1; i < m_.time.size() && m_.time[i] <= until; ++i) {
    const double next = first - (clean_integral_(m_.time[i]) - clean_integral_(c.time));
    c.depth += (v + next) / 2 * (m_.time[i] - t);
    v = next;
    t = m_.time[i];
    // In water it may fall on steadily.
    const bool stands = still_[i] == i && (!s_.in_water || !c.velocity || v <= 0.5 * first);
    if (t > c.peak_time && (stands || (c.velocity && v <= 0.1 * first))) {
      c.end = t;
      return;
    }
  }
}

void RecordSearch::choose_impact(Descent& fall, double until) const {
  fall.impact = 0;
  for (std::size_t k = 0; k < fall.contacts.size(); ++k) {
    follow(fall.contacts[k], until);
    if (fall.impact == 0 && k > 0 && fall.contacts[0].depth > s_.length &&
        fall.contacts[k].depth <= s_.length)
      fall.impact = k;
  }
  const Contact& c = fall.at_impact();
  double last = c.peak_time, highest = c.peak;
  for (const Contact& other : fall.contacts)
    if (other.time > c.time && other.peak > highest) highest = other.peak, last = other.peak_time;
  const auto stands = rest(last);
  fall.velocity = c.velocity ? *c.velocity : stands ? clean_integral_(*stands) - clean_integral_(c.time) : 0;
}

std::vector<Descent> RecordSearch::falls() const {
  const double level = s_.threshold * s_.gravity, least = std::max(0.5, s_.threshold + 0.3) * s_.gravity;
  const std::size_t n = m_.time.size();
  std::vector<Contact> all;
  for (std::size_t i = 0; i + 1 < n; ++i) {
    if (!(clean_filtered_[i] <= level && clean_filtered_[i + 1] > level)) continue;
    bool high = false;
    std::size_t end = i + 1;
    for (; end < n && clean_filtered_[end] > level && still_[end] != end; ++end)
      high = high || clean_filtered_[end] > least;
    if (high) all.push_back(contact(i, end));
  }
  std::vector<Descent> found;
  for (Contact& c : all) {
    if (found.empty()) {
      found.push_back({{c}});
      continue;
    }
    Contact& before = found.back().contacts.back();
    follow(before, c.time);
    const bool own = c.release && *c.release > before.time;  // else it fell on, or that of the contact before
    const double from = own ? *c.release : c.time;
    const double then = before.velocity.value_or(0) - (clean_integral_(from) - clean_integral_(before.time));
    const std::size_t still = still_[at(before.peak_time)];
    const bool rested = !s_.in_water && still < n && m_.time[still] < from;
    // It moves on: upward after a bounce, downward in a void or in water.
    const bool goes_on = !rested && own && before.velocity && std::abs(then) > 0.1 * *c.velocity;
    if (before.velocity && (!own || goes_on)) c.velocity = then + (own ? *c.velocity : 0);
    if (before.end < from && !goes_on)
      found.push_back({{c}});
    else
      found.back().contacts.push_back(c);
  }
  for (std::size_t k = 0; k < found.size(); ++k)
    choose_impact(found[k], k + 1 < found.size()
                                ? found[k + 1].contacts[0].release.value_or(found[k + 1].contacts[0].time)
                                : m_.time.back());
  return found;
}

std::vector<std::size_t> RecordSearch::drops(const std::vector<Descent>& falls) const {
  constexpr double share = 0.25, least = 0.5;  // of the fastest; m/s
  // A contact without a release is a drop that the record begins with, or a knock.
  const bool released =
      std::ranges::any_of(falls, [](const Descent& f) { return f.at_impact().release.has_value(); });
  double fastest = 0;
  for (const Descent& fall : falls) fastest = std::max(fastest, fall.velocity);
  std::vector<std::size_t> found;
  for (std::size_t k = 0; k < falls.size(); ++k) {
    const double v = falls[k].velocity;
    if (v >= std::min(fastest, std::max(share * fastest, least)) &&
        (falls[k].at_impact().release || !released || (k == 0 && !s_.in_water)))
      found.push_back(k);
  }
  return found;
}

std::vector<std::pair<double, double>> RecordSearch::knocks(const std::vector<Descent>& falls) const {
  constexpr double least = 2, apart = 0.05;  // g, s
  std::vector<std::pair<double, double>> found;
  double last = 0;
  std::size_t k = 0;
  for (std::size_t i = 0; i < m_.time.size(); ++i) {
    const double t = m_.time[i], a = clean_filtered_[i];
    if (std::abs(a) < least * s_.gravity) continue;
    while (k < falls.size() && t > std::max(falls[k].end(), falls[k].contacts.back().peak_time) + apart) ++k;
    if (k < falls.size() && t >= falls[k].contacts[0].time - apart) continue;
    if (found.empty() || t > last + apart)
      found.emplace_back(t, a);
    else if (std::abs(a) > std::abs(found.back().second))
      found.back() = {t, a};
    last = t;
  }
  return found;
}

}  // namespace arenite::ffp
