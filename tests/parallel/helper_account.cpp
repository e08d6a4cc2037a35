// Whether helpers pay, with a clock of the test's own: what two threads lose on a busy machine is bounded,
// and where helpers bring time they work.
#include "catch.hpp"

#include <arenite/parallel/helper_account.hpp>
#include <arenite/parallel/thread_pool.hpp>
#include <initializer_list>

using namespace std::chrono_literals;
using Duration = std::chrono::nanoseconds;

namespace {

struct TestTime {
  using Duration = std::chrono::nanoseconds;
  static inline Duration clock{}, processor{}, turn{};  // turn: that giving way takes
  static inline int ways_given = 0;

  static Duration now() { return clock; }
  static Duration processor_time() { return processor; }
  static void give_way() {
    clock += turn;
    ++ways_given;
  }
  static void work(Duration t) {
    clock += t;
    processor += t;
  }
};

using Account = arenite::shared_detail::HelperAccount<TestTime>;

constexpr std::size_t items = 100;
constexpr Duration work = 100us;  // of a loop

/// One loop, without the helper if the account says so; with two threads the caller does `own` items, and
/// then waits. Returns whether two took part.
bool loop(Account& account, std::size_t own, Duration wait, Duration stopped_itself = 0ns) {
  if (!account.begin_loop()) {
    TestTime::work(work);
    return false;
  }
  TestTime::work(work * own / items);
  TestTime::clock += stopped_itself;
  account.end_own_part();
  TestTime::clock += wait;
  account.end_loop(items, own, 2);
  return true;
}

double ratio(Duration a, Duration b) {
  return static_cast<double>(a.count()) / static_cast<double>(b.count());
}

}  // namespace

TEST_CASE("helpers that bring time work in every loop") {
  Account account;
  bool all = true;
  for (int k = 0; k < 10'000; ++k) all = loop(account, 50, 0us) && all;
  REQUIRE(all);
}

TEST_CASE("helpers that always cost time cost a twentieth") {
  for (const Duration stop : std::initializer_list<Duration>{200us, 1ms, 4ms, 30ms, 100ms}) {
    CAPTURE(stop.count());
    Account account;
    const Duration begin = TestTime::clock, all = 10s;
    for (Duration done{}; done < all; done += work) loop(account, 50, stop);
    REQUIRE(ratio(TestTime::clock - begin, all) < 1.06);
  }
}

TEST_CASE("rare stops are recorded, too") {
  // The helper brings a twentieth in most loops, and is stopped in one after so much time.
  for (const Duration stop : {4ms, 10ms, 30ms, 100ms})
    for (const Duration quiet : {20ms, 90ms, 110ms, 150ms, 300ms}) {
      CAPTURE(stop.count(), quiet.count());
      Account account;
      const Duration begin = TestTime::clock, all = 10s;
      Duration last_stop = begin;
      for (Duration done{}; done < all; done += work) {
        const bool is_stopped = TestTime::clock - last_stop >= quiet;
        if (loop(account, 95, is_stopped ? stop : 0ns) && is_stopped) last_stop = TestTime::clock;
      }
      REQUIRE(ratio(TestTime::clock - begin, all) < 1.06);
    }
}

TEST_CASE("a stop of the caller is no gain") {
  Account account;
  REQUIRE(loop(account, 1, 0us, 4ms));  // the helper did the rest
  REQUIRE_FALSE(loop(account, 50, 0us));
}

TEST_CASE("a full balance pays for a few stops") {
  Account account;
  const auto pass_good_time = [&] {
    for (int k = 0; k < 10'000; ++k) loop(account, 50, 0us);
  };
  pass_good_time();
  loop(account, 50, 4ms);
  REQUIRE(loop(account, 50, 0us));
  pass_good_time();
  for (int k = 0; k < 3; ++k) loop(account, 50, 4ms);
  REQUIRE_FALSE(loop(account, 50, 0us));
}

TEST_CASE("helpers come back when the machine is idle again") {
  Account account;
  for (int k = 0; k < 10'000; ++k) loop(account, 50, 4ms);
  const Duration idle_since = TestTime::clock;
  while (!loop(account, 50, 0us)) {
  }
  REQUIRE(TestTime::clock - idle_since <= Account::rest * 4ms);
  bool all = true;
  for (int k = 0; k < 1000; ++k) all = loop(account, 50, 0us) && all;
  REQUIRE(all);
}

TEST_CASE("who waits awake falls asleep by the clock, however long it takes to give way") {
  using arenite::shared_detail::wait_awake;
  for (const Duration turn : std::initializer_list<Duration>{100ns, 1us, 30us, 8ms}) {
    CAPTURE(turn.count());
    TestTime::turn = turn;
    const Duration begin = TestTime::clock;
    REQUIRE_FALSE(wait_awake<TestTime>([] { return false; }));
    REQUIRE(TestTime::clock - begin >= 1ms);
    REQUIRE(TestTime::clock - begin <= 1ms + turn);
  }
  TestTime::turn = 100us;
  TestTime::ways_given = 0;
  REQUIRE(wait_awake<TestTime>([] { return TestTime::ways_given == 5; }));
}
