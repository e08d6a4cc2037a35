// The folder of a drop or a push: which of its files are results, and how messages call it.
#pragma once

#include <algorithm>
#include <filesystem>
#include <functional>
#include <string>
#include <string_view>
#include <system_error>
#include <vector>

#include <arenite/run/run_folder.hpp>

#include "../text/words.hpp"

namespace arenite::ffp {

/// The state of a run that has not come to its end, in its folder: a file of arenite-ffp's, or a folder of tiles of arenite-ffp-mpi's.
inline constexpr const char* state_file_name = "checkpoint.state";
inline constexpr const char* saved_tiles_name = "checkpoint";

/// Whether there is one, of the one program or the other.
inline bool has_state(const std::filesystem::path& folder, bool on_ranks) {
  return std::filesystem::exists(on_ranks ? folder / saved_tiles_name / "tiles.txt"
                                          : folder / state_file_name);
}
/// Removes the state of a run that is done.
inline void remove_state_file(const std::filesystem::path& folder) {
  std::error_code ignored;  // it only takes space
  std::filesystem::remove(folder / state_file_name, ignored);
}
/// Removes saved tiles, and nothing else that may lie there.
inline void remove_saved_tiles(const std::filesystem::path& folder) {
  std::error_code ignored;  // they only take space
  std::vector<std::filesystem::path> found;
  for (const auto& entry : std::filesystem::directory_iterator(folder / saved_tiles_name, ignored)) {
    const std::string name = entry.path().filename().string();
    if (name.starts_with("tiles.txt") || (name.starts_with("tile") && name.find(".state") != name.npos))
      found.push_back(entry.path());
  }
  std::ranges::sort(found, std::greater{});  // first the list, without which the others claim nothing
  for (const auto& file : found) std::filesystem::remove(file, ignored);
  std::filesystem::remove(folder / saved_tiles_name, ignored);  // if it is empty
}

/// Whether a file of this name is one that a drop or a push writes, or one of the pictures that are drawn of it:
/// what a new run removes. ".part" is what a killed run may leave of each.
inline bool is_result(std::string_view name) {
  if (name.ends_with(".part")) name.remove_suffix(5);
  for (const std::string_view own :
       {"summary.json", "history.csv", "fields.pvd", "histories.png", "strain.png", "reduced.csv",
        "reduced.json", "reduced.png", "reduced.svg", "push.png", "push.svg", state_file_name})
    if (name == own) return true;
  for (const std::string_view part :
       {"fields_soil_", "fields_device_points_", "fields_mesh_", "fields_device_"})
    if (name.starts_with(part) && name.ends_with(".vtu") && name.size() >= part.size() + 8) {
      auto number = name.substr(part.size(), name.size() - part.size() - 4);
      if (const auto at = number.find('_');
          number.front() == 'p' && at != std::string_view::npos)  // piece of a tile
        number = number.substr(at + 1);
      return !number.empty() && number.find_first_not_of("0123456789") == std::string_view::npos;
    }
  return false;
}

/// Takes the folder of `--out` for a run: a "drop", a "push". The summary is removed first, then the index of the fields.
inline RunFolder folder_of_run(const char* run, const std::string& out, RunFolder::Earlier earlier) {
  return RunFolder{out,
                   earlier,
                   {"--out", run, ".arenite-ffp.lock", is_result, {"summary.json", "fields.pvd"}},
                   shown(out)};
}
inline RunFolder drop_folder(const std::string& out,
                             RunFolder::Earlier earlier = RunFolder::Earlier::removed) {
  return folder_of_run("drop", out, earlier);
}

}  // namespace arenite::ffp
