// Barrier: a barrier for the threads of the tiles of a rank.
#pragma once
// SPDX-License-Identifier: BSD-3-Clause

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <exception>
#include <mutex>
#include <string>

#include <arenite/core/error.hpp>

namespace arenite::inline ARENITE_INSTRUCTION_SET {

/// A reusable barrier. After a failure every waiting and arriving thread throws `run_error`, until
/// `begin_again`.
class Barrier {
 public:
  explicit Barrier(std::size_t count) : count_{count} {}

  /// Returns when all have arrived; the last one has then called its `f()`, while the others waited.
  template <class F>
  void wait(F&& f) {
    throw_failure();
    const std::uint32_t round = round_.load(std::memory_order_acquire);
    if (here_.fetch_add(1, std::memory_order_acq_rel) + 1 == count_) {
      try {
        f();
      } catch (const std::exception& e) {
        fail(e.what());
        throw;
      }
      here_.store(0, std::memory_order_relaxed);
      round_.fetch_add(1, std::memory_order_release);
      round_.notify_all();
      return;
    }
    round_.wait(round, std::memory_order_acquire);
    throw_failure();
  }

  /// After a failure, once all threads have ended.
  void begin_again() {
    here_ = 0;
    failed_ = false;
  }

  /// Lets all others throw. Returns whether it is the first failure.
  bool fail(const std::string& what) {
    {
      const std::lock_guard lock(mutex_);
      if (failed_.load(std::memory_order_relaxed)) return false;
      failure_ = what;
      failed_.store(true, std::memory_order_release);
    }
    round_.fetch_add(1, std::memory_order_release);
    round_.notify_all();
    return true;
  }

 private:
  void throw_failure() {
    if (!failed_.load(std::memory_order_acquire)) return;
    const std::lock_guard lock(mutex_);
    throw run_error(failure_);
  }

  std::size_t count_;
  std::atomic<std::size_t> here_{0};
  std::atomic<std::uint32_t> round_{0};
  std::atomic<bool> failed_{false};
  std::mutex mutex_{};     // of `failure_`
  std::string failure_{};  // why all throw
};

}  // namespace arenite::inline ARENITE_INSTRUCTION_SET
