#include "push_options.hpp"

#include <algorithm>
#include <tuple>

#include <arenite/core/error.hpp>

#include "gravity.hpp"

namespace arenite::ffp {

double PushOptions::density() const { return weight() / standard_gravity; }

Device PushOptions::body() const { return Device{shape()}; }

Chamber PushOptions::chamber() const {
  const double d = outer_diameter();
  Chamber c;
  c.radius = chamber_radius.value_or(15 * d);
  c.soil_depth = soil_depth.value_or(way() + 9 * d);
  c.embedded = start_depth();
  c.headroom = whole_length() + d;
  return c;
}

MeshSizes PushOptions::mesh_sizes() const {
  const double d = outer_diameter();
  MeshSizes sizes;
  sizes.cell = cell_size();
  sizes.moving_depth = sizes.fine_radius = 1.5 * d;
  sizes.outer_ratio = 4;
  return sizes;
}

void check(const PushOptions& o) {
  detail::RangeCheck ranges;
  visit_push_options(o, ranges);
  check(static_cast<const DeviceOptions&>(o));
  const double d = o.outer_diameter();
  require(std::ranges::find(triangle_points, o.points_per_element) != triangle_points.end(),
          "--points-per-element", o.points_per_element, "must be " + listed(triangle_points));
  require(o.dilatancy <= o.friction, "--dilatancy", o.dilatancy,
          {"must not exceed --friction = ", o.friction, " deg"});
  const PushOptions usual;
  for (const auto& [name, given, of_itself, of_clay] :
       {std::tuple{"--strength", o.strength, usual.strength, true},
        {"--rigidity-index", o.rigidity_index, usual.rigidity_index, true},
        {"--roughness", o.roughness, usual.roughness, true},
        {"--friction", o.friction, usual.friction, false},
        {"--dilatancy", o.dilatancy, usual.dilatancy, false},
        {"--cohesion", o.cohesion, usual.cohesion, false},
        {"--young", o.young, usual.young, false},
        {"--delta", o.delta, usual.delta, false}})
    require(given == of_itself || of_clay == o.in_clay(), name, given,
            {"needs --ground ", of_clay ? "clay" : "sand"});
  require(
      !o.in_clay() || o.overburden == 0, "--overburden", o.overburden,
      "needs --ground sand; in clay it adds to the resistance as it is, and the net resistance is the same");
  const Device body = o.body();
  const double rod = o.whole_length() - body.tip_end();
  require(rod > 0, "--penetrometer", o.device_name(), "must have a rod, by which it is pushed");
  require(body.profile(body.tip_end()) > 0.999 * body.radius(), "--penetrometer", o.device_name(),
          "must not be wider than its rod: the flow behind what is wider is not computed right");
  require(o.start_depth() < o.whole_length(), "--start-depth", o.start_depth(),
          {"must be less than the length of the penetrometer, ", o.whole_length(), " m (--length)"});
  require(o.start_depth() >= body.tip_end() + d / 2, "--start-depth", o.start_depth(),
          {"must be at least the height of the tip and half a diameter, ", body.tip_end() + d / 2, " m"});
  require(o.way() >= d, "--distance", o.way(),
          {"must be at least a diameter, ", d, " m, for a resistance to be read"});
  require(o.cell_size() >= 0.03 * d && o.cell_size() <= 0.3 * d, "--cell", o.cell_size(),
          {"must lie in [", 0.03 * d, ", ", 0.3 * d, "] m, 0.03 to 0.3 diameters"});
  const Chamber c = o.chamber();
  require(c.radius >= 5 * d, "--chamber-radius", c.radius, {"must be at least 5 diameters, ", 5 * d, " m"});
  require(c.soil_depth >= o.way() + 4 * d, "--soil-depth", c.soil_depth,
          {"must be at least --distance and 4 diameters, ", o.way() + 4 * d, " m"});
  require(!o.error_bar || o.cell_size() <= 0.1501 * d, "--cell", o.cell_size(),
          {"must be at most ", 0.15 * d, " m with --error-bar, which runs cells of twice the size, too"});
  require(o.push_speed() <= 0.1 * o.shear_wave_speed(), "--speed", o.push_speed(),
          {"must be at most a tenth of the speed of shear waves, ", rounded(0.1 * o.shear_wave_speed()),
           " m/s: inertia would bear the penetrometer"});
  require(o.fields_every == 0 || o.way() / o.fields_every <= most_fields, "--fields-every", o.fields_every,
          {"must give at most ", most_fields, " sets of files"});
}

}  // namespace arenite::ffp
