// summary.json of a run's folder, read back.
#pragma once

#include <filesystem>
#include <optional>

#include "../text/json_file.hpp"

namespace arenite::ffp {

std::filesystem::path summary_file(const std::filesystem::path& folder);

/// The summary in a folder, as "summary" in messages. Throws `error` that names the file if it is none.
Json summary_in(const std::filesystem::path& folder);

/// The same; nothing where there is no object that can be read.
std::optional<Json> readable_summary_in(const std::filesystem::path& folder);

}  // namespace arenite::ffp
