// The reduction of one record: motion, bearing resistance, and what is read off them.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "../drop/history.hpp"
#include "../options/reduce_options.hpp"
#include "bearing.hpp"
#include "correlations.hpp"
#include "impact.hpp"
#include "levels.hpp"
#include "measurement.hpp"

namespace arenite::ffp {

/// A column over the rows of a motion; NaN where there is no value.
using Column = std::vector<double>;

/// The largest of a column, and its value where the deceleration is largest; none if there is no value.
struct ColumnPeak {
  std::optional<double> largest, depth, at_peak;
};

/// Quasi-static resistance by one K.
struct QuasiStatic {
  RateBand band{};
  double k = 0;
  /// kPa, by area (mantle, projected) and form (log10, asinh).
  Column columns[2][2];
  ColumnPeak peaks[2][2];
};

/// Something that happens in a record.
struct RecordEvent {
  std::string kind;  ///< "drop", "contact" of a drop beside its impact, "knock", "glitch" of one sample
  int drop = 0;      ///< from 1; 0: of no drop
  double time = 0;   ///< s, in the record
  std::optional<double> velocity, depth;  ///< m/s, m
  double peak = 0;                        ///< m/s^2, of the mean; of a glitch the sample's
};

/// A record of several drops, of which none is chosen: a sentence, and a line for each.
class SeveralDrops : public error {
 public:
  using error::error;
};

/// "drop 1 at 1.5 s (4.91 m/s, 0.123 m, 15.6 g)".
std::string text_of(const RecordEvent& event, double gravity);

struct Reduction {
  std::vector<std::string> notes, warnings;
  bool of_drop = false;  ///< the record is the history of a drop's folder
  DeviceOptions device;  ///< the penetrometer
  double mass = 0, gravity = 0, k0 = 0;
  std::optional<double> unit_weight;
  double threshold = 0;
  std::vector<RecordEvent> events;  ///< of a measured record, in time
  int drop = 0;                     ///< that of the events which is reduced; 0: an impact that was given
  Levels levels;                    ///< of a measured record
  double taken_off = 0;             ///< m/s^2
  Motion motion;
  std::size_t peak = 0;                        ///< row of the largest filtered deceleration
  double greatest_depth = 0;                   ///< m
  std::optional<double> depth_without_offset;  ///< m: the same, with the offset at rest taken off
  /// m/s, m: what the impact may lie off between its two samples, and the release; none: it was given.
  std::optional<double> velocity_of_sampling, depth_of_sampling;
  Column q_dyn[2];  ///< kPa, by area
  ColumnPeak q_dyn_peaks[2];
  std::vector<QuasiStatic> quasi_static;  ///< each end of each band
  std::vector<Estimate> estimates;

  double peak_g() const { return motion.filtered[peak] / gravity; }
};

/// Throws `error` that names what is missing.
Reduction reduce(Measurement record, const ReduceOptions& o);

}  // namespace arenite::ffp
