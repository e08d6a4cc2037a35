#include "bearing.hpp"

#include <array>

#include <arenite/core/units.hpp>

namespace arenite::ffp {

std::optional<double> reduced_by_log(double q, double k, double v) {
  if (!(v >= reference_velocity)) return std::nullopt;
  return q / (1 + k * std::log10(v / reference_velocity));
}

std::optional<double> reduced_by_asinh(double q, double k, double v) {
  if (!(v >= 0)) return std::nullopt;
  return q / (1 + k / std::log(10.0) * std::asinh(v / reference_velocity));
}

std::vector<RateBand> rate_bands(double impact_velocity, Medium medium, Soil soil) {
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

GroundForce ground_force(const ReduceOptions& o, double mass, double gravity, const Device& device) {
  GroundForce force{.mass = mass, .gravity = gravity};
  if (o.medium == Medium::water) {
    force.buoyancy = o.water_density * gravity * o.lifted_volume(device);
    force.drag_over_velocity_squared =
        o.drag.value_or(0) * o.water_density / 2 * device.projected_area(device.length());
  }
  return force;
}

}  // namespace arenite::ffp
