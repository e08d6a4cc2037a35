// A long run in its own folder: locked, with its status in a file, stopped by SIGINT and SIGTERM between two
// steps, saved from time to time, and resumed with the same bits. POSIX.
#pragma once
// SPDX-License-Identifier: BSD-3-Clause

#include <chrono>
#include <exception>
#include <filesystem>
#include <limits>
#include <string>
#include <string_view>
#include <tuple>
#include <utility>

#include <arenite/run/every.hpp>
#include <arenite/run/run.hpp>
#include <arenite/run/run_folder.hpp>
#include <arenite/run/run_status.hpp>
#include <arenite/run/saved_state.hpp>
#include <arenite/run/stop_signals.hpp>

namespace arenite::inline ARENITE_INSTRUCTION_SET {

/// The folder of a run, and what it keeps there: `checkpoint.state` and `status.json`.
struct RunRecord {
  std::filesystem::path folder{};                                     ///< made if it is not there; required
  double checkpoint_every = std::numeric_limits<double>::infinity();  ///< s of the scene's time, positive
  bool resume = false;   ///< from the folder's state, if there is one
  std::string recipe{};  ///< see `SavedState`
};

/// How a run came to its end.
enum class RunEnd {
  finished,    ///< at `RunOptions::end`
  stopped,     ///< by an observer
  interrupted  ///< by SIGINT or SIGTERM
};

/// Names in a folder of `run_in_folder`. `name`: of the folder in messages.
inline RunFolderNames names_of_record(std::string name = "RunRecord.folder") {
  const auto is_result = [](std::string_view file) {
    if (file.ends_with(".part")) file.remove_suffix(5);
    return file == "checkpoint.state" || file == "status.json";
  };
  return {.name = std::move(name), .is_result = is_result, .first = {"status.json"}};
}

namespace detail {

/// An observer, if it has a state to save.
template <class Observer>
auto with_state(Observer& observer) {
  if constexpr (requires(StateSlots & slots) { observer.visit_state(slots); })
    return std::tie(observer);
  else
    return std::tuple<>();
}

/// Writes the status of one run.
class StatusWriter {
 public:
  StatusWriter(std::filesystem::path file, double end) : file_{std::move(file)} {
    run_.started = utc_now();
    run_.end = end;
  }
  template <class Scene>
  void resumed(const Scene& scene) {
    run_.resumed_at.push_back(scene.time);
  }
  template <class Scene>
  void write(const Scene& scene, std::string_view status, std::string failure = {}) {
    written_ = Clock::now();
    run_.status = status;
    run_.failure = std::move(failure);
    run_.updated = utc_now();
    run_.time = scene.time;
    run_.steps = scene.steps;
    run_.points = scene.point_count();
    run_.lost_points = scene.lost_points();
    run_.wall = std::chrono::duration<double>(written_ - begin_).count();
    write_run_status(file_, run_);
  }
  /// Writes it if the file is older than ten seconds.
  template <class Scene>
  void refresh(const Scene& scene) {
    if (Clock::now() - written_ > std::chrono::seconds(10)) write(scene, "running");
  }

 private:
  using Clock = std::chrono::steady_clock;
  std::filesystem::path file_;
  RunStatus run_{};
  Clock::time_point begin_ = Clock::now(), written_{};
};

}  // namespace detail

/// `run` in a folder that no other run may use meanwhile. Saves the state of the scene and of the observers
/// that have one (`save_state`) each `checkpoint_every`, at the end, and when SIGINT or SIGTERM ends the run
/// after a step. With `resume` the same program continues from there with the same bits; also to a later end,
/// with other bits if the former end was reached (`run`). Without it results of an earlier run (state and
/// status) are removed. `status.json` shows the status of the run (`RunStatus`), at most ten seconds late.
/// Throws `error` that names the folder if it cannot be used, or the state if it is of another run, which
/// leaves the folder as it was; else what `run` throws, once the status reports it.
template <class Scene, class... Observers>
RunEnd run_in_folder(Scene& scene, const RunOptions& options, const RunRecord& record,
                     Observers&&... observers) {
  options.check(scene.time);
  require(!record.folder.empty(), "RunRecord.folder", "\"\"", "must be given");
  require(record.checkpoint_every > 0, "RunRecord.checkpoint_every", record.checkpoint_every,
          "must be positive (s)");
  RunFolder folder(record.folder, record.resume ? RunFolder::Earlier::kept : RunFolder::Earlier::removed,
                   names_of_record());
  const SavedState state(folder.path() / "checkpoint.state", record.recipe);
  detail::StatusWriter status(folder.path() / "status.json", options.end);
  const auto saved = std::tuple_cat(detail::with_state(observers)...);
  const auto save_all = [&](const Scene& s) {
    std::apply([&](auto&... those) { save_state(s, state, those...); }, saved);
  };
  if (record.resume && std::filesystem::exists(state.path)) {
    std::apply([&](auto&... those) { restore_state(scene, state, those...); }, saved);
    status.resumed(scene);
  }
  const StopSignals signals;
  bool interrupted = false;
  auto save = every(record.checkpoint_every, [&](const Scene& s) {
    save_all(s);
    status.write(s, "running");
  });
  save.resume_at(scene.time);
  const auto recorder = [&](const Scene& s) {
    save(s);
    status.refresh(s);
    interrupted = signals.has_come() && s.time < options.end;
    return interrupted ? RunFlow::stop : RunFlow::go_on;
  };
  try {
    status.write(scene, "running");
    run(scene, options, observers..., recorder);
    const RunEnd end = interrupted                ? RunEnd::interrupted
                       : scene.time < options.end ? RunEnd::stopped
                                                  : RunEnd::finished;
    save_all(scene);
    status.write(scene, end == RunEnd::finished  ? "finished"
                        : end == RunEnd::stopped ? "stopped"
                                                 : "interrupted");
    return end;
  } catch (const std::exception& e) {
    folder.free_reserve();
    try {
      status.write(scene, "failed", e.what());
    } catch (const error&) {  // what failed first is thrown
    }
    throw;
  }
}

}  // namespace arenite::inline ARENITE_INSTRUCTION_SET
