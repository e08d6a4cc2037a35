#include "earlier_run.hpp"

#include <nlohmann/json.hpp>

#include "../text/json_file.hpp"
#include "../text/words.hpp"
#include "drop_folder.hpp"
#include "results.hpp"
#include "summary_file.hpp"

namespace arenite::ffp {

namespace {

/// The first input that differs: "velocity_m_s is 5.6 there, 6 here".
std::string first_difference(const Json& there, const Json& here) {
  for (const auto& [key, value] : here.items())
    if (!there.contains(key) || there[key] != value)
      return joined_text({key, " is ", there.contains(key) ? json_text(there[key]) : "nothing", " there, ",
                          json_text(value), " here"});
  return "the file of the mesh has changed";
}

}  // namespace

EarlierRun earlier_run(const DropOptions& options) {
  const std::filesystem::path folder{options.out};
  EarlierRun found;
  if (!std::filesystem::exists(summary_file(folder))) return found;
  const auto refuse = [&](const std::string& rule) {
    throw error(joined_text({"--resume: ", shown(summary_file(folder).string()), ": ", rule}));
  };
  try {
    const Json summary = read_json(summary_file(folder), "--resume: summary");
    if (summary.at("inputs_hash") != hash_of_inputs(options))
      refuse("is of a run with other inputs: " + first_difference(summary.at("inputs"), inputs_of(options)));
    found.finished = summary.at("status") == "done";
    found.started = summary.at("started").get<std::string>();
    found.wall_s = summary.value("wall_s", 0.0);
    found.warnings = summary.value("warnings", found.warnings);
    found.resumed_at_s = summary.value("resumed_at_s", found.resumed_at_s);
  } catch (const Json::exception&) {
    refuse("is no summary of a drop");
  }
  found.has_state = std::filesystem::exists(folder / state_file_name);
  return found;
}

}  // namespace arenite::ffp
