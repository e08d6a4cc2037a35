// Properties of soil by correlation: firmness, density and strength, each with its source and its range.
#pragma once

#include <optional>
#include <string>

namespace arenite::ffp {

/// A number by a correlation. Without value it cannot be given; `outside` then says why, else what is outside
/// of the correlation's range.
struct Estimate {
  std::string quantity;
  std::optional<double> value;
  std::string unit, source, range;
  std::string outside{};  ///< empty: within its range
};

/// Firmness factor, 1/m: peak over (g times penetration time times impact velocity).
/// peak: g; time: s, none if the penetrometer did not come to rest; velocity: m/s.
Estimate firmness_factor(double peak, std::optional<double> time, double velocity);

/// Relative density, 0 to 1, from the peak, g.
Estimate density_of_peak(double peak);

/// Relative density, 0 to 1, from a quasi-static resistance, kPa, at a vertical effective stress, kPa.
Estimate density_of_resistance(double q, double vertical_stress, double k0, const std::string& of);

/// Friction angle, deg, from a relative density at a vertical effective stress, kPa: 34 + 10 D - (c + d D)
/// log10(stress / p_atm).
Estimate friction_angle(const Estimate& density, double vertical_stress, double c, double d);

}  // namespace arenite::ffp
