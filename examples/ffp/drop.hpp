// One drop, end to end: what `arenite-ffp drop` does once its options are read. Each combination of
// kinematics and device is compiled in a file of its own.
#pragma once

#include "options.hpp"

namespace arenite::ffp {

/// Runs a drop and writes all of its files into `options.out`. Throws `error` for an unusable mesh or folder,
/// `run_error` if the run fails physically; history and summary are complete up to then.
void drop(const DropOptions& options);

void drop_axisymmetric_rigid(const DropOptions& options);
void drop_axisymmetric_elastic(const DropOptions& options);
void drop_slice_rigid(const DropOptions& options);
void drop_slice_elastic(const DropOptions& options);

}  // namespace arenite::ffp
