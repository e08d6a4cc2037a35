// Progress: a line on a terminal that tells how far a run is and how long it will take. Silent in a pipe.
#pragma once

#include <chrono>
#include <cmath>
#include <cstdio>

#if defined(__unix__) || defined(__APPLE__)
#include <unistd.h>
#endif

#include <arenite/core/instruction_set.hpp>

namespace arenite::inline ARENITE_INSTRUCTION_SET {

/// Observer that rewrites one line on standard error about twice a second until `end`, s. Shows nothing
/// unless that is a terminal.
class Progress {
 public:
  explicit Progress(double end) : end_{end}, begin_{Clock::now()}, shown_{begin_} {
#if defined(__unix__) || defined(__APPLE__)
    visible_ = isatty(STDERR_FILENO) != 0;
#endif
  }

  template <class Scene>
  void operator()(const Scene& scene) {
    if (!visible_) return;
    const auto now = Clock::now();
    const bool done = scene.time >= end_;
    if (!done && now - shown_ < std::chrono::milliseconds(500)) return;
    shown_ = now;
    const double spent = std::chrono::duration<double>(now - begin_).count();
    const double share = end_ > 0 ? scene.time / end_ : 1;
    const double left = share > 0 ? spent * (1 - share) / share : 0;
    std::fprintf(stderr, "\r%5.1f %%  t = %.5f s  step %zu  dt = %.2e s  %.0f s left   %s", 100 * share,
                 scene.time, scene.steps, scene.time_step, std::ceil(left), done ? "\n" : "");
    std::fflush(stderr);
  }

 private:
  using Clock = std::chrono::steady_clock;
  double end_;
  Clock::time_point begin_, shown_;
  bool visible_ = false;
};

}  // namespace arenite::inline ARENITE_INSTRUCTION_SET
