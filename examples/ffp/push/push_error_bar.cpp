// The uncertainty of a resistance: coarser cells, and twice the speed.
#include <cmath>
#include <iostream>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>

#include <arenite/study/convergence.hpp>
#include <arenite/study/uncertainty.hpp>

#include "../drop/drop.hpp"
#include "../drop/summary_file.hpp"
#include "../text/bar_words.hpp"
#include "../text/say.hpp"
#include "../text/words.hpp"
#include "push.hpp"

namespace arenite::ffp {

void push_with_error_bar(const PushOptions& options) {
  push(options);
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
    try {
      push(o);
      const Json found = summary_in(o.out);
      net[name] = found.at("net_resistance_kPa").get<double>();
      runs[name] = {{"net_resistance_kPa", *net[name]}, {"wall_s", found.at("wall_s")}};
    } catch (const Ended& e) {
      if (e.exit_code() > 128) throw;
      runs[name] = {{"failure", e.what()}};
      say(joined_text({"warning: error bar, ", name, ": ", shown(e.what(), 1000)}));
    }
  };
  companion("cells-2", 2, 1);
  companion("cells-2-speed-2", 2, 2);
  companion("cells-1.41", root2, 1);

  const double value = summary.at("net_resistance_kPa").get<double>(), cell = options.cell_size();
  std::optional<Convergence> cells;
  if (net["cells-2"] && net["cells-1.41"])
    cells = convergence({{cell, value}, {root2 * cell, *net["cells-1.41"]}, {2 * cell, *net["cells-2"]}});
  Uncertainty u;
  u.add("cells", cells ? std::optional{cells->uncertainty} : std::nullopt);
  const auto& fast = net["cells-2-speed-2"];
  // Twice the speed changes by as much as standing still would, if not by more.
  u.add("speed", fast && net["cells-2"] ? std::optional{std::abs(*fast - *net["cells-2"])} : std::nullopt);
  Json& bar = summary["uncertainty"]["net_resistance_kPa"] = Json::object();
  bar["value"] = value;
  bar["u"] = or_null(u.total());
  bar["order"] = or_null(cells ? cells->order : std::nullopt);
  bar["extrapolated"] = or_null(cells ? cells->extrapolated : std::nullopt);
  bar["converged"] = cells && cells->converged;
  for (const auto& part : u.parts()) bar["parts"][part.name] = or_null(part.value);
  summary["uncertainty"]["runs"] = runs;
  try {
    write_json(summary_file(options.out), summary);
  } catch (const error& e) {
    throw Ended(joined_text({"the error bar cannot be written: ", e.what()}), 1);
  }
  if (options.quiet) return;
  std::cout << "net resistance " << (u.total() ? with_bar(value, *u.total()) : rounded(value) + " +- unknown")
            << " kPa; cells: " << (cells ? words_of_cells(*cells, "pushes") : "unknown")
            << "; twice the speed: "
            << (fast && net["cells-2"] ? rounded(100 * (*fast / *net["cells-2"] - 1)) + " %" : "unknown")
            << std::endl;
}

}  // namespace arenite::ffp
