// Helper account: decides whether a parallel loop wakes the other threads, from what they gained and cost. On a busy machine
// the system stops a helper inside an item, and all wait for it; or it runs the helper on the processor of
// the caller. Then the caller is faster without them.
//
// The gain of a loop is the time that all its items would have taken the caller (the time of its part, scaled
// up), minus the time that the loop took. It is added to a balance, at first zero. A loop that makes the
// balance negative is followed by a rest of `rest` times the deficit, in which only the caller works; then
// the balance is zero again. So
// - the total cost of helpers, except in the last loop, is at most their earlier gains plus 1/20 of the
//   rests;
// - the helpers are tried again: soon after a small loss, late after a large one;
// - after a good time, `most` is left to pay for a few stops: a machine that is idle now and then does not
//   rest.
// The processor time of the caller counts as work, so that its own stops (in which helpers continue, then
// wait) are no gain. A query of processor time takes longer than one of a clock. So loops are watched that
// closely only while the balance is not full, and for a while after a loop so long that a thread may have
// been stopped in it. In others the clock gives how long the caller waited for the helpers, and only a long
// wait is recorded. On an idle machine this costs only three readings of the clock per loop.
#pragma once
// SPDX-License-Identifier: BSD-3-Clause

#include <arenite/core/instruction_set.hpp>
#include <arenite/parallel/system_time.hpp>

#include <algorithm>
#include <chrono>
#include <cstddef>

namespace arenite::inline ARENITE_INSTRUCTION_SET::shared_detail {

template <class Time = SystemTime>
class HelperAccount {
 public:
  using Duration = typename Time::Duration;

  /// Returns whether helpers should take part; if not, only the caller works and nothing is recorded.
  bool begin_loop() {
    begin_ = Time::now();
    if (begin_ < rests_until_) return false;
    watches_ = begin_ < watches_until_ || balance_ < most;
    if (watches_) worked_ = Time::processor_time();
    return true;
  }
  /// The caller finds no items any more.
  void end_own_part() { worked_ = watches_ ? Time::processor_time() - worked_ : Time::now() - begin_; }
  /// All are done; the caller did `own` of `n` items, on `threads` threads.
  void end_loop(std::size_t n, std::size_t own, int threads) {
    const Duration end = Time::now(), taken = end - begin_;
    if (taken >= suspicious) watches_until_ = end + watch;
    // Not watched and short: no loss. Not watched and its own part long: it may have been stopped itself.
    if (!watches_ && (taken < suspicious || worked_ >= suspicious)) return;
    const double share =
        own > 0 ? std::min<double>(threads, static_cast<double>(n) / static_cast<double>(own)) : 1;
    const auto alone = std::chrono::duration_cast<Duration>(worked_ * share);
    balance_ = std::min(most, balance_ + alone - taken);
    if (balance_ >= Duration::zero()) return;
    rests_until_ = end - rest * balance_;
    balance_ = Duration::zero();
  }

  static constexpr int rest = 20;                                       // times what was lost
  static constexpr Duration suspicious = std::chrono::milliseconds(1);  // systems stop a thread for longer
  static constexpr Duration watch = std::chrono::milliseconds(100);
  static constexpr Duration most = std::chrono::milliseconds(10);  // gains that are kept for worse times

 private:
  Duration balance_{}, worked_{};
  bool watches_ = false;
  Duration begin_{}, watches_until_{}, rests_until_{};
};

}  // namespace arenite::inline ARENITE_INSTRUCTION_SET::shared_detail
