#include "device_json.hpp"

#include <nlohmann/json.hpp>

#include <arenite/core/error.hpp>

#include "../text/words.hpp"
#include "options.hpp"

namespace arenite::ffp {

namespace {

template <class Words>
auto meaning_of(const Words& words, const std::string& name, const char* what) {
  for (const auto& [word, meaning] : words)
    if (word == name) return meaning;
  throw error(joined_text({what, " = ", shown(name), ": no such ", what}));
}

}  // namespace

Json json_of(const DeviceOptions& o, double mass) {
  const DeviceShape shape = o.shape();
  const Device device{shape};
  Json j;
  j["name"] = o.device_name();
  j["source"] = o.profile ? o.profile->source
                          : std::string{size_of(o.penetrometer).source} + (o.is_changed() ? ", changed" : "");
  j["diameter_m"] = o.outer_diameter();
  j["length_m"] = o.whole_length();
  const bool cone = o.tip == Tip::cone || o.tip == Tip::cone_truncated;
  if (cone && !shape.profile) j["cone_angle_deg"] = o.cone_angle.value_or(60);
  if (!shape.profile && shape.flat > 0) j["flat_m"] = 2 * shape.flat;
  j["section_m2"] = device.projected_area(device.length());
  j["mantle_m2"] = device.mantle_area(device.length());
  j["volume_m3"] = device.volume();
  j["mass_kg"] = mass;
  j["mean_density_kg_m3"] = mass / device.volume();
  return j;
}

DeviceOptions device_in(const Json& inputs) {
  DeviceOptions o;
  if (inputs.contains("device_profile"))
    o.profile = device_profile(inputs.at("device_profile"), "device_profile");
  o.tip = meaning_of(tip_words, inputs.value("tip", "cone"), "tip");
  o.penetrometer = meaning_of(penetrometer_words, inputs.value("penetrometer", "bluedrop"), "penetrometer");
  const auto take = [&](const char* key, std::optional<double>& to) {
    if (inputs.contains(key)) to = inputs.at(key).get<double>();
  };
  take("diameter_m", o.diameter);
  take("length_m", o.length);
  take("cone_angle_deg", o.cone_angle);
  take("flat_m", o.flat);
  take("mass_kg", o.mass);
  if (const double fillet = inputs.value("fillet_m", 0.0); fillet > 0) {
    o.shoulder = Shoulder::fillet;
    o.fillet = fillet;
  }
  return o;
}

std::string text_of(const DeviceOptions& o, double mass) {
  const Device device{o.shape()};
  return joined_text({o.device_name(), ": ", rounded(o.outer_diameter() * 100), " cm wide, ",
                      rounded(o.whole_length() * 100), " cm long, ", rounded(mass), " kg (",
                      rounded(mass / device.volume()), " kg/m3 of its outline)"});
}

}  // namespace arenite::ffp
