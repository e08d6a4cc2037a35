#include "device_options.hpp"

#include <arenite/core/error.hpp>
#include <arenite/core/units.hpp>

namespace arenite::ffp {

namespace {

/// A mean density that a penetrometer can have, kg/m^3.
constexpr double least_density = 500, most_density = 20000;

}  // namespace

DeviceShape DeviceOptions::shape() const {
  DeviceShape shape = shape_of(tip);
  shape.radius = outer_diameter() / 2;
  shape.length = whole_length();
  shape.flat = tip == Tip::blunt ? shape.radius : flat ? *flat / 2 : shape.flat * size();
  shape.parabola *= size();
  if (cone_angle) shape.apex = *cone_angle * pi / 180;
  shape.fillet = fillet_radius();
  return shape;
}

std::string DeviceOptions::device_name() const {
  for (const auto& [word, which] : penetrometer_words)
    if (which == penetrometer)
      return std::string{word} + (diameter || length || cone_angle || flat ? ", changed" : "");
  throw error("DeviceOptions.penetrometer: a value without a word");
}

double DeviceOptions::device_mass() const {
  if (!mass && !is_bluedrop())
    throw error(joined_text({"--mass: must be given for ", device_name(),
                             ": the published masses are those of the BlueDrop as it is"}));
  return mass.value_or(usual_mass(tip));
}

void check(const DeviceOptions& o) {
  const bool cone = o.tip == Tip::cone || o.tip == Tip::cone_truncated;
  require(o.shoulder == Shoulder::sharp || cone, "--shoulder", "fillet",
          "needs --tip cone or cone-truncated");
  require(!o.cone_angle || cone, "--cone-angle", o.cone_angle.value_or(0),
          "needs --tip cone or cone-truncated");
  if (o.flat) {
    require(o.tip == Tip::cone_truncated, "--flat", *o.flat, "needs --tip cone-truncated");
    require(*o.flat < o.outer_diameter(), "--flat", *o.flat,
            {"must be less than the diameter, ", o.outer_diameter(), " m; --tip blunt is flat altogether"});
  }
  DeviceShape shape = o.shape();
  const double cone_height = Device{[&] {
                               DeviceShape long_one = shape;
                               long_one.length += 1e3 * shape.radius;
                               long_one.fillet = 0;
                               return long_one;
                             }()}
                                 .cone_height();
  require(shape.length > cone_height + shape.radius, "--length", shape.length,
          {"must be more than the tip's height and half a diameter, ", cone_height + shape.radius, " m"});
}

void check_mass(const DeviceOptions& o) {
  const double density = o.mean_density();
  require(density >= least_density && density <= most_density, "--mass", o.device_mass(),
          {"must give a mean density in [", least_density, ", ", most_density, "] kg/m3, not ", density,
           ": the penetrometer, ", o.outer_diameter(), " m wide and ", o.whole_length(), " m long, has ",
           1e3 * o.device_mass() / density, " litres; see --diameter and --length"});
}

}  // namespace arenite::ffp
