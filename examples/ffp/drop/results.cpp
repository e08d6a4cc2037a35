#include "results.hpp"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include <arenite/core/hash.hpp>
#include <arenite/io/mesh_input.hpp>
#include <arenite/version.hpp>

#include "../options/device_json.hpp"
#include "../text/words.hpp"
#include "peaks.hpp"
#include "summary_file.hpp"

namespace arenite::ffp {

DropFigures figures_of(const std::vector<HistoryRow>& history, double window) {
  require(!history.empty(), "figures_of.history", history.size(), "needs at least one row");
  std::vector<double> time, deceleration, reaction;
  for (const auto& row : history) {
    time.push_back(row.time_s);
    deceleration.push_back(row.acceleration_m_s2 / standard_gravity);
    reaction.push_back(row.reaction_N);
  }
  const auto filtered = moving_average(time, deceleration, window);
  const auto peak_at = [&](const std::vector<double>& values, std::size_t i) {
    return Peak{values[i], history[i].time_s, history[i].penetration_m};
  };
  DropFigures f;
  const Peaks peaks = find_peaks(filtered);
  f.peak = peak_at(filtered, peaks.first);
  if (peaks.second) f.second = peak_at(filtered, *peaks.second);
  const auto mean_reaction = moving_average(time, reaction, window);
  f.peak_reaction_N = *std::max_element(mean_reaction.begin(), mean_reaction.end());
  f.end_s = time.back();
  f.raw_peak = peak_at(deceleration, find_peaks(deceleration).first);
  f.final_penetration_m = history.back().penetration_m;
  f.final_tilt_deg = history.back().tilt_deg;
  f.final_aside_m = history.back().aside_m;
  const auto deepest = std::max_element(
      history.begin(), history.end(),
      [](const HistoryRow& a, const HistoryRow& b) { return a.penetration_m < b.penetration_m; });
  f.max_penetration_m = deepest->penetration_m;
  f.max_penetration_time_s = deepest->time_s;
  if (history.size() > 1) {
    f.dt_min_s = std::numeric_limits<double>::infinity();
    for (std::size_t i = 1; i < history.size(); ++i) {
      f.dt_min_s = std::min(f.dt_min_s, time[i] - time[i - 1]);
      f.dt_max_s = std::max(f.dt_max_s, time[i] - time[i - 1]);
    }
  }
  const double put_in = history.front().kinetic_energy_J + std::abs(history.back().external_work_J);
  const auto share = [&](double energy) { return put_in > 0 ? energy / put_in : 0; };
  f.energy_transfer = share(history.back().transfer_loss_J);
  f.energy_walls = share(history.back().wall_loss_J);
  f.energy_residual = share(history.back().energy_residual_J);
  return f;
}

std::string sentence_of(const DropFigures& f, const DropOptions& o) {
  const std::string tilted =
      o.in_space() ? joined_text({", tilted by ", rounded(f.final_tilt_deg), " deg and ",
                                  rounded(f.final_aside_m), " m to the side that it pointed to"})
                   : std::string{};
  return joined_text({"The penetrometer (",
                      o.device_name(),
                      ") stands at ",
                      rounded(f.final_penetration_m),
                      " m at ",
                      rounded(f.end_s * 1e3),
                      " ms",
                      tilted,
                      " (deepest: ",
                      rounded(f.max_penetration_m),
                      " m at ",
                      rounded(f.max_penetration_time_s * 1e3),
                      " ms); its deceleration peaked at ",
                      rounded(f.peak.value_g),
                      " g at ",
                      rounded(f.peak.time_s * 1e3),
                      " ms and ",
                      rounded(f.peak.penetration_m),
                      " m. Files: ",
                      shown(o.out)});
}

Json inputs_of(const DropOptions& o) {
  Json j;
  j["kinematics"] = word_of(kinematics_words, o.kinematics);
  j["device"] = word_of(device_words, o.device);
  j["velocity_m_s"] = o.velocity;
  if (o.in_space()) {
    j["tilt_deg"] = o.tilt;
    j["centre_of_mass_m"] = o.centre_height();
    j["gyration_m"] = o.gyration_radius();
  }
  j["tip"] = word_of(tip_words, o.tip);
  if (o.profile) {
    j["device_profile"] = json_of(*o.profile);
  } else if (!o.is_bluedrop()) {
    j["penetrometer"] = word_of(penetrometer_words, o.penetrometer);
    if (o.diameter) j["diameter_m"] = *o.diameter;
    if (o.length) j["length_m"] = *o.length;
    if (o.cone_angle) j["cone_angle_deg"] = *o.cone_angle;
    if (o.flat) j["flat_m"] = *o.flat;
  }
  if (o.chamber_radius) j["chamber_radius_m"] = *o.chamber_radius;
  if (o.soil_depth) j["soil_depth_m"] = *o.soil_depth;
  j["mass_kg"] = o.device_mass();
  j["shoulder"] = word_of(shoulder_words, o.shoulder);
  j["fillet_m"] = o.fillet_radius();
  j["device_young_Pa"] = o.device_young;
  j["device_poisson"] = o.device_poisson;
  j["delta_deg"] = o.delta;
  j["no_slip"] = o.no_slip;
  j["friction_deg"] = o.friction;
  j["dilatancy_deg"] = o.dilatancy;
  j["cohesion_Pa"] = o.cohesion;
  j["young_Pa"] = o.young;
  j["poisson"] = o.poisson;
  j["unit_weight_N_m3"] = o.unit_weight;
  add_inputs(o.law, j);
  j["k0"] = o.earth_pressure();
  j["gravity_m_s2"] = standard_gravity;
  j["contact"] = word_of(contact_words, o.contact_kind());
  j["contact_offset_m"] = o.contact_offset;
  j["mesh_kind"] = word_of(mesh_kind_words, o.kind_of_mesh());
  j["cell_m"] = o.cell_size();
  if (o.cell_at_cone) j["cell_at_cone_m"] = *o.cell_at_cone;
  if (o.split_share() > 0) j["split"] = o.split_share();
  j["points_per_element"] = o.points_in_element();
  if (o.jitter > 0) {
    j["jitter"] = o.jitter;
    j["jitter_seed"] = o.jitter_seed;
  }
  j["moving_depth_m"] = o.moving_zone();
  j["mesh"] = o.mesh.empty() ? "generated" : o.mesh;
  j["anti_locking"] = word_of(switch_words, o.averages());
  j["flip"] = o.flip;
  j["flip_time_s"] = o.flip_time_constant();
  j["courant"] = o.courant_number();
  j["end_s"] = o.end;
  j["fields_every_s"] = o.fields_every;
  return j;
}

std::vector<std::pair<std::string, std::string>> told_of(const DropOptions& o) {
  Json all = inputs_of(o);
  all["--out"] = o.out;
  all["--resume"] = o.resume;
  all["--checkpoint-every"] = o.checkpoint_every;
  all["--watch-energy"] = o.watch_energy;
  all["--watch-volume"] = o.watch_volume;
  all["--watch-lost"] = o.watch_lost;
  all["--no-watch"] = o.no_watch;
  std::vector<std::pair<std::string, std::string>> told;
  for (const auto& [name, value] : all.items()) told.emplace_back(name, json_text(value));
  return told;
}

std::string hash_of_inputs(const DropOptions& o) {
  Hash hash;
  const std::string inputs = json_text(inputs_of(o));
  hash.add(inputs.data(), inputs.size());
  if (!o.mesh.empty()) {
    const std::string content = arenite::shared_detail::read_all(o.mesh);
    hash.add(content.data(), content.size());
  }
  return hash.digits();
}

Json summary_of(const DropOptions& options, const std::optional<DropFigures>& figures,
                const RunNumbers& run) {
  Json j;
  j["status"] = run.status;
  if (!run.failure.empty()) j["failure"] = run.failure;
  j["version"] = library_version;
  j["started"] = run.started;
  j["process_id"] = run.process;
  if (!run.resumed_at_s.empty()) j["resumed_at_s"] = run.resumed_at_s;
  j["inputs_hash"] = hash_of_inputs(options);
  if (figures) {
    const DropFigures& f = *figures;
    j["final_penetration_m"] = f.final_penetration_m;
    if (options.in_space()) {
      j["final_tilt_deg"] = f.final_tilt_deg;
      j["final_aside_m"] = f.final_aside_m;
    }
    j["max_penetration_m"] = f.max_penetration_m;
    j["max_penetration_time_s"] = f.max_penetration_time_s;
    j["peak_filter"] = "centred moving average over 2 ms";
    j["peak_deceleration_g"] = f.peak.value_g;
    j["peak_time_s"] = f.peak.time_s;
    j["peak_penetration_m"] = f.peak.penetration_m;
    j["second_peak_deceleration_g"] = f.second.value_g;
    j["second_peak_time_s"] = f.second.time_s;
    j["second_peak_penetration_m"] = f.second.penetration_m;
    j["raw_peak_deceleration_g"] = f.raw_peak.value_g;
    j["raw_peak_time_s"] = f.raw_peak.time_s;
    j["raw_peak_penetration_m"] = f.raw_peak.penetration_m;
    j["peak_reaction_N"] = f.peak_reaction_N;
    j["end_s"] = f.end_s;
    j["steps"] = run.steps;
    j["dt_min_s"] = f.dt_min_s;
    j["dt_max_s"] = f.dt_max_s;
    j["wall_s"] = run.wall_s;
    j["point_steps_per_s"] = run.wall_s > 0 ? run.point_steps / run.wall_s : 0;
    j["lost_points"] = run.lost_points;
    j["limited_velocities"] = run.limited_velocities;
    j["energy_transfer"] = f.energy_transfer;
    j["energy_walls"] = f.energy_walls;
    j["energy_residual"] = f.energy_residual;
  }
  j["points"] = run.points;
  j["expected_steps"] = run.expected_steps;
  j["threads"] = run.threads;
  j["register_bytes"] = run.register_bytes;
  j["penetrometer"] = json_of(static_cast<const DeviceOptions&>(options), options.device_mass());
  j["chamber"] = {{"radius_m", options.chamber().radius}, {"soil_depth_m", options.chamber().soil_depth}};
  j["device_outline_m"] = Json::array();  // (r, y) at t = 0, for pictures
  for (const auto& x : options.body().instrument().outline())
    j["device_outline_m"].push_back(Json::array({x[0], x[1]}));
  j["inputs"] = inputs_of(options);
  if (run.deepest_point_m) j["deepest_point_m"] = *run.deepest_point_m;
  if (run.warnings) j["warnings"] = *run.warnings;
  if (run.watch) {
    Json& watch = j["watch"];
    for (const WatchedLimit& w : *run.watch) {
      watch[w.name] = {{"worst", w.worst}, {"time_s", w.time_s}, {"limit", w.limit}};
      if (!w.place_m.empty()) watch[w.name]["place_m"] = w.place_m;
    }
  }
  return j;
}

void write_summary(const std::filesystem::path& folder, const DropOptions& options,
                   const std::optional<DropFigures>& figures, const RunNumbers& run) {
  write_json(summary_file(folder), summary_of(options, figures, run));
}

}  // namespace arenite::ffp
