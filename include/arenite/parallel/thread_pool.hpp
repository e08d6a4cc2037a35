// Thread pool: threads that share a loop whose items may run in any order. Each has its own part, the
// same in every loop of the same length, so that the data it touched is still in its cache; an idle thread
// takes items from the ends of other parts. The caller starts at once, and a helper that wakes late finds
// fewer items: on a busy machine the loop proceeds with the threads that run. (A team that starts and ends
// each loop at a barrier, as OpenMP's does, waits for all of them each time: ten times as long as one thread
// takes, when another program occupied a core.) There remains the case of a thread that the system stops
// inside an item: all others wait for it. So the pool records what its helpers gain and cost, and where they
// cost more, only the caller works: see `HelperAccount`.
#pragma once
// SPDX-License-Identifier: BSD-3-Clause

#include <arenite/core/instruction_set.hpp>
#include <arenite/core/once.hpp>
#include <arenite/parallel/helper_account.hpp>
#include <arenite/parallel/loop_items.hpp>
#include <arenite/parallel/system_time.hpp>

#include <atomic>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <thread>
#include <vector>

#ifdef __SSE2__
#include <emmintrin.h>
#endif

namespace arenite::inline ARENITE_INSTRUCTION_SET::shared_detail {

/// One pause of a thread that waits in a loop.
inline void relax() {
#ifdef __SSE2__
  _mm_pause();
#endif
}

inline constexpr int patience = 2000;  ///< polls before a thread yields: some 50 microseconds

/// Polls `done()`, at first without and then with yielding the processor; returns false if it takes longer
/// than a millisecond. A yield takes no time on an idle machine, and a time slice of each other program on a
/// busy one: so the limit is a time, not a number of polls.
template <class Time = SystemTime, class Done>
bool wait_awake(Done&& done) {
  for (int k = 0; k < patience; ++k) {
    if (done()) return true;
    relax();
  }
  for (const auto until = Time::now() + std::chrono::milliseconds(1); !done(); Time::give_way())
    if (Time::now() >= until) return false;
  return true;
}

/// Why the memory orders do:
/// - `state_` is the gate. The caller writes the loop (loop_, parts_) and then sets `open`. A
///   helper signs in with an acquiring addition, and touches the loop only if that saw `open`: so it sees
///   all that was written. It signs out with a releasing subtraction, and the caller resumes once it has acquired 0:
///   so it sees all that the helpers' items wrote, and no helper reads the next loop before it is complete. The
///   numbers in between come from read-modify-writes, which continue the release sequence of the one before.
/// - `items` of a part only deals numbers out: each is taken by one exchange, nothing else hangs on it.
///   Relaxed.
/// - Sleep: the helper announces itself (`asleep_`), then reads `state_`; the caller opens, then reads
///   `asleep_`. All four are sequentially consistent, so that one of them sees the other: a helper either
///   does not sleep, or is rung for. It read `bell_` before, so that a ring in between keeps it awake.
/// - `taken_` passes the pool from one of the program's threads to another: acquired and released around all
///   that only the caller touches (parts_, helpers_, account_).
class ThreadPool {
 public:
  /// The pool of the process: its threads start with the first loop that wants them.
  static ThreadPool& instance() {
    return once<ThreadPool>(program::thread_pool, []() -> ThreadPool& {
      static ThreadPool pool;
      return pool;
    });
  }

  ThreadPool(const ThreadPool&) = delete;
  ThreadPool& operator=(const ThreadPool&) = delete;
  ~ThreadPool() { stop(); }

  int threads() const { return threads_; }

  /// Threads that loops may use from here on, the caller's among them. Not to be called from within a loop.
  void set_threads(int n) {
    if (n == threads_) return;
    stop();
    threads_ = n;
  }

  /// Runs the items [0, n) of a loop, on as many threads as come in time. A loop within a loop, and one that
  /// starts while another of the program's threads has the pool, run only on their own thread; so do all loops
  /// while helpers do not pay.
  void run(std::size_t n, const Loop& loop) {
    if (threads_ < 2 || program::in_loop || taken_.test_and_set(std::memory_order_acquire)) {
      loop.items(loop.body, 0, n);
      return;
    }
    if (helpers_.empty()) start();
    if (!account_.begin_loop()) {
      taken_.clear(std::memory_order_release);
      loop.items(loop.body, 0, n);
      return;
    }
    program::in_loop = true;
    loop_ = loop;
    const auto parts = static_cast<std::size_t>(threads_);
    for (std::size_t t = 0, begin = 0; t < parts; ++t) {
      const std::size_t end = t + 1 == parts ? n : loop.cut(loop.cuts, t + 1, parts);
      parts_[t].items.store(pack(begin, end), std::memory_order_relaxed);
      begin = end;
    }
    state_.fetch_or(open, std::memory_order_seq_cst);
    if (asleep_.load(std::memory_order_seq_cst) > 0) {
      bell_.fetch_add(1, std::memory_order_seq_cst);
      bell_.notify_all();
    }
    const std::size_t own = take_items(0);
    account_.end_own_part();
    state_.fetch_and(~open, std::memory_order_acq_rel);
    // A thread that is still at an item finishes it; then no thread reads this loop again.
    for (int k = 0; state_.load(std::memory_order_acquire) != 0; ++k)
      k < patience ? relax() : std::this_thread::yield();
    account_.end_loop(n, own, threads_);
    program::in_loop = false;
    taken_.clear(std::memory_order_release);
  }

 private:
  static constexpr std::uint32_t open = 1u << 31;  // beside the number of helpers at work, in state_

  ThreadPool() {
    const char* const wanted = std::getenv("ARENITE_THREADS");
    const int n = wanted ? std::atoi(wanted) : 0;
    threads_ = n >= 1 ? n : static_cast<int>(std::thread::hardware_concurrency());
    if (threads_ < 1) threads_ = 1;
  }

  /// Items [next, end) that are left of a part, in one word.
  static std::uint64_t pack(std::size_t next, std::size_t end) {
    return static_cast<std::uint64_t>(next) | static_cast<std::uint64_t>(end) << 32;
  }
  struct alignas(64) Part {
    std::atomic<std::uint64_t> items{0};
  };

  /// Runs the own part from its begin, then those of the others from their ends; returns how many items.
  std::size_t take_items(std::size_t own) {
    const std::size_t parts = parts_.size();
    std::size_t taken = 0;
    for (std::size_t k = 0; k < parts; ++k) {
      auto& items = parts_[(own + k) % parts].items;
      std::uint64_t left = items.load(std::memory_order_relaxed);
      for (;;) {
        const std::size_t next = left & 0xffffffffu, end = left >> 32;
        if (next >= end) break;
        const std::uint64_t rest = k == 0 ? pack(next + 1, end) : pack(next, end - 1);
        if (!items.compare_exchange_weak(left, rest, std::memory_order_relaxed)) continue;
        const std::size_t item = k == 0 ? next : end - 1;
        loop_.items(loop_.body, item, item + 1);
        ++taken;
        left = items.load(std::memory_order_relaxed);
      }
    }
    return taken;
  }

  void start() {
    stopping_ = false;
    parts_ = std::vector<Part>(static_cast<std::size_t>(threads_));
    for (std::size_t k = 1; k < parts_.size(); ++k) helpers_.emplace_back([this, k] { help(k); });
  }

  void stop() {
    stopping_ = true;
    bell_.fetch_add(1);
    bell_.notify_all();
    for (auto& helper : helpers_) helper.join();
    helpers_.clear();
  }

  void help(std::size_t own) {
    program::in_loop = true;
    while (!stopping_.load(std::memory_order_relaxed)) {
      if (!(state_.load(std::memory_order_relaxed) & open)) {
        wait();
        continue;
      }
      // Sign in, and only then check whether the loop is still open: whoever closes it waits for the
      // helpers signed in.
      if (state_.fetch_add(1, std::memory_order_acq_rel) & open) take_items(own);
      state_.fetch_sub(1, std::memory_order_release);
      for (int k = 0; k < patience && (state_.load(std::memory_order_relaxed) & open); ++k) relax();
    }
  }

  /// Polls for an open loop for a while, then sleeps until the bell: waking up takes as long as a short
  /// loop, and between two loops of a step may lie half a millisecond of serial work.
  void wait() {
    if (wait_awake([this] {
          return (state_.load(std::memory_order_relaxed) & open) || stopping_.load(std::memory_order_relaxed);
        }))
      return;
    const std::uint32_t rung = bell_.load(std::memory_order_seq_cst);
    asleep_.fetch_add(1, std::memory_order_seq_cst);
    if (!(state_.load(std::memory_order_seq_cst) & open) && !stopping_)
      bell_.wait(rung, std::memory_order_seq_cst);
    asleep_.fetch_sub(1, std::memory_order_seq_cst);
  }

  int threads_ = 1;
  std::atomic_flag taken_;   // whether a loop has the helpers
  HelperAccount<> account_;  // of the thread that has the helpers
  std::vector<std::thread> helpers_;
  std::atomic<bool> stopping_{false};
  Loop loop_{};              // that is open
  std::vector<Part> parts_;  // of its items, one a thread
  alignas(64) std::atomic<std::uint32_t> state_{0};
  alignas(64) std::atomic<std::uint32_t> bell_{0};
  std::atomic<int> asleep_{0};
};

}  // namespace arenite::inline ARENITE_INSTRUCTION_SET::shared_detail
