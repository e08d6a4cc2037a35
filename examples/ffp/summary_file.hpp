// summary.json of a run's folder, read back.
#pragma once

#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>

namespace arenite::ffp {

inline std::filesystem::path summary_file(const std::filesystem::path& folder) {
  return folder / "summary.json";
}

/// The summary in a folder; discarded (`is_discarded`) if there is none that can be read.
inline nlohmann::ordered_json summary_in(const std::filesystem::path& folder) {
  std::ifstream file{summary_file(folder)};
  return nlohmann::ordered_json::parse(file, nullptr, false);
}

}  // namespace arenite::ffp
