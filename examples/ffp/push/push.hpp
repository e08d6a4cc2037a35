// A penetrometer that is pushed into ground: what `arenite-ffp push` does once its options are read.
#pragma once

#include "../options/push_options.hpp"

namespace arenite::ffp {

/// Runs a push and writes its files into `options.out`: history.csv, summary.json and fields. Throws `error` for a folder or options
/// that cannot be used, and `Ended` for a run that did not come to its end; the files are complete up to then.
void push(const PushOptions& options);

/// The unit that computes pushes adds itself, so that a program can be built without it.
struct PushUnit {
  explicit PushUnit(void (*run)(const PushOptions&));
};

/// The push and those around it that show how far its resistance can be trusted, into `error-bar/` of its folder.
void push_with_error_bar(const PushOptions& options);

}  // namespace arenite::ffp
