// every: calls at multiples of a period, once each, whatever the steps and the round-off. Progress: what it
// writes on a terminal, beside one, and nowhere.
#include <arenite/run/every.hpp>
#include <arenite/run/progress.hpp>
#include <limits>
#include <memory>
#include <string>
#include <vector>

#include "catch.hpp"

#if defined(__unix__)
#include <fcntl.h>
#include <stdlib.h>
#include <unistd.h>
#endif

using namespace arenite;

namespace {

struct Clock {
  double time = 0, time_step = 1e-3;
  std::size_t steps = 0;
};

/// Times at which `every(period)` calls, of those given.
std::vector<double> calls(double period, const std::vector<double>& times) {
  std::vector<double> out;
  auto observer = every(period, [&](const Clock& c) { out.push_back(c.time); });
  for (const double t : times) observer(Clock{t});
  return out;
}

std::vector<double> steps(double step, int count) {
  std::vector<double> times{0};
  for (int k = 0; k < count; ++k) times.push_back(times.back() + step);
  return times;
}

/// All that a stream has.
std::string text_of(std::FILE* stream) {
  std::rewind(stream);
  std::string text;
  for (int c; (c = std::fgetc(stream)) != EOF;) text += static_cast<char>(c);
  return text;
}

template <class Observer>
concept has_end = requires(Observer observer) {
  observer.finish(Clock{});
};

}  // namespace

TEST_CASE("every: the start, then the first step at or after each multiple") {
  using V = std::vector<double>;
  CHECK(calls(1, {0, 0.4, 0.8, 1.2, 1.6, 2, 2.4, 2.9, 3.1}) == V{0, 1.2, 2, 3.1});
  CHECK(calls(1, {0, 1, 2, 3}) == V{0, 1, 2, 3});
  CHECK(calls(0.5, {0, 0.2}) == V{0});
  // A step longer than the period is one call, and the multiples stay where they are.
  CHECK(calls(0.1, {0, 0.35, 0.38, 0.4, 0.75}) == V{0, 0.35, 0.4, 0.75});
  // One that is made in the middle of a run calls at once, then at the multiples.
  CHECK(calls(1, {2.5, 2.9, 3, 3.5}) == V{2.5, 3});
  CHECK(calls(std::numeric_limits<double>::infinity(), {0, 1, 1e9}) == V{0});
}

TEST_CASE("every: sums of steps that miss a multiple by round-off still reach it, once") {
  for (const double period : {0.1, 0.3, 1e-3, 7e-5, 1 / 3.0})
    for (const int each : {1, 2, 7}) {
      CAPTURE(period, each);
      CHECK(calls(period, steps(period / each, 1000 * each)).size() == 1001);
    }
  std::vector<double> exact;
  for (int k = 0; k <= 100000; ++k) exact.push_back(k * 0.1);
  CHECK(calls(0.1, exact).size() == exact.size());
}

TEST_CASE("every: a period below the clock's resolution calls at each step and does not count for ever") {
  for (const double period : {1e-15, 1e-300, std::numeric_limits<double>::denorm_min()})
    CHECK(calls(period, {0, 0, 1e-5, 0.02, 0.02, 0.04, 1, 1e6}).size() == 6);
  CHECK_THROWS_WITH(every(0, [](const Clock&) {}), "every: period = 0: must be positive");
  CHECK_THROWS_AS(every(-1, [](const Clock&) {}), error);
  CHECK_THROWS_AS(every(std::nan(""), [](const Clock&) {}), error);
}

TEST_CASE("every: checks the caller's observer, and takes in one that cannot be copied") {
  struct Counter {
    int calls = 0, ends = 0;
    std::unique_ptr<int> alone{};  // cannot be copied
    void operator()(const Clock&) { ++calls; }
    void finish(const Clock&) { ++ends; }
  };
  Counter mine;
  auto now_and_then = every(1, mine);
  for (const double t : {0.0, 0.5, 1.0, 1.2}) now_and_then(Clock{t});
  now_and_then.finish(Clock{1.2});
  CHECK(mine.calls == 2);
  CHECK(mine.ends == 1);
  CHECK(&now_and_then.called() == &mine);
  auto its_own = every(1, Counter{});
  its_own(Clock{0});
  its_own.finish(Clock{0});
  CHECK(its_own.called().calls == 1);
  CHECK(its_own.called().ends == 1);
  const auto fixed_observer = [](const Clock&) {};
  auto without_end = every(1, fixed_observer);
  without_end(Clock{0});
  STATIC_REQUIRE(has_end<decltype(now_and_then)>);
  STATIC_REQUIRE_FALSE(has_end<decltype(without_end)>);
}

TEST_CASE("every: what it calls may end the run") {
  auto ends = every(1, [](const Clock& c) { return c.time >= 2 ? RunFlow::stop : RunFlow::go_on; });
  CHECK(ends(Clock{0}) == RunFlow::go_on);
  CHECK(ends(Clock{1.5}) == RunFlow::go_on);
  CHECK(ends(Clock{2}) == RunFlow::stop);
  CHECK(ends(Clock{2.5}) == RunFlow::go_on);  // not called
  CHECK(ends(Clock{3}) == RunFlow::stop);
}

TEST_CASE("Progress: silent in a file, or a line each tenth of the run if asked for") {
  std::FILE* const file = std::tmpfile();
  REQUIRE(file != nullptr);
  Progress silent(1, {.stream = file});
  for (int k = 0; k <= 100; ++k) silent(Clock{k * 0.01, 0.01, static_cast<std::size_t>(k)});
  CHECK(text_of(file).empty());

  Progress tenths(1, {.stream = file, .tenths = true});
  for (int k = 0; k <= 100; ++k) tenths(Clock{k * 0.01, 0.01, static_cast<std::size_t>(k)});
  tenths(Clock{1, 0.01, 101});
  const std::string text = text_of(file);
  CAPTURE(text);
  CHECK(std::count(text.begin(), text.end(), '\n') == 10);
  CHECK(text.find(" 10.0 %  t = 0.10000 s  step 10  dt = 1.00e-02 s  ") == 0);
  CHECK(text.find("\n100.0 %  t = 1.00000 s  step 100  dt = 1.00e-02 s  0 s left\n") != std::string::npos);
  CHECK(text.find('\r') == std::string::npos);
  std::fclose(file);

  // A step over several tenths is one line.
  std::FILE* const other = std::tmpfile();
  Progress leaps(1, {.stream = other, .tenths = true});
  for (const double t : {0.0, 0.35, 0.39, 0.81, 1.0}) leaps(Clock{t});
  const std::string few = text_of(other);
  CHECK(std::count(few.begin(), few.end(), '\n') == 3);
  std::fclose(other);
}

#if defined(__unix__)
TEST_CASE("Progress: on a terminal one line that is rewritten, and ended at the end") {
  const int master = posix_openpt(O_RDWR | O_NOCTTY);
  REQUIRE(master >= 0);
  REQUIRE(grantpt(master) == 0);
  REQUIRE(unlockpt(master) == 0);
  const int slave = open(ptsname(master), O_RDWR | O_NOCTTY);
  REQUIRE(slave >= 0);
  std::FILE* const terminal = fdopen(slave, "w");
  REQUIRE(terminal != nullptr);
  Progress progress(2, {.stream = terminal, .tenths = true});
  progress(Clock{0});
  progress(Clock{1, 1e-3, 1000});  // too soon to be shown
  progress(Clock{2, 1e-3, 2000});
  char buffer[512];
  const auto n = read(master, buffer, sizeof buffer);
  REQUIRE(n > 0);
  const std::string text(buffer, static_cast<std::size_t>(n));
  CAPTURE(text);
  CHECK(text.find("\r100.0 %  t = 2.00000 s  step 2000  dt = 1.00e-03 s  0 s left") == 0);
  CHECK(text.find("50.0 %") == std::string::npos);
  CHECK(text.back() == '\n');
  std::fclose(terminal);
  close(master);
}
#endif
