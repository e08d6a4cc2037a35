// Time for the thread pool: the clock, the processor time of a thread, and yielding.
#pragma once
// SPDX-License-Identifier: BSD-3-Clause

#include <arenite/core/instruction_set.hpp>

#include <chrono>
#include <ctime>
#include <thread>

namespace arenite::inline ARENITE_INSTRUCTION_SET::shared_detail {

/// The system's clocks. Tests replace them by clocks that they set.
struct SystemTime {
  using Duration = std::chrono::nanoseconds;

  /// Time since a fixed start; it never decreases.
  static Duration now() { return std::chrono::steady_clock::now().time_since_epoch(); }

  /// Processor time of this thread; `now()` where the system does not give it.
  static Duration processor_time() {
#ifdef CLOCK_THREAD_CPUTIME_ID
    std::timespec time;
    if (clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time) == 0)
      return std::chrono::seconds(time.tv_sec) + std::chrono::nanoseconds(time.tv_nsec);
#endif
    return now();
  }

  static void give_way() { std::this_thread::yield(); }
};

}  // namespace arenite::inline ARENITE_INSTRUCTION_SET::shared_detail
