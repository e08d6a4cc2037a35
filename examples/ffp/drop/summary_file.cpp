#include "summary_file.hpp"

#include <nlohmann/json.hpp>

#include <arenite/core/error.hpp>

namespace arenite::ffp {

std::filesystem::path summary_file(const std::filesystem::path& folder) { return folder / "summary.json"; }

Json summary_in(const std::filesystem::path& folder) { return read_json(summary_file(folder), "summary"); }

std::optional<Json> readable_summary_in(const std::filesystem::path& folder) {
  try {
    Json found = summary_in(folder);
    if (found.is_object()) return found;
  } catch (const error&) {
  }
  return std::nullopt;
}

}  // namespace arenite::ffp
