// Failure: an exception of a user's function in a parallel loop, which must not throw; rethrown after it.
#pragma once
// SPDX-License-Identifier: BSD-3-Clause

#include <atomic>
#include <cstddef>
#include <exception>
#include <limits>

#include <arenite/core/instruction_set.hpp>

namespace arenite::inline ARENITE_INSTRUCTION_SET {

/// Keeps the exception of the item of the least number: the same on any number of threads.
class Failure {
 public:
  /// Calls `f()` for item number `item`.
  template <class F>
  void guard(std::size_t item, F&& f) noexcept {
    try {
      f();
    } catch (...) {
      while (taken_.test_and_set(std::memory_order_acquire)) {
      }
      if (item < item_) {
        item_ = item;
        thrown_ = std::current_exception();
      }
      taken_.clear(std::memory_order_release);
    }
  }
  /// Throws it, if there is one.
  void rethrow() const {
    if (thrown_) std::rethrow_exception(thrown_);
  }

 private:
  std::atomic_flag taken_;  // a spin lock
  std::size_t item_ = std::numeric_limits<std::size_t>::max();
  std::exception_ptr thrown_;
};

}  // namespace arenite::inline ARENITE_INSTRUCTION_SET
