// The folder of a drop: which of its files are results, and how messages call it.
#pragma once

#include <string>
#include <string_view>

#include <arenite/run/run_folder.hpp>

#include "../text/words.hpp"

namespace arenite::ffp {

/// The state of a run that has not come to its end, in its folder.
inline constexpr const char* state_file_name = "checkpoint.state";

/// Whether a file of this name is one that a drop writes, or one of the pictures that plot.py draws of it:
/// what a new run removes. ".part" is what a killed run may leave of each.
inline bool is_result(std::string_view name) {
  if (name.ends_with(".part")) name.remove_suffix(5);
  for (const std::string_view own :
       {"summary.json", "history.csv", "fields.pvd", "histories.png", "strain.png", "reduced.csv",
        "reduced.json", "reduced.png", "reduced.svg", state_file_name})
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

/// Takes the folder of `--out`. The summary is removed first, then the index of the fields.
inline RunFolder drop_folder(const std::string& out,
                             RunFolder::Earlier earlier = RunFolder::Earlier::removed) {
  return RunFolder{out,
                   earlier,
                   {"--out", "drop", ".arenite-ffp.lock", is_result, {"summary.json", "fields.pvd"}},
                   shown(out)};
}

}  // namespace arenite::ffp
