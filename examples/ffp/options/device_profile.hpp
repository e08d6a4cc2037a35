// A penetrometer that a drawing describes: its outline, and what else is known of it.
#pragma once

#include <optional>
#include <string>

#include "../geometry/profile.hpp"
#include "../text/json_file.hpp"

namespace arenite::ffp {

struct DeviceProfile {
  std::string name, source;
  ProfileLine line;
  std::optional<double> mass;            ///< kg
  std::optional<double> centre_of_mass;  ///< above the tip, m
  std::optional<double> gyration;        ///< radius about a line through the centre, across the axis, m
};

/// {"name": "probe", "source": "drawing 12", "profile": [[0, 0], [0.03, 0.05], {"to": [0.035, 0.06], "arc": 0.02}, [0.035, 0.4]],
/// "mass_kg": 5.2, "centre_of_mass_m": 0.19, "gyration_m": 0.11}: points (r, y) in m from the tip upward, each at the end of a line or
/// of an arc with this radius, which bulges outward if it is positive. Only "name" and "profile" must be there. Throws `error` that
/// begins with `what`.
DeviceProfile device_profile(const Json& json, const std::string& what);

/// The same from a file, or of the JSON itself, which begins with "{".
DeviceProfile read_device_file(const std::string& path_or_json);

Json json_of(const DeviceProfile& profile);

}  // namespace arenite::ffp
