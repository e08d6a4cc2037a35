// The scene of a push, and its run: the half-section of triangles that the driver's drops take, a penetrometer of prescribed speed.
#include <arenite/arenite.hpp>
#include <arenite/io/csv.hpp>
#include <arenite/observe/energy.hpp>
#include <arenite/observe/fill_ratio.hpp>
#include <arenite/run/progress.hpp>
#include <arenite/run/run_folder.hpp>
#include <arenite/run/run_status.hpp>
#include <arenite/run/stop_signals.hpp>
#include <arenite/watch/watch.hpp>

#include <chrono>
#include <cmath>
#include <iostream>
#include <limits>
#include <nlohmann/json.hpp>
#include <optional>
#include <vector>

#include "../drop/drop.hpp"
#include "../drop/drop_folder.hpp"
#include "../drop/field_files.hpp"
#include "../drop/summary_file.hpp"
#include "../options/gravity.hpp"
#include "../text/python_script.hpp"
#include "../text/say.hpp"
#include "../text/warnings.hpp"
#include "push.hpp"
#include "results.hpp"

namespace arenite::ffp {

namespace {

MohrCoulombParameters ground_of(const PushOptions& o, double density) {
  const double degree = pi / 180;
  const bool clay = o.in_clay();
  return {.density = density,
          .young = o.young_modulus(),
          .poisson = o.poisson_ratio(),
          .friction = clay ? 0 : o.friction * degree,
          .cohesion = clay ? o.strength : o.cohesion,
          .dilatancy = clay ? 0 : o.dilatancy * degree};
}

Friction friction_of(const PushOptions& o) {
  if (o.in_clay()) return o.roughness > 0 ? Friction::no_slip() : Friction(0);
  return Friction(o.delta * pi / 180);
}

MeshSurface surface_of_device(const PushOptions& o) {
  MeshSurface surface{"device"};
  if (o.in_clay()) surface.shear_strength = o.roughness * o.strength;
  return surface;
}

/// The uppermost half diameter of the ground is as heavy as what lies on it.
auto push_scene(const PushOptions& o) {
  Chamber chamber = o.chamber();
  const double lid = chamber.lid = o.outer_diameter() / 2, top = chamber.embedded;
  const MeshSizes sizes = o.mesh_sizes();
  const double speed = o.push_speed(), ramp = o.ramp() / speed;
  const auto part = [&](const auto& density, const Geostatic& stress) {
    return std::pair{MohrCoulomb{ground_of(o, density)},
                     FillOptions{.per_cell = o.points_per_element, .stress = stress}};
  };
  const auto [ground, in_ground] = part(
      o.density(), {.surface = top - lid, .k0 = o.earth_pressure(), .surcharge = o.vertical_stress(lid)});
  const auto [load, in_load] =
      part(o.vertical_stress(lid) / (standard_gravity * lid), {.surface = top, .k0 = o.earth_pressure()});
  return Scene{
      Axisymmetric{},
      SimplexMesh<2>(mesh_axisymmetric(o.body(), chamber, sizes).data),
      Numerics<LinearSimplex, Flip, Musl, NodalAndElementAverage>{
          .transfer = {.time = o.flip_time_constant()}},
      bodies(fill<"soil">(Cells("soil"), ground, in_ground), fill<"lid">(Cells("lid"), load, in_load)),
      walls(on("bottom", fixed), on("wall", free_along(1))),
      gravity({0, -standard_gravity}),
      rigids(rigid<"device">(surface_of_device(o), Prescribed([=](double t) {
                               return std::array<double, 3>{0, -speed * std::min(1.0, t / ramp), 0};
                             }),
                             friction_of(o), RigidVelocity{})),
      MovingMesh<LedByRigid<"device">>{
          .leader = {}, .fixed_below = -chamber.soil_depth, .moving_from = -sizes.moving_depth},
      TrackEnergy{}};
}

/// Impulses of the ground on the penetrometer, N s, up.
struct Impulses {
  double all = 0, tip = 0, sleeve = 0;
};

/// One run in its folder.
template <class Scene>
class PushRun {
 public:
  PushRun(Scene& scene, const PushOptions& o, WarningLog& warnings)
      : scene_{scene},
        o_{o},
        warnings_{warnings},
        folder_{folder_of_run("push", o.out, RunFolder::Earlier::removed)},
        end_{(o.way() + o.ramp() / 2) / o.push_speed()},
        progress_{end_, {.tenths = true}},
        tip_end_{o.body().tip_end() + 1e-9} {
    numbers_.started = utc_now();
    numbers_.points = static_cast<long>(scene.point_count());
    numbers_.threads = threads();
    if (!o.no_watch) watch_.emplace(WatchLimits{.energy_gain = 0.1});
  }

  void go() {
    begin_ = Clock::now();
    try {
      write_summary();
      std::vector<std::string> names;
      for (const auto& [name, member] : push_columns) names.emplace_back(name);
      history_.emplace(folder_.path() / "history.csv", names);
      if (o_.fields_every > 0)
        fields_.emplace(field_files(folder_.path(), o_.fields_every / o_.push_speed(), false));
      arenite::run(scene_, {.end = end_, .courant = o_.courant}, *this);
      numbers_.status = "done";
      write_summary();
    } catch (const Interruption& e) {
      end("interrupted", e.what(), e.exit_code());
    } catch (const output_error& e) {
      end(e.disk_full() ? "disk-full" : "failed", e.what(), 1);
    } catch (const std::exception& e) {
      end("failed", e.what(), 1);
    }
  }
  const std::vector<PushRow>& rows() const { return rows_; }
  const RunFolder& folder() const { return folder_; }

  void operator()(const Scene& scene) {
    if (scene.steps > 0) take(scene);
    if (fields_) (*fields_)(scene);
    if (!o_.quiet) progress_(scene);
    if (watch_) (*watch_)(scene);
    if (scene.time < end_) signals_.check();
  }
  void finish(const Scene& scene) {
    if (watch_) watch_->finish(scene);
  }

 private:
  using Clock = std::chrono::steady_clock;

  void take(const Scene& scene) {
    const auto& device = scene.template rigid<"device">();
    const double pushed = -device.displacement[1], d = o_.outer_diameter();
    // The sleeve: the mantle above the tip that has passed through ground, at most that of a standard cone, 150 cm2 on 10 cm2.
    const double sleeve = pushed < d ? 0 : std::min(pushed, 3.75 * d);
    for (const auto& touch : device.touched_nodes) {
      if (touch.inside) continue;
      const double up = -device.impulse_at(touch, device.velocity)[1];
      const double y = scene.mesh.position(touch.node)[1] + pushed;
      taken_.all += up;
      if (y <= tip_end_)
        taken_.tip += up;
      else if (y <= tip_end_ + sleeve)
        taken_.sleeve += up;
    }
    duration_ += scene.time_step;
    // One row at each twentieth of a diameter that the step reaches, and one at the end.
    const bool is_last = scene.time >= end_;
    if (pushed < next_ && !is_last) return;
    while (next_ <= pushed) next_ += d / 20;
    rows_.push_back(row(scene, pushed, sleeve));
    std::array<std::optional<double>, push_columns.size()> values{};
    for (std::size_t i = 0; i < push_columns.size(); ++i)
      if (const double value = rows_.back().*push_columns[i].second; !std::isnan(value)) values[i] = value;
    history_->row(values);
    taken_ = {};
    duration_ = 0;
  }

  PushRow row(const Scene& scene, double pushed, double sleeve) const {
    const auto& device = scene.template rigid<"device">();
    const double d = o_.outer_diameter(), nan = std::numeric_limits<double>::quiet_NaN();
    const Energies e = energies(scene);
    std::vector<Index> touched;
    for (const auto& touch : device.touched_nodes)
      if (!touch.inside && device.impulse_at(touch, device.velocity).squaredNorm() > 0)
        touched.push_back(touch.node);
    PushRow row;
    row.time_s = scene.time;
    row.pushed_m = pushed;
    row.depth_m = o_.start_depth() + pushed;
    row.force_N = taken_.all / duration_;
    row.q_c_kPa = taken_.tip / duration_ / (pi * d * d / 4) / 1e3;
    row.f_s_kPa = sleeve > 0 ? taken_.sleeve / duration_ / (pi * d * sleeve) / 1e3 : nan;
    row.friction_ratio_percent = 100 * row.f_s_kPa / row.q_c_kPa;
    row.vertical_stress_kPa = o_.vertical_stress(row.depth_m) / 1e3;
    row.kinetic_energy_J = e.kinetic;
    row.plastic_work_J = e.plastic;
    row.contact_dissipation_J = e.contact;
    row.external_work_J = e.external;
    row.transfer_loss_J = e.transfer;
    row.energy_residual_J = e.residual;
    row.lost_points = static_cast<double>(scene.lost_points());
    row.fill_ratio =
        fill_ratio(scene, scene.template body<"soil">(), touched, scene.mesh.region_number("device"));
    row.mean_volume_ratio = mean_volume_ratio(scene.template body<"soil">());
    return row;
  }

  void write_summary() {
    numbers_.steps = static_cast<long>(scene_.steps);
    numbers_.lost_points = static_cast<long>(scene_.lost_points());
    numbers_.wall_s = std::chrono::duration<double>(Clock::now() - begin_).count();
    numbers_.warnings = warnings_.texts();
    write_json(summary_file(folder_.path()), summary_of(o_, rows_, numbers_));
  }

  [[noreturn]] void end(const std::string& status, const std::string& failure, int exit_code) {
    numbers_.status = status;
    numbers_.failure = failure;
    std::string told = (status == "failed" ? "the push failed: " : "") + failure;
    folder_.free_reserve();
    try {
      write_summary();
      told += "; files: " + shown(o_.out);
    } catch (const error& e) {
      told += joined_text({"; nor can the summary be written: ", e.what()});
    }
    throw Ended(told, exit_code);
  }

  Scene& scene_;
  const PushOptions& o_;
  WarningLog& warnings_;
  RunFolder folder_;
  double end_;  ///< s
  StopSignals signals_;
  Progress progress_;
  double tip_end_;  ///< m above the tip
  std::optional<Watch> watch_;
  std::optional<CsvWriter> history_;
  std::optional<Every<FieldFiles>> fields_;
  std::vector<PushRow> rows_;
  PushNumbers numbers_;
  Impulses taken_;  ///< since the last row
  double duration_ = 0, next_ = o_.outer_diameter() / 20;
  Clock::time_point begin_{};
};

void run_push(const PushOptions& o) {
  set_threads(o.threads);
  WarningLog warnings(!o.is_companion);
  auto scene = [&] {
    try {
      return push_scene(o);
    } catch (const std::bad_alloc&) {
      throw error(joined_text({"--cell = ", o.cell_size(), ": there is no memory for cells of this size"}));
    }
  }();
  PushRun run(scene, o, warnings);
  if (!o.quiet)
    say(joined_text({"about ",
                     rounded((o.way() + o.ramp() / 2) / o.push_speed() / (o.courant * stable_step(scene))),
                     " steps, ", scene.point_count(), " points"}));
  run.go();
  if (!o.quiet) std::cout << sentence_of(o, run.rows()) << std::endl;
  if (!o.no_picture && !o.is_companion) run_script("plot_push.py", {run.folder().path().string()});
}

const PushUnit unit(run_push);

}  // namespace

}  // namespace arenite::ffp
