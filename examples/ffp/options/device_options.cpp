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
  shape.profile = outline();
  return shape;
}

std::string DeviceOptions::device_name() const {
  if (profile) return profile->name;
  const bool tip_told = !outline() && (penetrometer == Penetrometer::bluedrop || tip != Tip::cone);
  return word_of(penetrometer_words, penetrometer) + (tip_told ? ", " + word_of(tip_words, tip) : "") +
         (is_changed() ? ", changed" : "");
}

double DeviceOptions::device_mass() const {
  if (mass) return *mass;
  if (profile && profile->mass) return *profile->mass;
  if (!is_bluedrop())
    throw error(joined_text({"--mass: must be given for ", device_name(),
                             ": the published masses are those of the BlueDrop as it is"}));
  return usual_mass(tip);
}

void read_device(DeviceOptions& o) {
  if (!o.device_file.empty()) o.profile = read_device_file(o.device_file);
}

namespace {

/// Throws `error` if the penetrometer is given by an outline and also by sizes of a cone.
void check_outline(const DeviceOptions& o) {
  const std::string with =
      o.profile ? "--device-file" : "--penetrometer " + word_of(penetrometer_words, o.penetrometer);
  for (const auto& [option, given] :
       {std::pair{"--tip", o.tip != Tip::cone},
        {"--cone-angle", o.cone_angle.has_value()},
        {"--flat", o.flat.has_value()},
        {"--shoulder", o.shoulder != Shoulder::sharp},
        {"--penetrometer", o.profile && o.penetrometer != o.of_itself},
        {"--diameter", o.profile && o.diameter},
        {"--length", o.length && (o.profile || o.penetrometer == Penetrometer::sphere)}})
    if (given) throw error(joined_text({option, ": goes without ", with, ", which tells its whole outline"}));
}

}  // namespace

void check(const DeviceOptions& o) {
  if (!o.profile && o.penetrometer == Penetrometer::ball)
    require(o.whole_length() > o.outer_diameter(), "--length", o.whole_length(),
            {"must be more than the diameter of the ball, ", o.outer_diameter(), " m"});
  if (o.outline()) return check_outline(o);
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
  DeviceShape longer = o.shape();  // however tall its tip
  longer.length += 1e3 * longer.radius;
  longer.fillet = 0;
  const double least = Device{longer}.tip_end() + longer.radius;
  require(o.whole_length() > least, "--length", o.whole_length(),
          {"must be more than the tip's height and half a diameter, ", least, " m"});
}

void check_mass(const DeviceOptions& o) {
  const double density = o.mean_density();
  require(density >= least_density && density <= most_density, "--mass", o.device_mass(),
          {"must give a mean density in [", least_density, ", ", most_density, "] kg/m3, not ", density,
           ": the penetrometer, ", o.outer_diameter(), " m wide and ", o.whole_length(), " m long, has ",
           1e3 * o.device_mass() / density, " litres; see --diameter and --length"});
}

}  // namespace arenite::ffp
