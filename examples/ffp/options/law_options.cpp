#include "law_options.hpp"

#include <nlohmann/json.hpp>

#include <arenite/core/error.hpp>

namespace arenite::ffp {

void check(const LawOptions& o, double friction, double dilatancy) {
  if (!o.softens()) return;
  require(o.residual.has_value(), "--residual-friction", "(none)", "must be given with this --law");
  require(*o.residual <= friction, "--residual-friction", *o.residual,
          {"must not exceed --friction = ", friction, " deg"});
  require(o.residual_dilatancy <= dilatancy, "--residual-dilatancy", o.residual_dilatancy,
          {"must not exceed --dilatancy = ", dilatancy, " deg"});
  require(o.residual_dilatancy <= *o.residual, "--residual-dilatancy", o.residual_dilatancy,
          {"must not exceed --residual-friction = ", *o.residual, " deg"});
}

void add_inputs(const LawOptions& o, nlohmann::ordered_json& j) {
  j["law"] = std::string{[&] {
    for (const auto& [word, kind] : law_words)
      if (kind == o.kind) return word;
    throw error("LawOptions.kind: no law has this number");
  }()};
  if (o.kind == LawKind::linear_rate) j["rate_time_s"] = o.rate_time;
  if (o.kind == LawKind::mu_i) {
    j["mu_rise"] = o.mu_rise;
    j["mu_inertia"] = o.mu_inertia;
    j["grain_size_m"] = o.grain_size;
    j["grain_density_kg_m3"] = o.grain_density;
  }
  if (o.grows_by_decade()) {
    j["per_decade"] = o.per_decade;
    j["reference_rate_1_s"] = o.reference_rate;
  }
  if (o.softens()) {
    if (o.kind == LawKind::softening_rate) j["dilatancy_per_decade"] = o.dilatancy_per_decade;
    j["residual_friction_deg"] = *o.residual;
    j["residual_dilatancy_deg"] = o.residual_dilatancy;
    j["decay"] = o.decay;
    if (o.decay_cell) j["decay_cell_m"] = *o.decay_cell;
  }
  if (o.kind != LawKind::mohr_coulomb && o.kind != LawKind::softening)
    j["rate_smoothing_s"] = o.rate_smoothing;
}

}  // namespace arenite::ffp
