#include "reduction.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
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

/// Depth at which it stands, m: beyond the rest a record leaves errors of its integral alone.
double depth_of(const Motion& m, bool of_drop) {
  const auto n = of_drop || !m.stop ? m.time.end() : std::upper_bound(m.time.begin(), m.time.end(), *m.stop);
  return *std::max_element(m.depth.begin(), m.depth.begin() + (n - m.time.begin()));
}

/// What a measured record and the options do not agree in, and what its samples cannot show.
void add_warnings(Reduction& r, const ReduceOptions& o, const Measurement& record, ImpactSettings impact,
                  const std::optional<ReadingProblem>& problem) {
  const Levels& levels = r.levels;
  const auto g = [](double x) { return rounded(std::round(x * 1e4) / 1e4 + 0.0); };
  const bool fits = !problem;
  if (problem)
    r.warnings.push_back(problem->text + (problem->has_cure ? ". Nothing below is that of the drop" : ""));
  const auto offset = levels.offset();
  if (fits && offset && impact.offset == 0) {
    try {
      impact.offset = *offset * r.gravity;
      r.depth_without_offset = depth_of(motion_of(record, impact), false);
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
  if (fits && offset && levels.fall && o.medium == Medium::air && std::abs(*offset - *levels.fall - 1) > 0.03)
    r.warnings.push_back(joined_text(
        {"between rest and fall the record changes by ", g(*offset - *levels.fall),
         " g, in free fall by 1 g; are scale and --gravity those of the record, and is the fall free?"}));
  const Motion& m = r.motion;
  if (r.warnings.empty() && m.velocity_left && std::abs(*m.velocity_left) > 0.05 * m.impact_velocity)
    r.warnings.push_back(
        joined_text({"the integral leaves ", rounded(*m.velocity_left), " m/s at rest, of ",
                     rounded(m.impact_velocity), " m/s at the impact: velocity and depth are as uncertain"}));
  if (m.impact_velocity < 0.1)
    r.warnings.push_back(joined_text({"the velocity at the impact is ", rounded(m.impact_velocity),
                                      " m/s; is the unit of the time that of the record (--time-unit)?"}));
  const double fall = m.impact_velocity / r.gravity;
  for (auto& text : sampling_warnings(record, m.impact_time - fall, m.impact_time,
                                      m.impact_time + m.stop.value_or(m.time.back()), r.gravity))
    r.warnings.push_back(std::move(text));
}

}  // namespace

Reduction reduce(Measurement record, const ReduceOptions& o) {
  Reduction r;
  const auto drop = record.drop;
  r.notes = std::move(record.notes);
  r.of_drop = drop.has_value();
  r.tip = drop ? drop->tip : o.tip;
  r.mass = o.mass.value_or(drop ? drop->mass : usual_mass(o.tip));
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
  const Device device = drop ? drop->body() : Device{shape_of(o.tip)};
  if (drop && !impact.impact_time) {
    impact.impact_time = 0;
    impact.impact_depth = 0 - device.tip_above();
    if (!impact.impact_velocity) impact.impact_velocity = drop->impact_velocity;
  }
  std::optional<ReadingProblem> problem;
  if (!drop) {
    r.levels = levels_of(record, r.gravity, impact.in_water);
    problem = reading_problem(record, r.levels, o, r.gravity);
  }
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
  try {
    r.motion = motion_of(record, impact);
  } catch (const error&) {
    refuse_for_problem();
    throw;
  }
  const Motion& m = r.motion;
  r.peak =
      static_cast<std::size_t>(std::max_element(m.filtered.begin(), m.filtered.end()) - m.filtered.begin());
  r.greatest_depth = depth_of(m, r.of_drop);
  if (!drop) add_warnings(r, o, record, impact, problem);
  if (o.medium == Medium::water && !o.drag)
    r.notes.push_back("without --drag: the drag of the water is left out");
  add_bearing(r, o, device);
  add_estimates(r, o);
  return r;
}

}  // namespace arenite::ffp
