// The levels at which a record is quiet: at rest before the release, in the fall, at rest after the end. They
// show how the accelerometer reads (net or proper, which way is positive), and by how much it is off.
#pragma once

#include <limits>
#include <optional>
#include <string>

#include "../options/reduce_options.hpp"
#include "measurement.hpp"

namespace arenite::ffp {

/// In g, as the options read the record: net 0, -1 and 0, if nothing is wrong. None: the record does not show
/// it.
struct Levels {
  std::optional<double> before, fall, after;
  double peak_sign = 0;  ///< of the largest deviation; 0: too small to decide

  /// Offset of the accelerometer: that of the rest before the release, as in the fall; without one, that
  /// after the end, where the penetrometer may lean.
  std::optional<double> offset() const { return before ? before : after; }
};

/// Times between which the peak is sought, s.
struct PeakWindow {
  double from = -std::numeric_limits<double>::infinity(), to = std::numeric_limits<double>::infinity();
};

/// Levels are means over 20 ms and more, of at least four samples, whose halves agree to 0.1 g. `gravity`:
/// m/s^2 of the record that are 1 g. Without a window the peak is the largest whose levels show a fall and a
/// rest, or the largest of all.
Levels levels_of(const Measurement& m, double gravity, bool in_water,
                 const std::optional<PeakWindow>& window);

/// "0.05 g before the release, -0.95 g in the fall, 0.05 g after the end", of the levels that there are.
std::string text_of(const Levels& levels, double sign = 1, double shift = 0);

/// A fault in the way in which the options read a record.
struct ReadingProblem {
  std::string text;       ///< the levels, and the options that fit
  bool has_cure = false;  ///< there are such
};

/// None if the levels are those of a net record, or there are none. `window`: of the levels.
std::optional<ReadingProblem> reading_problem(const Measurement& m, const Levels& levels,
                                              const ReduceOptions& o, double gravity,
                                              const std::optional<PeakWindow>& window);

}  // namespace arenite::ffp
