// The raw record of a BlueDrop: 60 s at 2 kHz, rows of ten integers of three bytes.
#pragma once

#include <array>
#include <cstddef>
#include <filesystem>
#include <string_view>

#include "../options/reduce_options.hpp"
#include "../text/table_reader.hpp"
#include "measurement.hpp"

namespace arenite::ffp {

/// One of the accelerometers along the axis: value in g = (raw + offset) / scale.
struct Accelerometer {
  std::string_view name;
  std::size_t column;  ///< in a row
  double range;        ///< g
  double scale;        ///< counts a g
  double offset;       ///< counts
};

/// Smallest range first. The scales are samples of what probes have had, and belong to no probe: that of 200
/// g is the middle of 2.8e4 to 3.9e4.
inline constexpr std::array<Accelerometer, 5> sample_accelerometers{{{"2g", 2, 2, 1.62e6, 0},
                                                                     {"18g", 3, 18, 1.6e5, 0},
                                                                     {"50g", 4, 50, 6.4e4, 0},
                                                                     {"200g", 6, 200, 3.35e4, 0},
                                                                     {"250g", 9, 250, 1.36e4, 0}}};

struct Calibration {
  std::array<Accelerometer, 5> accelerometers = sample_accelerometers;
  std::array<bool, 5> is_sample{true, true, true, true, true};  ///< no scale was given
};

inline constexpr std::size_t bluedrop_rows = 120000, bluedrop_columns = 10, bluedrop_bytes = 3;
inline constexpr double bluedrop_rate = 2000;  ///< rows a second

/// The calibration that the options give. Throws `error` that names the option or the file.
Calibration calibration_of(const ReduceOptions& o);

/// Reads a record, by the smallest range that does not clip: one clips where a value leaves it, or is the
/// largest or least of three bytes. Throws `error` that names the file if it is of another size, its integers
/// are not where the count of its first column has them, or all ranges clip.
Measurement read_bluedrop(const std::filesystem::path& path, const ReduceOptions& o, double gravity);

}  // namespace arenite::ffp
