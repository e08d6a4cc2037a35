// Limits of the samples of a record: gaps, a flat top where the accelerometer is at the end of its
// range, too few of them.
#pragma once

#include <string>
#include <vector>

#include "measurement.hpp"

namespace arenite::ffp {

/// Warnings of a record between the times of release, impact and rest, s.
std::vector<std::string> sampling_warnings(const Measurement& m, double release, double impact, double rest,
                                           double gravity);

}  // namespace arenite::ffp
