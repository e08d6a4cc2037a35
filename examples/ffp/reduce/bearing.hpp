// Bearing resistance of the ground as practitioners read it off a drop: dynamic, and reduced to the rate of a
// cone penetration test.
#pragma once

#include <array>
#include <cmath>
#include <optional>
#include <string>
#include <vector>

#include <arenite/core/units.hpp>

#include "../geometry/geometry.hpp"
#include "../options/reduce_options.hpp"

namespace arenite::ffp {

/// The rate to which a resistance is reduced: that of a cone penetration test.
inline constexpr double reference_velocity = 0.02;  // m/s

/// Resistance reduced from the velocity v by K a decade: q / (1 + K log10(v / v_0)). None below v_0, where
/// the logarithm would raise it.
inline std::optional<double> reduced_by_log(double q, double k, double v) {
  if (!(v >= reference_velocity)) return std::nullopt;
  return q / (1 + k * std::log10(v / reference_velocity));
}

/// The same with (K / ln 10) asinh(v / v_0), which goes to q at rest.
inline std::optional<double> reduced_by_asinh(double q, double k, double v) {
  if (!(v >= 0)) return std::nullopt;
  return q / (1 + k / std::log(10.0) * std::asinh(v / reference_velocity));
}

/// A band of the rate factor K, where it comes from and what it is for.
struct RateBand {
  std::string name;
  double low, high;
  std::string source, range;
  bool within;  ///< this drop is one of those that it is for
};

/// All bands for an impact velocity, m/s.
inline std::vector<RateBand> rate_bands(double impact_velocity, Medium medium, Soil soil) {
  const bool sand_in_water = medium == Medium::water && soil == Soil::sand;
  const double air = 0.31 * impact_velocity;
  return {{"0.2 to 0.4", 0.2, 0.4, "usual practice for penetrometers dropped through water", "sand, in water",
           sand_in_water},
          {"1 to 1.5", 1, 1.5, "usual practice for penetrometers dropped through water", "sand, in water",
           sand_in_water},
          {"air", air, air, "Brilli 2023: 0.31 times the impact velocity in m/s", "dry sand, in air",
           medium == Medium::air && soil == Soil::sand},
          {"0.1 to 0.3", 0.1, 0.3, "usual practice for clay", "clay", soil == Soil::clay}};
}

/// Force of the ground on the penetrometer, N: m (a + g) less what the water takes.
struct GroundForce {
  double mass = 0, gravity = 0;           ///< kg, m/s^2
  double buoyancy = 0;                    ///< N
  double drag_over_velocity_squared = 0;  ///< N s^2/m^2

  double operator()(double deceleration, double velocity) const {
    return mass * (deceleration + gravity) - buoyancy -
           drag_over_velocity_squared * velocity * std::abs(velocity);
  }
};

inline GroundForce ground_force(const ReduceOptions& o, double mass, double gravity, const Device& device) {
  GroundForce force{.mass = mass, .gravity = gravity};
  if (o.medium == Medium::water) {
    force.buoyancy = o.water_density * gravity * o.volume;
    force.drag_over_velocity_squared =
        o.drag.value_or(0) * o.water_density / 2 * device.projected_area(device.length());
  }
  return force;
}

}  // namespace arenite::ffp
