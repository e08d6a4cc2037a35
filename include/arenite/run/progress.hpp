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

#if ARENITE_HAS_COLD

#include <chrono>
#include <cmath>

#if defined(__unix__) || defined(__APPLE__)
#include <unistd.h>
#endif

#include <arenite/run/progress.hpp>

namespace arenite::inline ARENITE_INSTRUCTION_SET {
namespace detail {

/// Time on the steady clock, s.
ARENITE_COLD double steady_seconds() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

}  // namespace detail

ARENITE_COLD Progress::Progress(double end, const ProgressOptions& options)
    : end_{end},
      stream_{options.stream},
      tenths_{options.tenths},
      last_{detail::steady_seconds()},
      shown_{last_} {
#if defined(__unix__) || defined(__APPLE__)
  terminal_ = isatty(fileno(stream_)) != 0;
#endif
}

ARENITE_COLD void Progress::look(double time, std::size_t steps, double time_step) {
  const double now = detail::steady_seconds();
  spent_ += now - last_;
  last_ = now;
  const double fraction = end_ > 0 ? time / end_ : 1;
  const bool done = time >= end_;
  if (terminal_) {
    if (!done && now - shown_ < 0.5) return;
  } else {
    const int tenth = done ? 10 : static_cast<int>(10 * fraction);
    if (tenth <= tenth_) return;
    tenth_ = tenth;
  }
  shown_ = now;
  const double left = fraction > 0 ? spent_ * (1 - fraction) / fraction : 0;
  std::fprintf(stream_, "%s%5.1f %%  t = %.5f s  step %zu  dt = %.2e s  %.0f s left%s%s",
               terminal_ ? "\r" : "", 100 * fraction, time, steps, time_step, std::ceil(left),
               terminal_ ? "   " : "", done || !terminal_ ? "\n" : "");
  std::fflush(stream_);
}

}  // namespace arenite::inline ARENITE_INSTRUCTION_SET

#endif  // ARENITE_HAS_COLD
