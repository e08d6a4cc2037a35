// A record of deceleration from whatever FILE is: a drop's folder, a BlueDrop's raw record, or a table.
#pragma once

#include <filesystem>
#include <string>

#include "../geometry/tip.hpp"
#include "../options/reduce_options.hpp"
#include "measurement.hpp"

namespace arenite::ffp {

/// history.csv and summary.json of a drop. Throws `error` that names the folder if they are not there or not
/// those of a drop.
Measurement read_measurement_of_drop(const std::filesystem::path& folder, const ReduceOptions& o);

/// The record, net and positive when it slows the penetrometer. Throws `error` that names the file.
Measurement read_measurement(const ReduceOptions& o);

}  // namespace arenite::ffp
