#include "device_profile.hpp"

#include <array>
#include <nlohmann/json.hpp>
#include <string_view>
#include <utility>

#include <arenite/core/error.hpp>

#include "../text/range.hpp"
#include "../text/words.hpp"

namespace arenite::ffp {

namespace {

/// Numbers of the file beside the outline: names, where they belong, and limits.
constexpr std::array<std::pair<const char*, std::optional<double> DeviceProfile::*>, 3> numbers{
    {{"mass_kg", &DeviceProfile::mass},
     {"centre_of_mass_m", &DeviceProfile::centre_of_mass},
     {"gyration_m", &DeviceProfile::gyration}}};

bool is_point(const Json& value) {
  return value.is_array() && value.size() == 2 && value[0].is_number() && value[1].is_number();
}

Point2 point_of(const Json& value) { return {value[0].get<double>(), value[1].get<double>()}; }

ProfilePiece piece_of(const Json& value) {
  if (is_point(value)) return {point_of(value)};
  const bool is_arc = value.is_object() && value.size() == 2 && value.contains("to") &&
                      is_point(value["to"]) && value.contains("arc") && value["arc"].is_number() &&
                      value["arc"] != 0;
  require(is_arc, "profile", shown(json_text(value)),
          "must be a point [radius, height] in m, or {\"to\": [radius, height], \"arc\": radius of the arc "
          "to it}");
  return {point_of(value["to"]), value["arc"].get<double>()};
}

ProfileLine line_of(const Json& points) {
  require(points.is_array() && points.size() >= 2 && points.size() <= 1000, "profile",
          shown(json_text(points), 60),
          "must be an array of 2 to 1000 points, from the tip at [0, 0] to the top");
  require(is_point(points[0]) && point_of(points[0]) == Point2(0, 0), "profile", shown(json_text(points[0])),
          "must begin at the tip, [0, 0]");
  std::vector<ProfilePiece> pieces;
  for (std::size_t k = 1; k < points.size(); ++k) pieces.push_back(piece_of(points[k]));
  return ProfileLine{pieces};
}

}  // namespace

DeviceProfile device_profile(const Json& json, const std::string& what) {
  try {
    require(json.is_object() && json.contains("profile"), "profile", "(none)",
            "must be given: {\"name\": \"probe\", \"profile\": [[0, 0], [0.03, 0.05], [0.03, 0.4]]}");
    require(json.contains("name") && json["name"].is_string() && json["name"] != "", "name",
            json.contains("name") ? shown(json_text(json["name"])) : "(none)",
            "must be a text that is not empty");
    DeviceProfile p{.name = json["name"].get<std::string>(),
                    .source = {},
                    .line = line_of(json["profile"]),
                    .mass = {},
                    .centre_of_mass = {},
                    .gyration = {}};
    for (const auto& [key, value] : json.items()) {
      if (key == "name" || key == "profile") continue;
      if (key == "source") {
        require(value.is_string(), key, shown(json_text(value)), "must be a text");
        p.source = value.get<std::string>();
        continue;
      }
      const auto* number =
          std::ranges::find(numbers, key, [](const auto& n) { return std::string_view{n.first}; });
      require(number != numbers.end(), shown(key), shown(json_text(value)),
              "no such key; there are name, source, profile, mass_kg, centre_of_mass_m and gyration_m");
      require(value.is_number() && value > 0, key, shown(json_text(value)), "must be a number above 0");
      p.*(number->second) = value.get<double>();
    }
    require(!p.centre_of_mass || *p.centre_of_mass < p.line.length(), "centre_of_mass_m",
            p.centre_of_mass.value_or(0), {"must be less than the length, ", p.line.length(), " m"});
    require(!p.gyration || *p.gyration < p.line.length(), "gyration_m", p.gyration.value_or(0),
            {"must be less than the length, ", p.line.length(), " m"});
    return p;
  } catch (const error& e) {
    throw error(joined_text({what, ": ", e.what()}));
  }
}

DeviceProfile read_device_file(const std::string& path_or_json) {
  if (path_or_json.starts_with('{'))
    return device_profile(parse_json(path_or_json, "--device-file"), "--device-file");
  return device_profile(read_json(path_or_json, "--device-file"),
                        joined_text({"--device-file = ", shown(path_or_json)}));
}

Json json_of(const DeviceProfile& p) {
  Json j{{"name", p.name}};
  if (!p.source.empty()) j["source"] = p.source;
  j["profile"] = Json::array({Json::array({0, 0})});
  for (const auto& [to, arc] : p.line.pieces()) {
    const Json point = Json::array({to[0], to[1]});
    j["profile"].push_back(arc == 0 ? point : Json{{"to", point}, {"arc", arc}});
  }
  for (const auto& [name, member] : numbers)
    if (p.*member) j[name] = *(p.*member);
  return j;
}

}  // namespace arenite::ffp
