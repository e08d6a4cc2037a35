// `arenite-ffp reduce`: what a record of deceleration says of the ground.
#pragma once

#include <string>

#include "../options/reduce_options.hpp"

namespace arenite::ffp {

/// Reduces a record, writes reduced.csv and reduced.json, prints a table and draws a picture. Throws `error`
/// for options or a file that cannot be used, `output_error` for files that cannot be written.
void reduce(const ReduceOptions& options);

/// The same of a drop's folder, into it, without table and picture.
void reduce_drop(const std::string& folder);

}  // namespace arenite::ffp
