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

/// A state says by its kind which program saved it; the other one cannot resume from it.
void refuse_other_program(const std::filesystem::path& folder, bool on_ranks) {
  if (has_state(folder, on_ranks) || !has_state(folder, !on_ranks)) return;
  const std::string there = on_ranks ? "arenite-ffp" : "arenite-ffp-mpi",
                    here = on_ranks ? "arenite-ffp-mpi" : "arenite-ffp";
  throw error(joined_text({"--resume: --out = ", shown(folder.string()), ": has the state of a run of ",
                           there, ", ", on_ranks ? state_file_name : saved_tiles_name, ", from which ", here,
                           " cannot go on: resume with ", there,
                           ", or give another --out (a run without --resume "
                           "replaces what is there)"}));
}

}  // namespace

EarlierRun earlier_run(const DropOptions& options, bool on_ranks) {
  const std::filesystem::path folder{options.out};
  EarlierRun found;
  if (!std::filesystem::exists(summary_file(folder))) {
    refuse_other_program(folder, on_ranks);
    return found;
  }
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
  if (!found.finished) refuse_other_program(folder, on_ranks);
  found.has_state = has_state(folder, on_ranks);
  return found;
}

}  // namespace arenite::ffp
