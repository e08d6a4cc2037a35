#include "error_bar.hpp"

#include <cmath>
#include <iostream>
#include <map>
#include <nlohmann/json.hpp>
#include <string>

#include "../text/say.hpp"
#include "barred_result.hpp"
#include "companions.hpp"
#include "drop.hpp"
#include "drop_folder.hpp"
#include "results.hpp"
#include "summary_file.hpp"

namespace arenite::ffp {
namespace {

/// A companion after its run.
struct FinishedRun {
  Json summary;
  std::string failure;  ///< empty: it is done
};

/// Runs a companion, or takes over what is there of it. Only a signal that ends it is thrown.
FinishedRun run_companion(const Companion& companion, bool resume) {
  DropOptions o = companion.options;
  const auto earlier = resume ? readable_summary_in(o.out) : std::nullopt;
  o.resume = earlier && earlier->value("inputs_hash", Json()) == hash_of_inputs(o);
  FinishedRun run;
  try {
    drop(o);
    run.summary = summary_in(o.out);
    if (run.summary.value("status", "") != "done") run.failure = "its summary.json cannot be read";
  } catch (const Ended& e) {
    if (e.exit_code() > 128)
      throw Ended(joined_text({"error bar, ", companion.name, ": ", e.what(), "; --resume goes on with it"}),
                  e.exit_code());
    run.failure = e.what();
  } catch (const std::exception& e) {
    run.failure = e.what();
  }
  return run;
}

/// One result of all drops, by the name of the summary.
BarredResult result_of(const DropOptions& o, const Json& own, const std::map<std::string, FinishedRun>& runs,
                       const char* key) {
  return barred_result(o, own.at(key).get<double>(), [&](const std::string& name) -> std::optional<double> {
    const FinishedRun& run = runs.at(name);
    if (!run.failure.empty() || !run.summary.at(key).is_number()) return std::nullopt;
    return run.summary.at(key).get<double>();
  });
}

std::string part_line(const std::string& name, const BarredResult& depth, const BarredResult& peak,
                      const std::string& what) {
  const auto number = [&](const BarredResult& r, const char* unit) {
    const auto u = r.uncertainty.part(name).value;
    return u ? rounded(*u) + unit : std::string{"unknown"};
  };
  std::array<char, 256> text{};
  std::snprintf(text.data(), text.size(), "  %-15s %11s %9s  %s", name.c_str(), number(depth, " m").c_str(),
                number(peak, " g").c_str(), what.c_str());
  return text.data();
}

}  // namespace

void drop_with_error_bar(const DropOptions& options) {
  drop(options);
  RunFolder folder = drop_folder(options.out, RunFolder::Earlier::kept);  // nobody takes it meanwhile
  std::map<std::string, FinishedRun> runs;
  const auto companions = companions_of(options);
  for (const Companion& c : companions) {
    if (!options.quiet)
      say(joined_text({"error bar, ", runs.size() + 1, " of ", companions.size(), ": ", c.name}));
    runs[c.name] = run_companion(c, options.resume);
    if (const auto& failure = runs[c.name].failure; !failure.empty())
      say(joined_text({"warning: error bar, ", c.name, ": ", shown(failure, 1000)}));
  }

  Json summary = summary_in(options.out);
  const BarredResult depth = result_of(options, summary, runs, "final_penetration_m");
  const BarredResult peak = result_of(options, summary, runs, "peak_deceleration_g");
  Json& bar = summary["uncertainty"] = Json::object();
  bar["final_penetration_m"] = json_of(depth);
  bar["peak_deceleration_g"] = json_of(peak);
  double time = 0;
  std::size_t warnings = 0;
  for (const Companion& c : companions) {
    const FinishedRun& run = runs.at(c.name);
    Json& j = bar["runs"][c.name] = Json::object();
    if (!run.failure.empty()) {
      j["failure"] = run.failure;
      continue;
    }
    for (const char* key : {"final_penetration_m", "peak_deceleration_g", "wall_s"})
      j[key] = run.summary.at(key);
    time += run.summary.value("wall_s", 0.0);
    if (run.summary.contains("warnings")) warnings += run.summary["warnings"].size();
  }
  const double cost = time / summary.at("wall_s").get<double>();
  bar["cost"] = cost;
  folder.free_reserve();
  try {
    write_json(summary_file(folder.path()), summary);
  } catch (const error& e) {
    throw Ended(joined_text({"the error bar cannot be written: ", e.what()}), 1);
  }
  if (options.quiet) return;

  std::cout << "final penetration " << words_of(depth, "m") << ", peak " << words_of(peak, "g") << '\n'
            << part_line("cells", depth, peak, "depth " + words_of_cells(depth, "drops")) << '\n'
            << std::string(40, ' ') << "peak " << words_of_cells(peak, "drops") << '\n'
            << part_line("contact_offset", depth, peak, "surface moved by a quarter of a cell") << '\n'
            << part_line("points", depth, peak, "other numbers of points, and jittered ones") << '\n'
            << part_line("flip_time", depth, peak, "share of FLIP with another time constant") << '\n'
            << "  the drops around it took " << rounded(cost) << " times its own time";
  if (warnings > 0) std::cout << "; their warnings: " << warnings << ", in error-bar/*/summary.json";
  std::cout << std::endl;
}

}  // namespace arenite::ffp
