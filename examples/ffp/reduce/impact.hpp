// From deceleration to motion: where the penetrometer hits the ground, how fast, and how deep it goes.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "../drop/peaks.hpp"
#include "measurement.hpp"

namespace arenite::ffp {

/// What finding the impact needs to know.
struct ImpactSettings {
  double gravity = 9.81;                    ///< m/s^2
  double threshold = -0.8;                  ///< g
  double window = 2e-3;                     ///< s, of the moving mean; 0: none
  bool in_water = false;                    ///< the fall need not be free
  std::optional<double> impact_time{};      ///< s, in the record
  std::optional<double> impact_velocity{};  ///< m/s
  double impact_depth = 0;                  ///< m, at the impact
  double offset = 0;                        ///< m/s^2, taken off the record
};

/// The motion from the impact, t = 0, on.
struct Motion {
  double impact_time = 0;  ///< s, in the record
  std::string impact_from, velocity_from;
  double impact_velocity = 0;           ///< m/s
  std::vector<double> time;             ///< [n] s, after the impact
  std::vector<double> deceleration;     ///< [n] m/s^2, as recorded
  std::vector<double> filtered;         ///< [n] m/s^2
  std::vector<double> velocity, depth;  ///< [n] m/s, m, down; of the tip
  std::optional<double> stop;           ///< s after the impact: first rest; none: not within the record
  std::optional<double>
      velocity_left;  ///< m/s that the integral leaves at rest; none: no rest within the record
};

/// Finds impact and velocity, and integrates by the trapezoid rule to 0.1 s after the first rest, or to the
/// record's end. Throws `error` that names the option to give if impact or velocity cannot be found.
Motion motion_of(Measurement record, const ImpactSettings& s);

}  // namespace arenite::ffp
