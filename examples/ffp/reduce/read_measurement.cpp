#include "read_measurement.hpp"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <system_error>
#include <vector>

#include "../drop/history.hpp"
#include "../drop/summary_file.hpp"
#include "../options/device_json.hpp"
#include "../text/json_file.hpp"
#include "../text/table_reader.hpp"
#include "bluedrop_file.hpp"
#include "measurement_table.hpp"

namespace arenite::ffp {

namespace {

/// A column of the history of a drop.
std::vector<double> history_column(const std::filesystem::path& path, const std::string& name) {
  TableReader table(path, "FILE", most_history_bytes, true);
  table.find_header(1, [&](const std::vector<std::string>& names) {
    return HeaderMatch{int{std::ranges::find(names, name) != names.end()}, 0};
  });
  const auto& header = table.header();
  const auto place = static_cast<std::size_t>(std::ranges::find(header, name) - header.begin());
  require(place < header.size(), table.file(), name, "there is no such column");
  std::vector<double> values;
  while (table.next()) values.push_back(table.number(place));
  return values;
}

/// Throws `error` of an option that needs another kind of FILE.
void check_kind(const ReduceOptions& o, bool is_folder, bool is_bluedrop) {
  const std::string is = is_folder ? "the folder of a drop" : is_bluedrop ? "a BlueDrop's record" : "a table";
  const auto check = [&](const char* needs, bool holds,
                         std::initializer_list<std::pair<const char*, bool>> options) {
    for (const auto& [option, given] : options)
      if (given && !holds) throw error(joined_text({option, ": needs ", needs, ", and FILE is ", is}));
  };
  check("a table", !is_folder && !is_bluedrop,
        {{"--column", !o.column.empty()},
         {"--time-column", !o.time_column.empty()},
         {"--rate", o.rate.has_value()},
         {"--time-unit", o.time_unit != TimeUnit::named},
         {"--deceleration-unit", o.deceleration_unit != DecelerationUnit::named}});
  check("a BlueDrop's record (.bin)", is_bluedrop,
        {{"--calibration", !o.calibration.empty()},
         {"--scale", !o.scale.empty()},
         {"--offset", !o.offset.empty()}});
}

}  // namespace

Measurement read_measurement_of_drop(const std::filesystem::path& folder, const ReduceOptions& o) {
  const auto refuse = [&](const std::string& rule) {
    throw error(
        joined_text({shown(folder.string()), ": must hold summary.json and history.csv of a drop: ", rule}));
  };
  const std::string name = shown(folder.string());
  require(o.reads == Reading::net, "--reads", "proper",
          "goes without the folder of a drop, whose record is net");
  for (const auto& [option, given] : {std::pair{"--penetrometer", o.penetrometer != Penetrometer::bluedrop},
                                      {"--diameter", o.diameter.has_value()},
                                      {"--length", o.length.has_value()},
                                      {"--cone-angle", o.cone_angle.has_value()},
                                      {"--flat", o.flat.has_value()}})
    if (given)
      throw error(
          joined_text({option, ": goes without the folder of a drop, which tells its own penetrometer"}));
  if (o.invert)
    throw error("--invert: goes without the folder of a drop, whose record is positive when it slows");
  if (!std::filesystem::exists(summary_file(folder))) refuse("summary.json cannot be read");
  const Json summary = summary_in(folder);
  if (!std::filesystem::exists(folder / "history.csv")) refuse("there is no history.csv");
  try {
    if (const std::string status = summary.value("status", "done"); status != "done")
      throw error(joined_text({"FILE = ", name, ": status = ", shown(status), ": must be done",
                               status == "running" ? ", and not still run or have been killed" : "",
                               "; reduce ", name, "/history.csv as a table reads what there is"}));
    const Json& inputs = summary.at("inputs");
    const auto number = [&](const char* key) { return inputs.at(key).get<double>(); };
    DropFacts facts{.impact_velocity = number("velocity_m_s"),
                    .mass = number("mass_kg"),
                    .gravity = number("gravity_m_s2"),
                    .unit_weight = number("unit_weight_N_m3"),
                    .k0 = number("k0"),
                    .device = device_in(inputs),
                    .contact_offset = inputs.value("contact_offset_m", 0.0)};
    Measurement m = read_measurement_table(folder / "history.csv", o, facts.gravity, true);
    m.step_means = true;
    m.drop = facts;
    if (inputs.value("kinematics", "") ==
        "space") {  // deceleration and velocity are those of the centre of mass
      m.depth = history_column(folder / "history.csv", "penetration_m");
      m.notes.push_back(
          joined_text({"depth is that of the tip, velocity that of the centre of mass; it ended tilted by ",
                       rounded(summary.value("final_tilt_deg", 0.0)), " deg and ",
                       rounded(100 * summary.value("final_aside_m", 0.0)),
                       " cm aside, and areas are those of an upright one"}));
    }
    return m;
  } catch (const Json::exception&) {
    refuse("summary.json is none");
    throw;
  }
}

Measurement read_measurement(const ReduceOptions& o) {
  const std::filesystem::path path{o.file};
  const std::string file = shown(o.file);
  std::error_code code;
  const auto status = std::filesystem::status(path, code);
  require(std::filesystem::exists(status), "FILE", file, "there is no such file or folder");
  const double gravity = o.gravity.value_or(standard_gravity);
  const bool is_folder = std::filesystem::is_directory(status),
             is_bluedrop = !is_folder && (path.extension() == ".bin" || path.extension() == ".BIN");
  check_kind(o, is_folder, is_bluedrop);
  Measurement m = is_folder     ? read_measurement_of_drop(path, o)
                  : is_bluedrop ? read_bluedrop(path, o, gravity)
                                : read_measurement_table(path, o, gravity);
  for (double& a : m.deceleration) {
    if (o.invert) a = -a;
    if (o.reads == Reading::proper) a -= gravity;
  }
  check(m, file);
  return m;
}

}  // namespace arenite::ffp
