#include "paper_table.hpp"

#include <cmath>
#include <nlohmann/json.hpp>
#include <utility>

#include "../drop/summary_file.hpp"
#include "../text/words.hpp"

namespace arenite::ffp {

double sand_wave_speed() {
  const DropOptions o;
  const double constrained = o.young * (1 - o.poisson) / ((1 + o.poisson) * (1 - 2 * o.poisson));
  return std::sqrt(constrained / (o.unit_weight / standard_gravity));
}

namespace {

/// First time from which two depths differ by more than `apart`, m, for good; none: never.
std::optional<double> time_apart(const CaseResult& a, const CaseResult& b, double apart) {
  std::optional<double> since;
  for (std::size_t i = 0; i < a.time.size(); ++i) {
    const auto other = b.depth_at(a.time[i]);
    if (!other) break;
    if (std::abs(a.depth[i] - *other) <= apart)
      since.reset();
    else if (!since)
      since = a.time[i];
  }
  return since;
}

std::optional<double> times(std::optional<double> value, double factor) {
  return value ? std::optional{*value * factor} : std::nullopt;
}
std::optional<double> ratio(std::optional<double> a, std::optional<double> b) {
  return a && b && *b != 0 ? std::optional{*a / *b} : std::nullopt;
}

/// Step at which an element would become unstable, s: that of the first step over the Courant number.
std::optional<double> critical_step(const CaseResult& r) {
  return r.step.size() > 1 ? std::optional{r.step[1] / DropOptions{}.courant_number()} : std::nullopt;
}

}  // namespace

std::optional<double> number_at(const Json& object, const char* key) {
  if (!object.contains(key) || !object[key].is_number()) return std::nullopt;
  return object[key].get<double>();
}

CaseResult result_of_case(const std::filesystem::path& folder) {
  CaseResult result;
  if (auto summary = readable_summary_in(folder)) result.summary = *std::move(summary);
  const auto path = folder / "history.csv";
  if (!std::filesystem::exists(path)) return result;
  TableReader history(path, "history", most_history_bytes, true);  // the last row of a killed run may be cut
  if (!history.find_header(1, [](const auto& names) { return HeaderMatch{names[0] == "time_s"}; }))
    return result;
  struct Place {
    std::size_t column;
    std::vector<double>& values;
  };
  std::vector<Place> places;
  const auto& header = history.header();
  for (const auto& [name, values] :
       {std::pair{"time_s", &result.time}, {"penetration_m", &result.depth}, {"time_step_s", &result.step}})
    if (const auto at = std::ranges::find(header, name); at != header.end())
      places.push_back({static_cast<std::size_t>(at - header.begin()), *values});
  while (history.next())
    for (const Place& p : places) p.values.push_back(history.number(p.column));
  return result;
}

std::vector<Comparison> paper_comparisons(const PaperOptions& o, const CaseResults& results) {
  static const CaseResult none;
  const auto of = [&](Kinematics kinematics, DeviceKind device, int delta, LawKind law) -> const CaseResult& {
    const auto found = results.find(name_of_case(kinematics, device, delta, law));
    return found == results.end() ? none : found->second;
  };
  std::vector<Comparison> all;
  const auto compare = [&](Kinematics kinematics, LawKind law) {
    const std::string model =
        (kinematics == Kinematics::slice ? "slice, " : "half-section, ") + word_of(law_words, law);
    const auto rigid = [&](int delta) -> const CaseResult& {
      return of(kinematics, DeviceKind::rigid, delta, law);
    };
    const auto add = [&](const std::string& quantity, const char* unit, std::optional<double> paper,
                         std::optional<double> ours, std::optional<double> bar = {}, const char* note = "") {
      all.push_back({quantity, unit, model, paper, ours, bar, note});
    };
    const CaseResult &smooth = rigid(20), &rough = rigid(40);
    const char *depth = "final_penetration_m", *peak = "peak_deceleration_g";
    add("final penetration, delta = 20 deg", "cm", 20, times(smooth.number(depth), 100),
        times(smooth.bar(depth), 100));
    add("final penetration, fully rough", "cm", 14, times(rough.number(depth), 100),
        times(rough.bar(depth), 100));
    add("fully rough over 20 deg", "", 0.7, ratio(rough.number(depth), smooth.number(depth)));
    add("peak deceleration, delta = 20 deg", "g", 17, smooth.number(peak), smooth.bar(peak));
    add("peak deceleration, fully rough", "g", 23, rough.number(peak), rough.bar(peak));
    add("depth at 25 ms, delta = 20 deg", "cm", 12, times(smooth.depth_at(0.025), 100));
    add("first rest, delta = 20 deg", "ms", 60, times(smooth.number("max_penetration_time_s"), 1e3));
    add("first rest, fully rough", "ms", 60, times(rough.number("max_penetration_time_s"), 1e3));
    add("second peak, delta = 20 deg", "g", {}, smooth.number("second_peak_deceleration_g"), {},
        smooth.done() && !smooth.number("second_peak_deceleration_g")
            ? "none; the paper has one, lower than the first"
            : "the paper: one, lower than the first");
    add("20 deg and rough part by 5 mm", "ms", 40,
        smooth.done() && rough.done() ? times(time_apart(smooth, rough, 5e-3), 1e3) : std::nullopt);
    if (kinematics == Kinematics::axisymmetric)
      add("peak deceleration, delta = 32 deg", "g", 19.4, rigid(32).number(peak), {},
          "the experiment's peak");
    if (law != LawKind::mohr_coulomb) return;
    for (const int delta : {20, 40})
      add(joined_text({"greatest depth, elastic over rigid, ", delta, " deg"}), "", {},
          ratio(of(kinematics, DeviceKind::elastic, delta, law).number("max_penetration_m"),
                rigid(delta).number("max_penetration_m")),
          {}, "the paper: a minor effect; the elastic penetrometer has only Mohr-Coulomb");
    if (kinematics != Kinematics::slice) return;
    const CaseResult& elastic = of(kinematics, DeviceKind::elastic, 20, law);
    const auto rigid_step = critical_step(smooth), elastic_step = critical_step(elastic);
    add("material points, rigid", "", 326592, smooth.number("points"));
    add("critical time step, rigid", "us", 12.9, times(rigid_step, 1e6));
    add("the same times the wave speed of the sand", "mm", 12.9e-3 * sand_wave_speed(),
        times(rigid_step, 1e3 * sand_wave_speed()), {},
        "the shortest height of a cell that the step stands for: the meshes differ, and the paper's step may "
        "hold a "
        "Courant number");
    add("critical time step, elastic", "us", 5.39, times(elastic_step, 1e6), {},
        "depends on the density of the penetrometer, which the paper does not give");
    add("cost, rigid", "h", 5, times(smooth.number("wall_s"), 1 / 3600.0));
    add("cost, elastic", "h", 8, times(elastic.number("wall_s"), 1 / 3600.0));
    add("cost, elastic over rigid", "", 1.6, ratio(elastic.number("wall_s"), smooth.number("wall_s")));
  };
  compare(Kinematics::axisymmetric, LawKind::mohr_coulomb);
  if (o.law.kind != LawKind::mohr_coulomb) compare(Kinematics::axisymmetric, o.law.kind);
  if (!o.quick) compare(Kinematics::slice, LawKind::mohr_coulomb);
  return all;
}

Json paper_json(const PaperOptions& o, const std::vector<PaperCase>& cases, const CaseResults& results) {
  Json j;
  j["quick"] = o.quick;
  j["cell_m"] = o.cell;
  j["law"] = word_of(law_words, o.law.kind);
  j["cases"] = Json::array();
  for (const PaperCase& c : cases) {
    const auto found = results.find(c.name);
    const Json status =
        found == results.end() ? Json("not run") : found->second.summary.value("status", Json("not run"));
    Json one{{"name", c.name},
             {"kinematics", word_of(kinematics_words, c.options.kinematics)},
             {"device", word_of(device_words, c.options.device)},
             {"delta_deg", c.options.delta},
             {"law", word_of(law_words, c.options.law.kind)},
             {"status", status}};
    if (found != results.end() && found->second.summary.contains("failure"))
      one["failure"] = found->second.summary["failure"];
    j["cases"].push_back(std::move(one));
  }
  j["comparisons"] = Json::array();
  for (const Comparison& c : paper_comparisons(o, results))
    j["comparisons"].push_back({{"quantity", c.quantity},
                                {"unit", c.unit},
                                {"model", c.model},
                                {"paper", or_null(c.paper)},
                                {"ours", or_null(c.ours)},
                                {"bar", or_null(c.bar)},
                                {"difference", or_null(c.difference())},
                                {"note", c.note}});
  return j;
}

void print_paper_table(const std::vector<Comparison>& all, std::ostream& out) {
  const auto padded = [](std::string text, std::size_t width) {
    text.resize(std::max(text.size() + 1, width), ' ');
    return text;
  };
  const auto shown_number = [](const std::optional<double>& value) {
    return value ? rounded(*value) : std::string{"-"};
  };
  std::string model;
  for (const Comparison& c : all) {
    if (c.model != model)
      out << (model.empty() ? "" : "\n") << padded(c.model, 48) << padded("paper", 9) << padded("ours", 9)
          << padded("bar", 8) << "difference\n";
    model = c.model;
    const auto difference = c.difference();
    std::string last = difference ? joined_text({*difference > 0 ? "+" : "", rounded(*difference)}) : "-";
    if (difference && *c.paper != 0)
      last += joined_text({" (", *difference > 0 ? "+" : "", rounded(*difference / *c.paper * 100), " %)"});
    out << padded(c.quantity + (c.unit.empty() ? "" : ", " + c.unit), 48) << padded(shown_number(c.paper), 9)
        << padded(shown_number(c.ours), 9) << padded(c.bar ? "+-" + rounded(*c.bar) : "", 8)
        << (c.note.empty() ? last : padded(last, 18) + c.note) << '\n';
  }
}

}  // namespace arenite::ffp
