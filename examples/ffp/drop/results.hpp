// The results of a drop: its peaks and depths, taken from the history, and summary.json, which contains them
// and all inputs of the drop.
#pragma once

#include <filesystem>
#include <limits>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "../options/options.hpp"
#include "../text/json_file.hpp"
#include "history.hpp"

namespace arenite::ffp {

/// The worst that a watch saw, for one of its limits.
struct WatchedLimit {
  std::string name{};
  double worst = 0, time_s = 0, limit = 0;
  std::vector<double> place_m{};  ///< empty: of the whole scene
};

/// The run itself: how it stands, and what the stepping loop counts.
struct RunNumbers {
  std::string status = "done";         ///< or "running", "failed", "interrupted", "disk-full"
  std::string failure{};               ///< when, where and why it ended early; empty: it did not
  std::string started{};               ///< UTC, ISO 8601
  long process = 0;                    ///< id
  std::vector<double> resumed_at_s{};  ///< times at which the run resumed from a saved state
  long points = 0;                     ///< material points of sand and device
  long expected_steps = 0;             ///< as estimated before the first
  long steps = 0;
  double wall_s = 0;       ///< of the stepping loop, without output
  double point_steps = 0;  ///< sum over steps of the points moved
  int threads = 1;
  long lost_points = 0;
  long limited_velocities = 0;                         ///< times that the velocity limit acted
  int register_bytes = 0;                              ///< of the kernels
  std::optional<double> deepest_point_m{};             ///< in the device, where contact sees points
  std::optional<std::vector<std::string>> warnings{};  ///< none: of a run that does not collect them
  std::optional<std::vector<WatchedLimit>> watch{};    ///< none: nothing watches
};

/// A peak of the deceleration.
struct Peak {
  double value_g = std::numeric_limits<double>::quiet_NaN();
  double time_s = std::numeric_limits<double>::quiet_NaN();
  double penetration_m = std::numeric_limits<double>::quiet_NaN();
};

/// Figures drawn from a history.
struct DropFigures {
  double final_penetration_m = 0, max_penetration_m = 0, max_penetration_time_s = 0;
  double final_tilt_deg = 0, final_aside_m = 0;
  Peak peak;                   ///< of the filtered history
  Peak second;                 ///< of the filtered history; NaN: there is none
  Peak raw_peak;               ///< of the history as computed
  double peak_reaction_N = 0;  ///< of the mean over the same window
  double end_s = 0;            ///< time of the last row
  double dt_min_s = 0, dt_max_s = 0;
  // At the end, over all energy put in: kinetic at the start and external work.
  double energy_transfer = 0;  ///< taken by the transfer
  double energy_walls = 0;     ///< taken by walls
  double energy_residual = 0;  ///< not accounted for: errors
};

inline constexpr double peak_window_s = 2e-3;

/// Needs every step of the run, for the peaks; throws `error` without a row.
DropFigures figures_of(const std::vector<HistoryRow>& history, double window = peak_window_s);

/// The results of a drop in one line.
std::string sentence_of(const DropFigures& f, const DropOptions& o);

/// All inputs of a drop, the derived ones too, by the names of their options.
Json inputs_of(const DropOptions& o);

/// The same as text, and with them what else decides how a drop runs.
std::vector<std::pair<std::string, std::string>> told_of(const DropOptions& o);

/// Hash of all inputs and of the mesh file's content, as 16 hexadecimal digits: equal for runs of the same
/// input.
std::string hash_of_inputs(const DropOptions& o);

/// summary.json as a value. Without figures (the run has no row yet) it contains the status of the run and
/// its inputs. Absent values (a second peak) are null.
Json summary_of(const DropOptions& options, const std::optional<DropFigures>& figures, const RunNumbers& run);

/// The same, into summary.json of a folder. Throws `output_error` if it cannot be written.
void write_summary(const std::filesystem::path& folder, const DropOptions& options,
                   const std::optional<DropFigures>& figures, const RunNumbers& run);

}  // namespace arenite::ffp
