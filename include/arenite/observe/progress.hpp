// Progress: tells how far a run is and how long it will take. A line that is rewritten on a terminal;
// elsewhere silent, or a line each tenth of the run.
#pragma once

#include <chrono>
#include <cmath>
#include <cstdio>

#if defined(__unix__) || defined(__APPLE__)
#include <unistd.h>
#endif

#include <arenite/core/instruction_set.hpp>

namespace arenite::inline ARENITE_INSTRUCTION_SET {

/// Where `Progress` writes, and when.
struct ProgressOptions {
  std::FILE* stream = stderr;  ///< must stay open
  bool tenths = false;         ///< where that is no terminal: a line each tenth of the run
};

/// Observer that tells of a run until `end`, s. On a terminal it rewrites one line about twice a second.
class Progress {
 public:
  explicit Progress(double end, const ProgressOptions& options = {})
      : end_{end}, stream_{options.stream}, tenths_{options.tenths}, last_{Clock::now()}, shown_{last_} {
#if defined(__unix__) || defined(__APPLE__)
    terminal_ = isatty(fileno(stream_)) != 0;
#endif
  }

  template <class Scene>
  void operator()(const Scene& scene) {
    if (!terminal_ && !tenths_) return;
    const auto now = Clock::now();
    spent_ += std::chrono::duration<double>(now - last_).count();
    last_ = now;
    const double fraction = end_ > 0 ? scene.time / end_ : 1;
    const bool done = scene.time >= end_;
    if (terminal_) {
      if (!done && now - shown_ < std::chrono::milliseconds(500)) return;
    } else {
      const int tenth = done ? 10 : static_cast<int>(10 * fraction);
      if (tenth <= tenth_) return;
      tenth_ = tenth;
    }
    shown_ = now;
    const double left = fraction > 0 ? spent_ * (1 - fraction) / fraction : 0;
    std::fprintf(stream_, "%s%5.1f %%  t = %.5f s  step %zu  dt = %.2e s  %.0f s left%s%s",
                 terminal_ ? "\r" : "", 100 * fraction, scene.time, scene.steps, scene.time_step,
                 std::ceil(left), terminal_ ? "   " : "", done || !terminal_ ? "\n" : "");
    std::fflush(stream_);
  }

  /// What was told and the time spent, for a run that goes on elsewhere.
  template <class F>
  void visit_state(F&& f) {
    f("tenth", tenth_);
    f("spent", spent_);
  }

 private:
  using Clock = std::chrono::steady_clock;
  double end_;
  std::FILE* stream_;
  bool tenths_;
  Clock::time_point last_, shown_;
  double spent_ = 0;  // until last_, s
  bool terminal_ = false;
  int tenth_ = 0;  // the last one told
};

}  // namespace arenite::inline ARENITE_INSTRUCTION_SET
