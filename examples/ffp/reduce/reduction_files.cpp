#include "reduction_files.hpp"

#include <cmath>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <arenite/io/output_file.hpp>

#include "../options/device_json.hpp"
#include "../text/words.hpp"

namespace arenite::ffp {

namespace {

constexpr const char *area_names[] = {"mantle", "projected"}, *form_names[] = {"log10", "asinh"};

/// "K0.2", or "Kair" for the one that goes with the impact velocity.
std::string name_of(const QuasiStatic& q) {
  return q.band.name == "air" ? "Kair" : joined_text({"K", rounded(q.k)});
}

Json json_of(const ColumnPeak& p) {
  return {{"largest_kPa", or_null(p.largest)},
          {"depth_m", or_null(p.depth)},
          {"at_peak_kPa", or_null(p.at_peak)}};
}

/// As text with blanks after it; columns count as bytes.
std::string padded(std::string text, std::size_t width) {
  text.resize(std::max(text.size() + 1, width), ' ');
  return text;
}

}  // namespace

void write_reduced_csv(const std::filesystem::path& path, const Reduction& r, const ReduceOptions& o) {
  const Motion& m = r.motion;
  const int area = o.area == Area::mantle ? 0 : 1;
  std::vector<std::pair<std::string, const Column*>> columns{{"time_s", &m.time},
                                                             {"depth_m", &m.depth},
                                                             {"velocity_m_s", &m.velocity},
                                                             {"deceleration_g", nullptr},
                                                             {"filtered_deceleration_g", nullptr},
                                                             {"q_dyn_mantle_kPa", &r.q_dyn[0]},
                                                             {"q_dyn_projected_kPa", &r.q_dyn[1]}};
  for (const int form : {0, 1})
    for (const QuasiStatic& q : r.quasi_static)
      columns.emplace_back(std::string{form == 0 ? "q_sbc_" : "q_sbc_asinh_"} + name_of(q) + "_kPa",
                           &q.columns[area][form]);
  Column in_g, filtered_in_g;
  for (std::size_t i = 0; i < m.time.size(); ++i) {
    in_g.push_back(m.deceleration[i] / r.gravity);
    filtered_in_g.push_back(m.filtered[i] / r.gravity);
  }
  columns[3].second = &in_g;
  columns[4].second = &filtered_in_g;
  arenite::shared_detail::replace_file(path, [&](std::ostream& out) {
    std::string line;
    for (const auto& [name, column] : columns) line += (line.empty() ? "" : ",") + name;
    out << line << '\n';
    for (std::size_t i = 0; i < m.time.size(); ++i) {
      line.clear();
      for (const auto& [name, column] : columns) {
        if (&name != &columns.front().first) line += ',';
        if (!std::isnan((*column)[i])) append_number(line, (*column)[i]);
      }
      out << line << '\n';
    }
  });
}

Json json_of(const Reduction& r, const ReduceOptions& o) {
  const Motion& m = r.motion;
  Json j;
  j["file"] = r.of_drop ? "history.csv" : o.file;  // the same wherever the folder lies
  j["notes"] = r.notes;
  j["warnings"] = r.warnings;
  j["settings"] = {{"tip", word_of(tip_words, r.device.tip)},
                   {"mass_kg", r.mass},
                   {"gravity_m_s2", r.gravity},
                   {"window_s", o.window},
                   {"medium", word_of(medium_words, o.medium)},
                   {"soil", word_of(soil_words, o.soil)},
                   {"area_of_q_sbc", word_of(area_words, o.area)},
                   {"from_depth_m", o.from_depth},
                   {"threshold_g", r.threshold},
                   {"unit_weight_N_m3", or_null(r.unit_weight)},
                   {"k0", r.k0},
                   {"taken_off_g", r.taken_off / r.gravity}};
  j["penetrometer"] = json_of(r.device, r.mass);
  if (o.medium == Medium::water) {
    j["settings"]["water_density_kg_m3"] = o.water_density;
    j["settings"]["volume_m3"] = o.lifted_volume(Device{r.device.shape()});
    j["settings"]["drag"] = or_null(o.drag);
  }
  j["impact_time_s"] = m.impact_time;
  j["impact_from"] = m.impact_from;
  j["impact_velocity_m_s"] = m.impact_velocity;
  j["impact_velocity_from"] = m.velocity_from;
  j["velocity_left_m_s"] = or_null(m.velocity_left);
  j["depth_cm"] = r.greatest_depth * 100;
  if (!r.of_drop) {
    j["drop"] = r.drop > 0 ? Json(r.drop) : Json();
    j["events"] = Json::array();
    for (const RecordEvent& event : r.events)
      j["events"].push_back({{"kind", event.kind},
                             {"drop", event.drop > 0 ? Json(event.drop) : Json()},
                             {"time_s", event.time},
                             {"velocity_m_s", or_null(event.velocity)},
                             {"depth_cm", event.depth ? Json(*event.depth * 100) : Json()},
                             {"peak_g", event.peak / r.gravity}});
    j["depth_of_sampling_cm"] = r.depth_of_sampling ? Json(*r.depth_of_sampling * 100) : Json();
    j["velocity_of_sampling_m_s"] = or_null(r.velocity_of_sampling);
    j["levels_g"] = {{"before_release", or_null(r.levels.before)},
                     {"fall", or_null(r.levels.fall)},
                     {"after_end", or_null(r.levels.after)}};
    j["depth_without_offset_cm"] = r.depth_without_offset ? Json(*r.depth_without_offset * 100) : Json();
  }
  j["penetration_time_s"] = or_null(m.stop);
  j["peak_deceleration_g"] = r.peak_g();
  j["peak_time_s"] = m.time[r.peak];
  j["peak_depth_cm"] = m.depth[r.peak] * 100;
  for (const int area : {0, 1}) j["q_dyn"][area_names[area]] = json_of(r.q_dyn_peaks[area]);
  j["q_sbc"] = Json::array();
  for (const QuasiStatic& q : r.quasi_static) {
    Json one{{"K", q.k},
             {"band", q.band.name},
             {"source", q.band.source},
             {"range", q.band.range},
             {"within_range", q.band.within}};
    for (const int area : {0, 1})
      for (const int form : {0, 1}) one[area_names[area]][form_names[form]] = json_of(q.peaks[area][form]);
    j["q_sbc"].push_back(std::move(one));
  }
  j["estimates"] = Json::array();
  for (const Estimate& e : r.estimates)
    j["estimates"].push_back({{"quantity", e.quantity},
                              {"value", or_null(e.value)},
                              {"unit", e.unit},
                              {"source", e.source},
                              {"range", e.range},
                              {"within_range", e.outside.empty()},
                              {"outside", e.outside}});
  return j;
}

void write_reduced_json(const std::filesystem::path& path, const Reduction& r, const ReduceOptions& o) {
  write_json(path, json_of(r, o));
}

void print_table(const Reduction& r, const ReduceOptions& o, std::ostream& out) {
  const Motion& m = r.motion;
  const auto row = [&](const std::string& name, const std::string& text) {
    out << padded(name, 34) << text << '\n';
  };
  const auto kpa = [](const std::optional<double>& value) {
    return value ? rounded(*value) : std::string{"-"};
  };
  row("penetrometer", text_of(r.device, r.mass));
  for (const std::string& note : r.notes) row("note", note);
  for (const std::string& warning : r.warnings) row("warning", warning);
  row("impact", joined_text({"at ", m.impact_time, " s of the record (", m.impact_from, "), ",
                             rounded(m.impact_velocity), " m/s (", m.velocity_from, ")"}));
  if (m.velocity_left)
    row("velocity left at rest", joined_text({rounded(*m.velocity_left), " m/s: what the integral misses"}));
  row("depth", joined_text({rounded(r.greatest_depth * 100), " cm",
                            m.stop ? joined_text({", reached in ", rounded(*m.stop * 1e3), " ms"})
                                   : std::string{"; the record ends before rest"}}));
  if (const std::string levels = text_of(r.levels); !levels.empty())
    row("levels", levels + " (net: 0, -1 and 0)" +
                      (r.taken_off != 0 ? "; taken off: " + rounded(r.taken_off / r.gravity) + " g" : ""));
  if (r.depth_without_offset && rounded(*r.depth_without_offset * 100) != rounded(r.greatest_depth * 100))
    row("depth, offset taken off", rounded(*r.depth_without_offset * 100) + " cm (--zero-at-rest)");
  row("peak deceleration",
      joined_text({rounded(r.peak_g()), " g at ", rounded(m.time[r.peak] * 1e3), " ms and ",
                   rounded(m.depth[r.peak] * 100), " cm",
                   o.window > 0 ? joined_text({" (mean over ", o.window * 1e3, " ms)"}) : ""}));
  out << '\n'
      << padded("kPa, largest below " + rounded(o.from_depth * 100) + " cm | at the peak", 40)
      << padded("by mantle", 20) << padded("by section", 20) << '\n';
  const auto resistance = [&](const std::string& name, const ColumnPeak& mantle, const ColumnPeak& projected,
                              const std::string& what) {
    out << padded(name, 40) << padded(kpa(mantle.largest) + " | " + kpa(mantle.at_peak), 20)
        << padded(kpa(projected.largest) + " | " + kpa(projected.at_peak), 20) << what << '\n';
  };
  resistance("q_dyn", r.q_dyn_peaks[0], r.q_dyn_peaks[1], "");
  for (const int form : {0, 1})
    for (const QuasiStatic& q : r.quasi_static)
      resistance(
          joined_text({form == 0 ? "q_sbc, K = " : "  by asinh, K = ", rounded(q.k)}), q.peaks[0][form],
          q.peaks[1][form],
          form == 1 ? "" : q.band.source + (q.band.within ? "" : "; outside the range: for " + q.band.range));
  out << '\n';
  for (const Estimate& e : r.estimates) {
    out << padded(e.quantity, 64)
        << padded(e.value ? rounded(*e.value) + " " + (e.unit == "1" ? "" : e.unit) : "none", 12) << e.source
        << '\n';
    if (!e.outside.empty())
      out << padded("", 6) << "outside the range (" << e.range << "): " << e.outside << '\n';
  }
}

}  // namespace arenite::ffp
