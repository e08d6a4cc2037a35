#include "reduction.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>
#include <utility>

#include "../geometry/geometry.hpp"
#include "sampling.hpp"

namespace arenite::ffp {

namespace {

ColumnPeak peak_of(const Column& column, const Motion& m, std::size_t at) {
  ColumnPeak found;
  for (std::size_t i = 0; i < column.size(); ++i)
    if (!std::isnan(column[i]) && (!found.largest || column[i] > *found.largest)) {
      found.largest = column[i];
      found.depth = m.depth[i];
    }
  if (!column.empty() && !std::isnan(column[at])) found.at_peak = column[at];
  return found;
}

/// Resistance over depth: from `from_depth` on, while the penetrometer still goes down for the first time.
void add_bearing(Reduction& r, const ReduceOptions& o, const Device& device) {
  constexpr double none = std::numeric_limits<double>::quiet_NaN();
  const Motion& m = r.motion;
  const std::size_t n = m.time.size();
  const GroundForce force = ground_force(o, r.mass, r.gravity, device);
  const double end = m.stop.value_or(m.time.back());
  for (const int area : {0, 1}) {
    r.q_dyn[area].assign(n, none);
    for (std::size_t i = 0; i < n && m.time[i] <= end; ++i) {
      const double a = area == 0 ? device.mantle_area(m.depth[i]) : device.projected_area(m.depth[i]);
      if (m.depth[i] >= o.from_depth && a > 0)
        r.q_dyn[area][i] = force(m.filtered[i], m.velocity[i]) / a / 1e3;
    }
    r.q_dyn_peaks[area] = peak_of(r.q_dyn[area], m, r.peak);
  }
  for (const RateBand& band : rate_bands(m.impact_velocity, o.medium, o.soil))
    for (const double k : {band.low, band.high}) {
      if (!r.quasi_static.empty() && r.quasi_static.back().k == k &&
          r.quasi_static.back().band.name == band.name)
        continue;
      QuasiStatic q;
      q.band = band;
      q.k = k;
      for (const int area : {0, 1})
        for (const int form : {0, 1}) {
          Column& column = q.columns[area][form];
          column.assign(n, none);
          for (std::size_t i = 0; i < n; ++i)
            if (!std::isnan(r.q_dyn[area][i]))
              column[i] = (form == 0 ? reduced_by_log : reduced_by_asinh)(r.q_dyn[area][i], k, m.velocity[i])
                              .value_or(none);
          q.peaks[area][form] = peak_of(column, m, r.peak);
        }
      r.quasi_static.push_back(std::move(q));
    }
}

void add_estimates(Reduction& r, const ReduceOptions& o) {
  const Motion& m = r.motion;
  r.estimates.push_back(firmness_factor(r.peak_g(), m.stop, m.impact_velocity));
  if (o.soil == Soil::clay) return;  // the rest is of sand
  std::vector<Estimate> densities{density_of_peak(r.peak_g())};
  if (o.medium == Medium::air && densities[0].outside.empty()) densities[0].outside = "a drop through air";
  if (r.unit_weight) {
    const double here = *r.unit_weight * m.depth[r.peak] / 1e3;  // kPa
    for (const QuasiStatic& q : r.quasi_static)
      if (q.band.within && q.peaks[1][0].at_peak)
        densities.push_back(density_of_resistance(*q.peaks[1][0].at_peak, here, r.k0,
                                                  "q_sbc at the peak, K = " + rounded(q.k)));
  }
  r.estimates.insert(r.estimates.end(), densities.begin(), densities.end());
  if (r.unit_weight)
    for (const Estimate& density : densities)
      for (const auto& [c, d] : {std::pair{3.0, 2.0}, std::pair{2.0, 5.0}})
        r.estimates.push_back(friction_angle(density, *r.unit_weight * r.greatest_depth / 1e3, c, d));
  else
    r.notes.push_back("without --unit-weight: no relative density of q_sbc and no friction angle");
}

/// Row of the largest filtered deceleration, until it stands.
std::size_t peak_place(const Motion& m, bool of_drop) {
  const auto n = of_drop || !m.stop ? m.time.end() : std::upper_bound(m.time.begin(), m.time.end(), *m.stop);
  return static_cast<std::size_t>(
      std::max_element(m.filtered.begin(), m.filtered.begin() + (n - m.time.begin())) - m.filtered.begin());
}

/// Depth at which it stands, m: after the rest a record adds only errors of its integral.
double depth_of(const Motion& m, bool of_drop) {
  const auto n = of_drop || !m.stop ? m.time.end() : std::upper_bound(m.time.begin(), m.time.end(), *m.stop);
  return *std::max_element(m.depth.begin(), m.depth.begin() + (n - m.time.begin()));
}

/// Drops, contacts and knocks of a record, in time.
std::vector<RecordEvent> events_of(const Measurement& record, const ImpactSettings& s,
                                   const std::vector<Glitch>& glitches) {
  const RecordSearch search{record, s};
  const auto falls = search.falls();
  const auto drops = search.drops(falls);
  std::vector<RecordEvent> events;
  int count = 0;
  for (std::size_t k = 0; k < falls.size(); ++k) {
    const bool is_drop = std::ranges::find(drops, k) != drops.end();
    if (is_drop) ++count;
    for (std::size_t i = 0; i < falls[k].contacts.size(); ++i) {
      const Contact& c = falls[k].contacts[i];
      const bool is_impact = i == falls[k].impact;
      RecordEvent event{.kind = !is_drop    ? "knock"
                                : is_impact ? "drop"
                                            : "contact",
                        .drop = is_drop ? count : 0,
                        .time = c.time,
                        .velocity = !is_drop    ? std::nullopt
                                    : is_impact ? falls[k].velocity
                                                : c.velocity,
                        .depth = is_drop && is_impact ? std::optional{c.depth} : std::nullopt,
                        .peak = c.peak};
      if (is_drop && is_impact) {
        ImpactSettings of_drop = s;
        of_drop.drop_at = c.time;
        try {
          const Motion m = motion_of(record, of_drop);
          event.velocity = m.impact_velocity;
          event.depth = depth_of(m, false);
          event.peak = m.filtered[peak_place(m, false)];
        } catch (const error&) {  // what is known of it stands
        }
      }
      events.push_back(std::move(event));
    }
  }
  if (count > 0)
    for (const auto& [time, peak] : search.knocks(falls))
      events.push_back({.kind = "knock", .time = time, .velocity = {}, .depth = {}, .peak = peak});
  for (const Glitch& glitch : glitches)
    events.push_back({.kind = "glitch",
                      .time = record.time[glitch.sample],
                      .velocity = {},
                      .depth = {},
                      .peak = record.deceleration[glitch.sample]});
  std::ranges::stable_sort(events, {}, &RecordEvent::time);
  return events;
}

template <class Which>
std::string text_of(const std::vector<RecordEvent>& events, double gravity, const Which& which) {
  constexpr int most = 12;
  std::string text;
  int count = 0;
  for (const RecordEvent& event : events)
    if (which(event) && ++count <= most) text += (text.empty() ? "" : "; ") + text_of(event, gravity);
  return count > most ? joined_text({text, "; and ", count - most, " more in reduced.json"}) : text;
}

/// The levels around the drop that is meant, or around the largest shock if no drop is found as the options
/// read the record; `clean`: the record without glitches.
void find_levels(Reduction& r, std::optional<ReadingProblem>& problem, const Measurement& clean,
                 const ReduceOptions& o, const ImpactSettings& impact) {
  constexpr double before = 0.05, after = 0.5, beside = 2e-3;  // s
  std::optional<PeakWindow> window;
  if (o.impact_time) {
    window = PeakWindow{*o.impact_time - before, *o.impact_time + after};
  } else {
    const RecordSearch search{clean, impact};
    const auto falls = search.falls();
    if (const auto drops = search.drops(falls); !drops.empty()) {
      const auto& fall =
          falls[drops[std::min<std::size_t>(static_cast<std::size_t>(o.drop.value_or(1)), drops.size()) - 1]];
      const double at = fall.at_impact().peak_time;
      window = PeakWindow{at - beside, at + beside};
    }
  }
  const auto take = [&](const std::optional<PeakWindow>& peak) {
    r.levels = levels_of(clean, r.gravity, impact.in_water, peak);
    problem = reading_problem(clean, r.levels, o, r.gravity, peak);
  };
  take(window);
  if (!window || !problem || problem->has_cure) return;
  const auto found =
      std::pair{r.levels, problem};  // no drop that the record shows: another reading may have one
  take({});
  if (!problem || !problem->has_cure) std::tie(r.levels, problem) = found;
}

/// Lists the events, and settles which drop is meant. Throws `error` if several may be.
template <class Refuse>
void choose_drop(Reduction& r, const ReduceOptions& o, ImpactSettings& impact, const Measurement& record,
                 const std::vector<Glitch>& glitches, const Refuse& refuse_for_problem) {
  ImpactSettings any = impact;
  any.impact_time.reset();
  any.impact_velocity.reset();
  Measurement zeroed = record;
  for (double& a : zeroed.deceleration) a -= impact.offset;
  any.offset = 0;
  r.events = events_of(zeroed, any, glitches);
  const auto is_drop = [](const RecordEvent& event) { return event.kind == "drop"; };
  const auto drops = std::ranges::count_if(r.events, is_drop);
  if (o.drop || (drops > 1 && !o.impact_time)) {
    refuse_for_problem();
    std::string list;
    for (const RecordEvent& event : r.events)
      if (is_drop(event)) list += "\n  " + text_of(event, r.gravity);
    const std::string held = joined_text({"holds ", drops, drops == 1 ? " drop" : " drops"});
    if (!o.drop)
      throw SeveralDrops(
          joined_text({shown(o.file), ": ", held, "; give --drop N, or --impact-time:", list}));
    if (*o.drop > drops)
      throw SeveralDrops(
          joined_text({"--drop = ", *o.drop, ": the record ", held, drops > 0 ? ":" : "", list}));
  }
  if (!o.impact_time) r.drop = drops > 0 ? o.drop.value_or(1) : 0;
  for (const RecordEvent& event : r.events)
    if (is_drop(event) && event.drop == r.drop) impact.drop_at = event.time;
  const auto other = [&](const RecordEvent& event) { return !is_drop(event) || event.drop != r.drop; };
  if (const std::string list = text_of(r.events, r.gravity, other); drops > 0 && !list.empty())
    r.notes.push_back(joined_text({"the record holds more than ",
                                   r.drop > 0 ? joined_text({"drop ", r.drop, ", which is reduced: "})
                                              : std::string{"the impact that was given: "},
                                   list}));
}

/// Difference between the last and the first third of a free fall, g; none if it is too short for that.
std::optional<double> drift_of_fall(const Measurement& record, const Motion& m, double gravity) {
  constexpr double margin = 0.02, shortest = 0.1;  // s
  if (!m.release || !m.impact_uncertain) return std::nullopt;
  const double beside = std::max(margin, 2 * *m.impact_uncertain);
  const double from = *m.release + beside, to = m.impact_time - beside, third = (to - from) / 3;
  if (third < shortest / 3) return std::nullopt;
  const StepIntegral integral{record.time, interval_means(record)};
  return (integral(to) - integral(to - third) - integral(from + third) + integral(from)) / third / gravity;
}

/// Warns where a measured record and the options disagree, and of what its samples cannot show. Throws
/// `error` of a motion that no drop can have.
void add_warnings(Reduction& r, const ReduceOptions& o, const Measurement& record, ImpactSettings impact,
                  const std::optional<ReadingProblem>& problem, const std::vector<Glitch>& glitches) {
  const Levels& levels = r.levels;
  const Motion& m = r.motion;
  const auto g = [](double x) { return rounded(std::round(x * 1e4) / 1e4 + 0.0); };
  const bool fits = !problem;
  if (problem)
    r.warnings.push_back(problem->text + (problem->has_cure ? ". Nothing below is that of the drop" : ""));
  impact.drop_at = m.impact_time;

  std::vector<std::string> impossible;
  const bool water = o.medium == Medium::water;
  const double most = (water ? 3 : 1) * impact.length;  // soft mud below water may swallow it
  if (r.greatest_depth > most)
    impossible.push_back(
        joined_text({"it goes ", rounded(r.greatest_depth), " m deep, the penetrometer is ", impact.length,
                     " m long", water ? "" : " (a drop through water needs --medium water)"}));
  const auto left_text = [&] {
    return joined_text({"the integral leaves ", rounded(*m.velocity_left), " m/s at rest, of ",
                        rounded(m.impact_velocity), " m/s at the impact"});
  };
  const bool much_left =
      m.velocity_left && std::abs(*m.velocity_left) > unbelievable_left * m.impact_velocity;
  if (much_left) impossible.push_back(left_text());
  const auto drift = water ? std::nullopt : drift_of_fall(without(glitches, record), m, r.gravity);
  constexpr double told_drift = 0.05, impossible_drift = 0.1;  // g
  const auto drift_text = [&] {
    return joined_text({"the fall drifts by ", g(*drift),
                        " g between its first and its last third, and a free "
                        "fall reads -1 g all along; does the accelerometer hold a level (an AC-coupled one "
                        "does not)?"});
  };
  if (fits && drift && std::abs(*drift) > impossible_drift)
    impossible.push_back(drift_text());
  else if (fits && drift && std::abs(*drift) > told_drift)
    r.warnings.push_back(drift_text());

  double left = m.velocity_left.value_or(0);
  const auto offset = levels.offset();
  if (fits && offset && impact.offset == 0) {
    try {
      impact.offset = *offset * r.gravity;
      const Motion without_offset = motion_of(record, impact);
      r.depth_without_offset = depth_of(without_offset, false);
      left = without_offset.velocity_left.value_or(left);
    } catch (const error&) {  // no impact, and no depth
    }
    if (r.depth_without_offset && std::abs(*r.depth_without_offset / r.greatest_depth - 1) > 0.02)
      r.warnings.push_back(joined_text({"the accelerometer is off by ", g(*offset), " g at rest ",
                                        levels.before ? "before the release" : "after the end",
                                        ": with that taken off (--zero-at-rest) the depth is ",
                                        rounded(*r.depth_without_offset * 100), " cm, not ",
                                        rounded(r.greatest_depth * 100), " cm"}));
  }
  if (fits && levels.before && levels.after && std::abs(*levels.before - *levels.after) > 0.05)
    r.warnings.push_back(
        joined_text({"the rests differ: ", g(*levels.before), " g before the release, ", g(*levels.after),
                     " g after the end; does the penetrometer lean, or did the accelerometer "
                     "shift? --zero-at-rest takes the former"}));
  if (fits && offset && levels.fall && !water && std::abs(*offset - *levels.fall - 1) > 0.03)
    r.warnings.push_back(joined_text(
        {"between rest and fall the record changes by ", g(*offset - *levels.fall),
         " g, in free fall by 1 g; are scale and --gravity those of the record, and is the fall free?"}));

  // Single samples that stand out, where they reach into the integral.
  const double from = m.release.value_or(m.impact_time),
               to = m.impact_time + m.stop.value_or(m.time.back()) + 0.3;  // the rest is checked there
  std::string places;
  for (const Glitch& glitch : glitches)
    if (const double t = record.time[glitch.sample]; t >= from && t <= to)
      places +=
          joined_text({places.empty() ? "" : ", ", rounded(record.deceleration[glitch.sample] / r.gravity),
                       " g at ", text_of_time(t), " s"});
  if (!places.empty()) {
    std::string text = "single samples stand out, as by a glitch: " + places;
    try {
      impact.offset = r.taken_off;
      const Motion clean = motion_of(without(glitches, record), impact);
      text += joined_text({"; without them the impact has ", rounded(clean.impact_velocity),
                           " m/s, the depth is ", rounded(depth_of(clean, false) * 100), " cm and the peak ",
                           rounded(clean.filtered[peak_place(clean, false)] / r.gravity), " g"});
    } catch (const error&) {  // nothing to compare with
    }
    r.warnings.push_back(text);
  }
  if (!much_left && std::abs(left) > 0.05 * m.impact_velocity && m.velocity_left &&
      std::abs(*m.velocity_left) > 0.05 * m.impact_velocity)
    r.warnings.push_back(left_text() + ": velocity and depth are as uncertain");
  if (m.impact_velocity < 0.1)
    r.warnings.push_back(joined_text({"the velocity at the impact is ", rounded(m.impact_velocity),
                                      " m/s; is the unit of the time that of the record (--time-unit)?"}));
  if (m.impact_uncertain) {
    const double off = *m.impact_uncertain;
    r.depth_of_sampling = off * m.impact_velocity;
    if (m.velocity_from != "given")
      r.velocity_of_sampling = off * std::hypot(m.deceleration[0], m.release ? r.gravity : 0);
    if (*r.depth_of_sampling > 0.05 * r.greatest_depth)
      r.warnings.push_back(
          joined_text({"the impact lies anywhere between two samples, up to ", rounded(1e3 * off),
                       " ms off: that is ", rounded(*r.depth_of_sampling * 100), " cm of depth",
                       r.velocity_of_sampling ? " and " + rounded(*r.velocity_of_sampling) + " m/s" : ""}));
  }
  const double fall = m.impact_velocity / r.gravity;
  for (auto& text : sampling_warnings(record, m.impact_time - fall, m.impact_time,
                                      m.impact_time + m.stop.value_or(m.time.back()), r.gravity))
    r.warnings.push_back(std::move(text));
  if (impossible.empty()) return;
  std::string all;
  for (const auto& text : impossible) all += (all.empty() ? "" : "; ") + text;
  all = joined_text({"no drop moves so: with the impact at ", text_of_time(m.impact_time), " s and ",
                     rounded(m.impact_velocity), " m/s ", all});
  if (!o.force && fits) {
    for (const auto& text : r.warnings) all += "; " + text;
    throw error(
        joined_text({shown(o.file), ": ", all,
                     "; --force reduces it all the same, --impact-time and --impact-velocity say what "
                     "the record does not show"}));
  }
  r.warnings.insert(r.warnings.begin() + (problem ? 1 : 0), all);
}

}  // namespace

std::string text_of(const RecordEvent& event, double gravity) {
  std::string what;
  const auto add = [&](const std::string& text) { what += (what.empty() ? "" : ", ") + text; };
  if (event.velocity) add(rounded(*event.velocity) + " m/s");
  if (event.depth) add(rounded(*event.depth) + " m");
  add(rounded(event.peak / gravity) + " g");
  const std::string number =
      event.drop > 0 ? joined_text({event.kind == "drop" ? " " : " of drop ", event.drop}) : "";
  return joined_text({event.kind, number, " at ", text_of_time(event.time), " s (", what, ")"});
}

Reduction reduce(Measurement record, const ReduceOptions& o) {
  Reduction r;
  const auto drop = record.drop;
  r.notes = std::move(record.notes);
  r.of_drop = drop.has_value();
  r.device = drop ? drop->device : static_cast<const DeviceOptions&>(o);
  if (!drop) check_mass(o);
  r.mass = o.mass ? *o.mass : drop ? drop->mass : o.device_mass();
  r.gravity = o.gravity.value_or(drop ? drop->gravity : standard_gravity);
  r.k0 = o.k0.value_or(drop ? drop->k0 : 0.5);
  r.unit_weight = o.unit_weight ? o.unit_weight : drop ? std::optional{drop->unit_weight} : std::nullopt;
  r.threshold = o.impact_threshold();
  ImpactSettings impact{.gravity = r.gravity,
                        .threshold = r.threshold,
                        .window = o.window,
                        .in_water = o.medium == Medium::water,
                        .impact_time = o.impact_time,
                        .impact_velocity = o.impact_velocity};
  const Device device = drop ? drop->body() : Device{o.shape()};
  if (drop && !impact.impact_time) {
    impact.impact_time = 0;
    impact.impact_depth = 0 - device.tip_above();
    if (!impact.impact_velocity) impact.impact_velocity = drop->impact_velocity;
  }
  impact.length = device.length();
  std::optional<ReadingProblem> problem;
  const auto glitches = drop ? std::vector<Glitch>{} : glitches_of(record, r.gravity);
  if (drop && o.drop) throw error("--drop: goes without the folder of a drop, which holds one");
  if (!drop) find_levels(r, problem, without(glitches, record), o, impact);
  const auto refuse_for_problem = [&] {
    if (problem) throw error(joined_text({shown(o.file), ": ", problem->text}));
  };
  if (problem && problem->has_cure && !o.impact_time) refuse_for_problem();
  if (o.zero_at_rest) {
    refuse_for_problem();
    const auto offset = r.levels.offset();
    if (!offset)
      throw error(
          "--zero-at-rest: the record shows no quiet rest before the release or after the end; leave it out");
    impact.offset = r.taken_off = *offset * r.gravity;
  }
  if (!drop) choose_drop(r, o, impact, record, glitches, refuse_for_problem);
  try {
    r.motion = motion_of(record, impact);
  } catch (const error&) {
    refuse_for_problem();
    throw;
  }
  const Motion& m = r.motion;
  r.peak = peak_place(m, r.of_drop);
  r.greatest_depth = depth_of(m, r.of_drop);
  if (!drop) add_warnings(r, o, record, impact, problem, glitches);
  if (o.medium == Medium::water && !o.drag)
    r.notes.push_back("without --drag: the drag of the water is left out");
  add_bearing(r, o, device);
  add_estimates(r, o);
  return r;
}

}  // namespace arenite::ffp
