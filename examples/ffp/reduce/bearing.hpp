// Bearing resistance of the ground as practitioners read it off a drop: dynamic, and reduced to the rate of a
// cone penetration test.
#pragma once

#include <cmath>
#include <optional>
#include <string>
#include <vector>

#include "../geometry/geometry.hpp"
#include "../options/reduce_options.hpp"

namespace arenite::ffp {

/// The rate to which a resistance is reduced: that of a cone penetration test.
inline constexpr double reference_velocity = 0.02;  // m/s

/// Resistance reduced from the velocity v by K a decade: q / (1 + K log10(v / v_0)). None below v_0, where
/// the logarithm would raise it.
std::optional<double> reduced_by_log(double q, double k, double v);

/// The same with (K / ln 10) asinh(v / v_0), which goes to q at rest.
std::optional<double> reduced_by_asinh(double q, double k, double v);

/// A band of the rate factor K, where it comes from and what it is for.
struct RateBand {
  std::string name;
  double low, high;
  std::string source, range;
  bool within;  ///< this drop is one of those that it is for
};

/// All bands for an impact velocity, m/s.
std::vector<RateBand> rate_bands(double impact_velocity, Medium medium, Soil soil);

/// Force of the ground on the penetrometer, N: m (a + g) minus the forces of the water.
struct GroundForce {
  double mass = 0, gravity = 0;           ///< kg, m/s^2
  double buoyancy = 0;                    ///< N
  double drag_over_velocity_squared = 0;  ///< N s^2/m^2

  double operator()(double deceleration, double velocity) const {
    return mass * (deceleration + gravity) - buoyancy -
           drag_over_velocity_squared * velocity * std::abs(velocity);
  }
};

GroundForce ground_force(const ReduceOptions& o, double mass, double gravity, const Device& device);

}  // namespace arenite::ffp
