#include "results.hpp"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <utility>

#include <arenite/version.hpp>

#include "../text/words.hpp"

namespace arenite::ffp {

namespace {

/// Writes each option of a table under its keyword.
class InputLister {
 public:
  explicit InputLister(Json& to) : to_{to} {}

  void group(const char*) {}
  template <class Number>
  void number(const char* name, const Number& value, const char*, const Range&, std::string_view) {
    to_[keyword(name)] = value;
  }
  template <class Number>
  void number(const char* name, const std::optional<Number>& value, const char*, const Range&,
              std::string_view) {
    if (value) to_[keyword(name)] = *value;
  }
  template <class Words, class Value>
  void choice(const char* name, const Words& words, const Value& value, const char*) {
    to_[keyword(name)] = word_of(words, value);
  }
  void text(const char* name, const std::string& value, const char*, const char*) {
    if (!value.empty() && std::string_view{name} != "--out") to_[keyword(name)] = value;
  }
  void flag(const char*, bool, const char*) {}

 private:
  static std::string keyword(std::string_view name) {
    std::string text{name.substr(2)};
    std::ranges::replace(text, '-', '_');
    return text;
  }
  Json& to_;
};

/// "9.85 strengths", "197 kPa".
std::string net_text(const PushOptions& o, double pascal) {
  return o.in_clay() ? rounded(pascal / o.strength) + " strengths" : rounded(pascal / 1e3) + " kPa";
}

/// The resistance that theory gives: net of the vertical stress in clay, q_c in sand. Pa.
double compared(const PushOptions& o, const Resistance& r) {
  return 1e3 * (o.in_clay() ? r.net_kPa : r.q_c_kPa);
}

}  // namespace

Json inputs_of(const PushOptions& o) {
  Json j = Json::object();
  InputLister lister{j};
  visit_push_options(o, lister);
  j["start_depth"] = o.start_depth();
  j["distance"] = o.way();
  j["speed"] = o.push_speed();
  j["cell"] = o.cell_size();
  j["poisson"] = o.poisson_ratio();
  j["unit_weight"] = o.weight();
  j["k0"] = o.earth_pressure();
  j["flip_time"] = o.flip_time_constant();
  j["chamber_radius"] = o.chamber().radius;
  j["soil_depth"] = o.chamber().soil_depth;
  return j;
}

double inertia_share(const PushOptions& o, const Resistance& r) {
  return o.density() * o.push_speed() * o.push_speed() / (1e3 * r.q_c_kPa);
}

Json summary_of(const PushOptions& o, std::span<const PushRow> rows, const PushNumbers& run) {
  Json j;
  j["status"] = run.status;
  if (!run.failure.empty()) j["failure"] = run.failure;
  j["version"] = library_version;
  j["started"] = run.started;
  const auto found = resistance_of(rows, o.outer_diameter());
  if (found) {
    j["depth_m"] = found->depth_m;
    j["q_c_kPa"] = found->q_c_kPa;
    j["net_resistance_kPa"] = found->net_kPa;
    if (o.in_clay()) j["resistance_factor"] = 1e3 * found->net_kPa / o.strength;
    j["f_s_kPa"] = found->f_s_kPa;
    j["friction_ratio_percent"] = found->friction_ratio_percent;
    j["growth_per_diameter"] = found->growth;
    j["steady_from_m"] = or_null(found->steady_from_m);
    j["inertia_share"] = inertia_share(o, *found);
    j["closed_forms"] = Json::array();
    for (const ClosedForm& f : closed_forms(o, found->depth_m)) {
      Json& form = j["closed_forms"].emplace_back();
      form["name"] = f.name;
      form["source"] = f.source;
      form["kPa"] = f.value / 1e3;
      form["is_lower_guide"] = f.is_lower_guide;
      form["ratio"] = compared(o, *found) / f.value;
    }
  }
  if (!rows.empty()) {
    const PushRow& last = rows.back();
    j["pushed_m"] = last.pushed_m;
    const double in = last.external_work_J;
    j["energy_transfer"] = last.transfer_loss_J / in;
    j["energy_residual"] = last.energy_residual_J / in;
  }
  j["points"] = run.points;
  j["steps"] = run.steps;
  j["lost_points"] = run.lost_points;
  j["threads"] = run.threads;
  j["wall_s"] = run.wall_s;
  j["penetrometer"] = {
      {"name", o.device_name()}, {"diameter_m", o.outer_diameter()}, {"length_m", o.whole_length()}};
  j["device_outline_m"] = Json::array();
  for (const auto& x : o.body().outline()) j["device_outline_m"].push_back(Json::array({x[0], x[1]}));
  j["inputs"] = inputs_of(o);
  j["warnings"] = run.warnings;
  return j;
}

std::string sentence_of(const PushOptions& o, std::span<const PushRow> rows) {
  const auto r = resistance_of(rows, o.outer_diameter());
  if (!r) return "no resistance: less than a diameter was pushed";
  std::string text = joined_text({"q_c ", rounded(r->q_c_kPa), " kPa at ", rounded(r->depth_m), " m"});
  if (o.in_clay()) text += ", net " + net_text(o, 1e3 * r->net_kPa);
  if (std::isfinite(r->f_s_kPa))
    text += joined_text({", sleeve ", rounded(r->f_s_kPa), " kPa (friction ratio ",
                         rounded(r->friction_ratio_percent), " %)"});
  text += r->steady_from_m ? joined_text({"; steady from ", rounded(*r->steady_from_m), " m"})
                           : joined_text({"; not steady: it changes by ", rounded(100 * r->growth),
                                          " % a diameter, see --distance"});
  text += joined_text({"; inertia at most ", rounded(100 * inertia_share(o, *r)), " %"});
  for (const ClosedForm& f : closed_forms(o, r->depth_m)) {
    text += "; " + f.source + ": " + net_text(o, f.value);
    const double ratio = compared(o, *r) / f.value;
    text += f.is_lower_guide ? " (" + f.name + ")"
                             : joined_text({" (", ratio >= 1 ? "+" : "", rounded(100 * (ratio - 1)), " %)"});
  }
  return text;
}

}  // namespace arenite::ffp
