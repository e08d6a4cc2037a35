// Runs a scene of the drop and records it: a row of the history each step, fields at times, and the summary
// from the start to whatever end the run takes.
#pragma once

#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <functional>
#include <iostream>
#include <new>
#include <optional>
#include <string>
#include <vector>

#include <arenite/run/every.hpp>
#include <arenite/run/progress.hpp>
#include <arenite/run/run_status.hpp>
#include <arenite/run/saved_state.hpp>
#include <arenite/run/stop_signals.hpp>
#include <arenite/watch/watch.hpp>

#include "../text/say.hpp"
#include "../text/warnings.hpp"
#include "../text/words.hpp"
#include "drop.hpp"
#include "drop_folder.hpp"
#include "earlier_run.hpp"
#include "field_files.hpp"
#include "history_row.hpp"
#include "results.hpp"
#include "step_count.hpp"

namespace arenite::ffp {

/// The worst that a watch saw, one for each of its limits.
inline std::vector<WatchedLimit> seen_by(const Watch& watch) {
  std::vector<WatchedLimit> all;
  for (const Watched& w : watch.seen()) {
    auto& limit = all.emplace_back(WatchedLimit{std::string{w.name}, w.worst, w.time, w.limit});
    for (const double x : w.place)
      if (std::isfinite(x)) limit.place_m.push_back(x);
  }
  return all;
}

/// One run in its folder, and the observer that writes it down.
template <class Model, class Scene>
class Run {
 public:
  /// Takes the folder; throws `error` if it cannot.
  Run(Scene& scene, const DropOptions& options, const ExpectedSteps& expected, WarningLog& warnings,
      RunFolder::Earlier earlier)
      : scene_{scene},
        o_{options},
        warnings_{warnings},
        folder_{drop_folder(options.out, earlier)},
        progress_{options.end, {.tenths = true}} {
    if (earlier == RunFolder::Earlier::removed) remove_saved_tiles(folder_.path());
    numbers_.started = utc_now();
    numbers_.process = ::getpid();
    numbers_.points = static_cast<long>(scene.point_count());
    numbers_.expected_steps = static_cast<long>(std::min(expected.count, 1e18));
    numbers_.threads = threads();
    numbers_.register_bytes = native_register_bytes;
    if (!o_.no_watch)
      watch_.emplace(
          WatchLimits{.energy_gain = o_.watch_energy, .volume = o_.watch_volume, .lost = o_.watch_lost});
    if (o_.checkpoint_every > 0) due_state_ = every(o_.checkpoint_every, [this](const Scene&) { save(); });
  }

  /// Goes on from the state that an earlier run of the folder saved. Throws `error` if it cannot be used; the
  /// folder is then as it was.
  void resume(EarlierRun earlier) {
    open_fields(true);
    restore_state(scene_, state_file(), *this);
    warnings_.add_earlier(std::move(earlier.warnings));
    numbers_.started = earlier.started;
    numbers_.resumed_at_s = std::move(earlier.resumed_at_s);
    numbers_.resumed_at_s.push_back(scene_.time);
    wall_before_ = earlier.wall_s;
    if (!o_.quiet) say(joined_text({"resumed at t = ", scene_.time, " s, step ", scene_.steps}));
  }

  /// Its state between steps: the rows so far, and the state of its observers.
  template <class F>
  void visit_state(F&& f) {
    f("history", rows_);
    f("point_steps", numbers_.point_steps);
    if (watch_) watch_->visit_state(StateUnder(f, "watch"));
    if (fields_) fields_->visit_state(StateUnder(f, "fields"));
  }
  void follow_state(const Scene& scene) {
    if (fields_) fields_->follow_state(scene);
  }

  /// Runs to `o.end` and writes all files. Throws `Ended` if another end comes first; the files are then
  /// those of the run until there.
  void go() {
    begin_ = Clock::now();
    try {
      write_summary("running");
      history_.emplace(folder_.path() / "history.csv", o_.in_space());
      for (const HistoryRow& row : rows_.all) history_->write(row);
      open_fields();
      writing_ += Clock::now() - begin_;
      arenite::run(scene_, {.end = o_.end, .courant = o_.courant_number()}, *this);
      write_summary("done");
      remove_state_file(folder_.path());
    } catch (const Interruption& e) {
      end("interrupted", at_time(e.what()), e.exit_code());
    } catch (const run_error& e) {  // gives the time itself
      end("failed", e.what() + (is_at_the_bottom() ? cure_of_depth() : ""), 1);
    } catch (const output_error& e) {
      end(e.disk_full() ? "disk-full" : "failed", at_time(e.what()), 1);
    } catch (const std::exception& e) {
      end("failed", at_time(e.what()), 1);
    }
    if (!o_.quiet) std::cout << sentence_of(figures_of(rows_.all), o_) << std::endl;
  }

  /// Takes a step down, and stops the run if there is reason.
  void operator()(const Scene& scene) {
    if (scene.steps < rows_.all.size()) return;  // taken down before its state was saved
    const auto from = Clock::now();
    HistoryRow row =
        history_row(scene, rows_.all.empty() ? nullptr : &rows_.all.back(), start_, Model::whole);
    history_->write(row);
    rows_.all.push_back(row);  // so that the summary is that of the file
    if (fields_) (*fields_)(scene);
    if (scene.steps > 0) numbers_.point_steps += static_cast<double>(scene.point_count());
    if (!o_.quiet) {
      tell_pace(scene);
      progress_(scene);
    }
    stop_if([&] {
      if (watch_) (*watch_)(scene);
    });
    if (scene.time < o_.end) {
      if (signals_.has_come())
        save();
      else if (due_state_)
        due_state_(scene);
      stop_if([&] { signals_.check(); });
    }
    writing_ += Clock::now() - from;
  }
  void finish(const Scene& scene) {
    stop_if([&] {
      if (watch_) watch_->finish(scene);
    });
  }

 private:
  using Clock = std::chrono::steady_clock;
  static double seconds(Clock::duration d) { return std::chrono::duration<double>(d).count(); }

  /// Calls a check. If it throws, the fields of this step are written, for they show why.
  template <class Check>
  void stop_if(Check&& check) {
    try {
      check();
    } catch (...) {
      if (fields_) fields_->called()(scene_);
      throw;
    }
  }

  void open_fields(bool resumed = false) {
    if (o_.fields_every > 0 && !fields_)
      fields_.emplace(field_files(folder_.path(), o_.fields_every, resumed));
  }

  SavedState state_file() const { return {folder_.path() / state_file_name, hash_of_inputs(o_)}; }
  /// Saves the state of this step, and in the summary how the run stands.
  void save() {
    write_summary("running");
    save_state(scene_, state_file(), *this);
  }

  /// Says how long the run will take, once some steps have shown it; the first ones take longer than the
  /// rest.
  void tell_pace(const Scene& scene) {
    constexpr std::size_t first = 5, last = 25;
    if (scene.steps == first) pace_from_ = Clock::now();
    if (scene.steps != last || pace_from_ == Clock::time_point{}) return;  // resumed on the way
    const double step = seconds(Clock::now() - pace_from_) / (last - first);
    say("about " + duration(step * static_cast<double>(numbers_.expected_steps)) +
        " at the pace of the first steps");
  }

  /// Whether hardly anything is left of the zone that the moving mesh compresses.
  bool is_at_the_bottom() const {
    return o_.mesh.empty() && !rows_.all.empty() &&
           rows_.all.back().penetration_m > 0.9 * (o_.chamber().soil_depth - o_.moving_zone());
  }
  std::string cure_of_depth() const {
    return joined_text({"; the sand is ", o_.chamber().soil_depth, " m deep: give more --soil-depth"});
  }

  std::string at_time(const std::string& what) const {
    return joined_text({"t = ", scene_.time, " s: ", what});
  }

  void write_summary(const std::string& status) {
    numbers_.status = status;
    std::optional<DropFigures> figures;
    if (!rows_.all.empty()) {
      figures = figures_of(rows_.all);
      numbers_.steps = static_cast<long>(rows_.all.size()) - 1;
      numbers_.wall_s = wall_before_ + seconds(Clock::now() - begin_ - writing_);
    }
    numbers_.lost_points = static_cast<long>(scene_.lost_points());
    numbers_.limited_velocities = static_cast<long>(scene_.limited);
    scene_.for_each_rigid([&](const auto& device) {
      if constexpr (requires { device.at_points.deepest; })
        numbers_.deepest_point_m = device.at_points.deepest;
    });
    numbers_.warnings = warnings_.texts();
    if (watch_) numbers_.watch = seen_by(*watch_);
    ffp::write_summary(folder_.path(), o_, figures, numbers_);
  }

  /// The end before the end: the summary says what happened, and so does `Ended`.
  [[noreturn]] void end(const std::string& status, const std::string& failure, int exit_code) {
    numbers_.failure = failure;
    std::string told = (status == "failed" ? "the run failed: " : "") + failure;
    folder_.free_reserve();
    try {
      write_summary(status);
      told += "; files: " + shown(o_.out);
    } catch (const error& e) {
      told += joined_text({"; nor can the summary be written: ", e.what()});
    }
    throw Ended(told, exit_code);
  }

  Scene& scene_;
  const DropOptions& o_;
  const DeviceStart start_ = o_.start();
  WarningLog& warnings_;
  RunFolder folder_;
  StopSignals signals_;
  Progress progress_;
  std::optional<Watch> watch_;
  std::optional<HistoryFile> history_;
  std::optional<Every<FieldFiles>> fields_;
  std::function<void(const Scene&)> due_state_;
  HistoryRows rows_;
  RunNumbers numbers_;
  Clock::time_point begin_{}, pace_from_{};
  Clock::duration writing_{};  ///< time of the output
  double wall_before_ = 0;     ///< of the steps before it was resumed, s
};

/// Makes a scene and runs it. `make()` returns the scene; what it throws about a mesh that was read names its
/// file.
template <class Model, class Make>
void record(const DropOptions& o, const Make& make) {
  EarlierRun earlier;
  if (o.resume) earlier = earlier_run(o);
  if (earlier.finished) {
    remove_state_file(o.out);  // of a run that was killed as it ended
    if (!o.quiet) say(joined_text({"the run in ", shown(o.out), " is finished; nothing to do"}));
    return;
  }
  WarningLog warnings(!o.is_companion);
  auto scene = [&] {
    try {
      return make();
    } catch (const error& e) {
      if (o.mesh.empty()) throw;
      throw error(joined_text({"--mesh = ", shown(o.mesh), ": ", e.what()}));
    } catch (const std::bad_alloc&) {
      require(o.mesh.empty(), "--mesh", shown(o.mesh), "there is no memory for a mesh of this size");
      throw error(joined_text({"--cell = ", o.cell_size(), ": there is no memory for cells of this size"}));
    }
  }();
  const ExpectedSteps expected = accepted_steps(scene, o);
  const bool resumed = earlier.has_state;
  Run<Model, decltype(scene)> run(scene, o, expected, warnings,
                                  resumed ? RunFolder::Earlier::kept : RunFolder::Earlier::removed);
  if (!o.quiet)
    say(joined_text({"about ", rounded(expected.count), " steps of ", rounded(expected.length), " s, ",
                     scene.point_count(), " points"}));
  if (resumed)
    run.resume(std::move(earlier));
  else if (o.resume && !o.quiet)
    say(joined_text({"no state is saved in ", shown(o.out), ": from the start"}));
  if (!resumed && !o.is_companion && o.cell && o.cell_size() > o.outer_diameter() / 8)
    warn(joined_text({"--cell = ", o.cell_size(),
                      " m: is coarser than an eighth of the penetrometer's diameter, ",
                      rounded(o.outer_diameter() / 8), " m; --error-bar tells what that costs"}));
  run.go();
}

}  // namespace arenite::ffp
