// The penetrometer in results: written, and read back.
#pragma once

#include <string>

#include "../text/json_file.hpp"
#include "device_options.hpp"

namespace arenite::ffp {

/// Name, shape, areas and mean density, with the mass in kg.
Json json_of(const DeviceOptions& o, double mass);

/// The options that give the penetrometer of `json_of`, whose values need not all be there: those of earlier versions are the
/// BlueDrop's. Throws `error` for a word that is none.
DeviceOptions device_in(const Json& inputs);

/// "cone-10cm2, cone: 3.57 cm wide, 25.7 cm long, 1.2 kg (4,900 kg/m3)".
std::string text_of(const DeviceOptions& o, double mass);

}  // namespace arenite::ffp
