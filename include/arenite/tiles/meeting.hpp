// Meeting: where the threads of the tiles of a rank wait for each other.
#pragma once
// SPDX-License-Identifier: BSD-3-Clause

#include <condition_variable>
#include <cstddef>
#include <exception>
#include <mutex>
#include <string>

#include <arenite/core/error.hpp>

namespace arenite::inline ARENITE_INSTRUCTION_SET {

/// A number of threads that meet again and again. Once one has failed, all who wait, and all who come, throw `run_error`.
class Meeting {
 public:
  explicit Meeting(std::size_t count) : count_{count} {}

  /// Returns when all have come; the last one has then called its `f()`, while the others waited.
  template <class F>
  void meet(F&& f) {
    std::unique_lock lock(mutex_);
    if (!failure_.empty()) throw run_error(failure_);
    const std::size_t round = round_;
    if (++here_ == count_) {
      try {
        f();
      } catch (const std::exception& e) {
        failure_ = e.what();
        all_.notify_all();
        throw;
      }
      here_ = 0;
      ++round_;
      all_.notify_all();
      return;
    }
    all_.wait(lock, [&] { return round != round_ || !failure_.empty(); });
    if (round == round_) throw run_error(failure_);
  }

  /// Lets all others throw. Returns whether it is the first failure.
  bool fail(const std::string& what) {
    const std::lock_guard lock(mutex_);
    if (!failure_.empty()) return false;
    failure_ = what;
    all_.notify_all();
    return true;
  }

 private:
  std::mutex mutex_;
  std::condition_variable all_;
  std::size_t count_, here_ = 0, round_ = 0;
  std::string failure_{};
};

}  // namespace arenite::inline ARENITE_INSTRUCTION_SET
