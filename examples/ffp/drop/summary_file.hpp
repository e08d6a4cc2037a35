// summary.json of a run's folder, read back.
#pragma once

#include <filesystem>
#include <optional>

#include "../text/json_file.hpp"

namespace arenite::ffp {

inline std::filesystem::path summary_file(const std::filesystem::path& folder) {
  return folder / "summary.json";
}

/// The summary in a folder, as "summary" in messages. Throws `error` that names the file if it is none.
inline Json summary_in(const std::filesystem::path& folder) {
  return read_json(summary_file(folder), "summary");
}

/// The same; nothing where there is no object that can be read.
inline std::optional<Json> readable_summary_in(const std::filesystem::path& folder) {
  try {
    Json found = summary_in(folder);
    if (found.is_object()) return found;
  } catch (const error&) {
  }
  return std::nullopt;
}

}  // namespace arenite::ffp
