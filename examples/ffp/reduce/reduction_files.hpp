// A reduction written down: reduced.csv, reduced.json, and the table on the terminal.
#pragma once

#include <filesystem>
#include <ostream>

#include "../options/options.hpp"
#include "../text/json_file.hpp"
#include "reduction.hpp"

namespace arenite::ffp {

/// One row a sample from the impact on. Values that there are not are empty fields. Throws `error` if it
/// cannot be written.
void write_reduced_csv(const std::filesystem::path& path, const Reduction& r, const ReduceOptions& o);

/// reduced.json as a value.
Json json_of(const Reduction& r, const ReduceOptions& o);

void write_reduced_json(const std::filesystem::path& path, const Reduction& r, const ReduceOptions& o);

/// The table that a user reads.
void print_table(const Reduction& r, const ReduceOptions& o, std::ostream& out);

}  // namespace arenite::ffp
