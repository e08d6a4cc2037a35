// A run that was begun earlier in the same folder: what --resume finds there.
#pragma once

#include <string>
#include <vector>

#include "../options/options.hpp"

namespace arenite::ffp {

/// How an earlier run of the same inputs stands.
struct EarlierRun {
  bool finished = false;
  bool has_state = false;  ///< one was saved to resume from
  std::string started{};   ///< UTC
  double wall_s = 0;       ///< that its steps took
  std::vector<std::string> warnings{};
  std::vector<double> resumed_at_s{};  ///< times of the states that it was resumed from
};

/// Looks into `options.out`; a folder without a summary has no earlier run. Throws `error` that names
/// `--resume` if the run there has other inputs, if its summary cannot be read, or if its state is that of the
/// other program: `on_ranks` says which one asks.
EarlierRun earlier_run(const DropOptions& options, bool on_ranks = false);

}  // namespace arenite::ffp
