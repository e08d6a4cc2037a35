// A drop with its error bar: the drop, the drops around it, and what they show together.
#pragma once

#include "../options/options.hpp"

namespace arenite::ffp {

/// Runs the drop as `drop` does, then its companions (companions.hpp), each in its own folder below
/// OUT/error-bar. Adds "uncertainty" to OUT/summary.json and prints it. A companion that fails makes its part
/// unknown. With `options.resume` what is there of the same inputs is taken over. Throws what `drop` throws
/// of the drop itself, and `Ended` if a signal ends a companion, or the summary cannot be written.
void drop_with_error_bar(const DropOptions& options);

}  // namespace arenite::ffp
