// Progress: reports how far a run is and how long it will take. A line that is rewritten on a terminal;
// elsewhere silent, or a line each tenth of the run.
#pragma once
// SPDX-License-Identifier: BSD-3-Clause

#include <cstddef>
#include <cstdio>

#include <arenite/core/cold.hpp>
#include <arenite/core/instruction_set.hpp>
#include <arenite/parallel/communicator.hpp>

namespace arenite::inline ARENITE_INSTRUCTION_SET {

/// Where `Progress` writes, and when.
struct ProgressOptions {
  std::FILE* stream = stderr;  ///< must stay open
  bool tenths = false;         ///< where that is no terminal: a line each tenth of the run
};

/// Observer that reports on a run until `end`, s. On a terminal it rewrites one line about twice a second.
class Progress {
 public:
  explicit Progress(double end, const ProgressOptions& options = {});

  template <class Scene>
  void operator()(const Scene& scene) {
    if ((terminal_ || tenths_) && is_reporter(scene)) look(scene.time, scene.steps, scene.time_step);
  }

  /// The last report and the time spent, for a run that continues elsewhere.
  template <class F>
  void visit_state(F&& f) {
    f("tenth", tenth_);
    f("spent", spent_);
  }

 private:
  void look(double time, std::size_t steps, double time_step);

  double end_;
  std::FILE* stream_;
  bool tenths_;
  double last_, shown_;  // on the steady clock, s
  double spent_ = 0;     // until last_, s
  bool terminal_ = false;
  int tenth_ = 0;  // the last one reported
};

}  // namespace arenite::inline ARENITE_INSTRUCTION_SET

#ifndef ARENITE_COLD_LIBRARY
#include <arenite/run/progress_cold.hpp>
#endif
