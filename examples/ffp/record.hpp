// Runs a scene of the drop and records it: a row of the history each step, fields at times, the summary at
// the end or when the run fails.
#pragma once

#include <chrono>
#include <filesystem>
#include <vector>

#include <arenite/observe/fill_ratio.hpp>
#include <arenite/observe/progress.hpp>
#include <arenite/observe/vtu.hpp>

#include "history.hpp"
#include "model.hpp"
#include "results.hpp"

namespace arenite::ffp {

/// What the history needs of the device at one step, as the scene has it (a slice's share).
struct DeviceState {
  double penetration, velocity;  ///< positive down, m, m/s
  double reaction;               ///< contact force up, N
  std::size_t contact_nodes;
  std::vector<Index> touched;  ///< nodes at which the sand pushes
};

template <class Scene>
DeviceState device_state(const Scene& scene) {
  DeviceState state{};
  if constexpr (Scene::rigid_count > 0) {
    const auto& body = std::get<0>(scene.rigids);
    state.penetration = 0 - body.displacement[1];
    state.velocity = -body.velocity[1];
    state.reaction = body.force[1];
    state.contact_nodes = body.contact_nodes;
    for (const auto& touch : body.touches)
      if (!touch.inside && body.impulse_at(touch, body.velocity).squaredNorm() > 0)
        state.touched.push_back(touch.node);
  } else {
    const auto& device = std::get<1>(scene.bodies);
    state.penetration = 0 - scene.motion.travel();
    state.velocity = -momentum(device)[1] / mass(device);
    state.reaction = scene.time_step > 0 ? scene.contact_impulse[1][1] / scene.time_step : 0;
    state.contact_nodes = scene.contact_tally.nodes;
    const auto& normals = scene.normals.out;
    for (Index i = 0; i < normals.size(); ++i)
      if (normals[i].squaredNorm() > 0 && scene.fields[0].mass[i] > 0) state.touched.push_back(i);
  }
  return state;
}

/// Observer that makes the rows of the history, writes them and keeps them for the summary.
class Recorder {
 public:
  Recorder(const std::filesystem::path& folder, double whole)
      : file_{folder / "history.csv"}, whole_{whole} {}

  template <class Scene>
  void operator()(const Scene& scene) {
    const DeviceState device = device_state(scene);
    const Energies e = energies(scene);
    const auto& soil = std::get<0>(scene.bodies);
    HistoryRow row;
    row.time_s = scene.time;
    row.penetration_m = device.penetration;
    row.velocity_m_s = device.velocity;
    row.acceleration_m_s2 = rows_.empty() ? -standard_gravity  // it still falls freely
                                          : (rows_.back().velocity_m_s - device.velocity) / scene.time_step;
    row.reaction_N = whole_ * device.reaction;
    row.time_step_s = scene.time_step;
    row.kinetic_energy_J = whole_ * e.kinetic;
    row.strain_energy_J = whole_ * e.strain;
    row.plastic_work_J = whole_ * e.plastic;
    row.contact_dissipation_J = whole_ * e.contact;
    row.external_work_J = whole_ * e.external;
    row.energy_residual_J = whole_ * e.residual;
    row.lost_points = static_cast<double>(scene.lost_points());
    row.contact_nodes = static_cast<double>(device.contact_nodes);
    row.fill_ratio = fill_ratio(scene, soil, device.touched, scene.mesh.region_number("device"));
    row.mean_volume_ratio = mean_volume_ratio(soil);
    file_.write(row);
    rows_.push_back(row);
  }

  const std::vector<HistoryRow>& rows() const { return rows_; }

 private:
  HistoryFile file_;
  double whole_;
  std::vector<HistoryRow> rows_;
};

/// Runs a scene to `o.end` and writes all files of the drop. The wall time is that of the steps, output
/// apart.
template <class Model, class Scene>
void record(Scene scene, const DropOptions& o) {
  using Clock = std::chrono::steady_clock;
  const std::filesystem::path folder = o.out;
  std::error_code code;
  std::filesystem::create_directories(folder, code);
  require(!code, "--out", o.out, "the folder cannot be made: " + code.message());
  Recorder recorder(folder, Model::whole);
  RunNumbers numbers;
  numbers.points = static_cast<long>(scene.point_count());
  numbers.threads = threads();
  const auto begin = Clock::now();
  Clock::duration watching{};
  const auto watch = [&](auto& observer) {
    return [&](const auto& s) {
      const auto from = Clock::now();
      observer(s);
      watching += Clock::now() - from;
    };
  };
  const auto count = [&](const auto& s) {
    numbers.steps = static_cast<long>(s.steps);
    if (s.steps > 0) numbers.point_steps += static_cast<double>(s.point_count());
  };
  const auto finish = [&] {
    numbers.wall_s = std::chrono::duration<double>(Clock::now() - begin - watching).count();
    numbers.lost_points = static_cast<long>(scene.lost_points());
    numbers.limited_velocities = static_cast<long>(scene.limited);
    write_summary(folder / "summary.json", summary_of(o, figures_of(recorder.rows()), numbers));
  };
  Progress progress(o.quiet ? -1 : o.end);
  const auto show = [&](const auto& s) {
    if (!o.quiet) progress(s);
  };
  try {
    const RunOptions options{.end = o.end, .courant = o.courant};
    if (o.fields_every > 0) {
      auto fields = every(o.fields_every,
                          vtu(folder / "fields",
                              {.body_names = {"soil", "device_points"}, .mesh = true, .region = "device"}));
      run(scene, options, watch(recorder), watch(fields), count, show);
    } else {
      run(scene, options, watch(recorder), count, show);
    }
  } catch (const run_error& e) {
    numbers.failure = e.what();
    finish();
    throw;
  }
  finish();
}

}  // namespace arenite::ffp
