// The uncertainty of a resistance: coarser cells, and twice the speed.
#include <cmath>
#include <iostream>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>

#include "../drop/barred_result.hpp"
#include "../drop/drop.hpp"
#include "../drop/drop_folder.hpp"
#include "../drop/summary_file.hpp"
#include "../text/say.hpp"
#include "../text/words.hpp"
#include "push.hpp"

namespace arenite::ffp {

void push_with_error_bar(const PushOptions& options) {
  push(options);
  RunFolder folder =
      folder_of_run("push", options.out, RunFolder::Earlier::kept);  // nobody takes it meanwhile
  const double root2 = std::sqrt(2.0);
  std::map<std::string, std::optional<double>> net;
  Json summary = summary_in(options.out), runs = Json::object();
  const auto companion = [&](const std::string& name, double cell_ratio, double speed_ratio) {
    PushOptions o = options;
    o.is_companion = o.quiet = true;
    o.error_bar = false;
    o.fields_every = 0;
    o.cell = cell_ratio * options.cell_size();
    o.speed = speed_ratio * options.push_speed();
    o.out += "/error-bar/" + name;
    if (!options.quiet) say("error bar: " + name);
    const auto failed = [&](const std::string& why) {
      runs[name] = {{"failure", why}};
      say(joined_text({"warning: error bar, ", name, ": ", shown(why, 1000)}));
    };
    try {
      push(o);
      const Json found = summary_in(o.out);
      net[name] = found.at("net_resistance_kPa").get<double>();
      runs[name] = {{"net_resistance_kPa", *net[name]}, {"wall_s", found.at("wall_s")}};
    } catch (const Ended& e) {
      if (e.exit_code() > 128) throw;
      failed(e.what());
    } catch (const std::exception& e) {
      failed(e.what());
    }
  };
  companion("cells-2", 2, 1);
  companion("cells-2-speed-2", 2, 2);
  companion("cells-1.41", root2, 1);

  const double cell = options.cell_size();
  const auto &coarse = net["cells-1.41"], &coarsest = net["cells-2"], &fast = net["cells-2-speed-2"];
  BarredResult result;
  result.value = summary.at("net_resistance_kPa").get<double>();
  if (coarse && coarsest)
    result.cells = convergence({{cell, result.value}, {root2 * cell, *coarse}, {2 * cell, *coarsest}});
  result.uncertainty.add("cells", result.cells ? std::optional{result.cells->uncertainty} : std::nullopt);
  // Twice the speed changes by as much as standing still would, if not by more.
  std::optional<double> faster;  // kPa
  if (fast && coarsest) faster = *fast - *coarsest;
  result.uncertainty.add("speed", faster ? std::optional{std::abs(*faster)} : std::nullopt);
  summary["uncertainty"]["net_resistance_kPa"] = json_of(result);
  summary["uncertainty"]["runs"] = runs;
  folder.free_reserve();
  try {
    write_json(summary_file(folder.path()), summary);
  } catch (const error& e) {
    throw Ended(joined_text({"the error bar cannot be written: ", e.what()}), 1);
  }
  if (options.quiet) return;
  std::cout << "net resistance " << words_of(result, "kPa") << "; cells: " << words_of_cells(result, "pushes")
            << "; twice the speed: " << (faster ? rounded(100 * *faster / *coarsest) + " %" : "unknown")
            << std::endl;
}

}  // namespace arenite::ffp
