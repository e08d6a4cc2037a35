// A record of deceleration as a table of text: columns found by their names, whoever wrote them.
#pragma once

#include <filesystem>

#include "../options/reduce_options.hpp"
#include "../text/table_reader.hpp"
#include "measurement.hpp"

namespace arenite::ffp {

/// Reads a table. `whole_lines`: a last line without line break is cut, and left out. Throws `error` that
/// names the file and what is missing in it.
Measurement read_measurement_table(const std::filesystem::path& path, const ReduceOptions& o, double gravity,
                                   bool whole_lines = false);

}  // namespace arenite::ffp
