// From deceleration to motion: where the penetrometer hits the ground, how fast, and how deep it goes.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "contacts.hpp"

namespace arenite::ffp {

/// The motion from the impact, t = 0, on.
struct Motion {
  double impact_time = 0;  ///< s, in the record
  std::string impact_from, velocity_from;
  std::optional<double> release{};           ///< s, in the record
  std::optional<double> impact_uncertain{};  ///< s: what an impact that was found may lie off
  double impact_velocity = 0;                ///< m/s
  std::vector<double> time;                  ///< [n] s, after the impact
  std::vector<double> deceleration;          ///< [n] m/s^2, as recorded
  std::vector<double> filtered;              ///< [n] m/s^2
  std::vector<double> velocity, depth;       ///< [n] m/s, m, down; of the tip
  std::optional<double> stop;                ///< s after the impact: first rest; none: not within the record
  std::optional<double>
      velocity_left;  ///< m/s that the integral leaves at rest; none: no rest within the record
};

/// Share of the impact's velocity that the integral cannot leave at rest.
inline constexpr double unbelievable_left = 0.5;

/// Finds impact and velocity, of the drop that the settings name or the first, and integrates by the trapezoid
/// rule to 0.1 s after the first rest, or to the record's end. Throws `error` that names the option to give if impact or velocity cannot be found.
Motion motion_of(Measurement record, const ImpactSettings& s);

}  // namespace arenite::ffp
