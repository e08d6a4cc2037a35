// The thread pool: each item once, whatever the threads do; loops within loops; numbers of threads that
// change.
#include "catch.hpp"

#include <arenite/parallel/parallel.hpp>
#include <array>
#include <atomic>
#include <chrono>
#include <numeric>
#include <thread>

using namespace arenite;

TEST_CASE("every item of every loop runs exactly once, on any number of threads") {
  const int before = threads();
  for (const int n : {1, 2, 3, 7, 16}) {
    CAPTURE(n);
    set_threads(n);
    REQUIRE(threads() == n);
    std::vector<int> hits;
    bool once = true;
    for (std::size_t loop = 0; loop < 3000; ++loop) {  // short ones, one right after the other
      hits.assign(loop % 67, 0);
      parallel_for(hits.size(), true, [&](std::size_t i) { ++hits[i]; });
      for (const int h : hits) once = once && h == 1;
    }
    REQUIRE(once);
  }
  set_threads(before);
}

TEST_CASE("more than one thread takes part in a long loop") {
  const int before = threads();
  set_threads(2);
  std::atomic<int> inside{0}, most{0};
  for (int attempt = 0; attempt < 50 && most < 2; ++attempt)
    parallel_for(2, true, [&](std::size_t) {
      const int now = ++inside;
      if (now > most) most = now;
      for (int k = 0; k < 1000 && inside < 2; ++k)
        std::this_thread::sleep_for(std::chrono::microseconds(100));
      --inside;
    });
  REQUIRE(most == 2);
  set_threads(before);
}

TEST_CASE("a loop within a loop runs, and so does one after a rest") {
  const int before = threads();
  set_threads(3);
  std::vector<std::vector<int>> hits(20, std::vector<int>(20, 0));
  for (int round = 0; round < 3; ++round) {
    parallel_for(hits.size(), true, [&](std::size_t i) {
      parallel_for(hits[i].size(), true, [&](std::size_t k) { ++hits[i][k]; });
    });
    std::this_thread::sleep_for(std::chrono::milliseconds(5));  // the helpers fall asleep
  }
  for (const auto& row : hits) REQUIRE(row == std::vector<int>(20, 3));
  set_threads(before);
}

TEST_CASE("two threads of the program may run loops at once") {
  const int before = threads();
  set_threads(2);
  std::array<std::vector<int>, 2> hits;
  std::array<std::thread, 2> users;
  for (std::size_t u = 0; u < 2; ++u) {
    hits[u].assign(500, 0);
    users[u] = std::thread([&, u] {
      for (int loop = 0; loop < 500; ++loop)
        parallel_for(hits[u].size(), true, [&](std::size_t i) { ++hits[u][i]; });
    });
  }
  for (auto& user : users) user.join();
  for (const auto& row : hits) REQUIRE(row == std::vector<int>(500, 500));
  set_threads(before);
}

TEST_CASE("a reduction gives the same bits on any number of threads") {
  const int before = threads();
  std::vector<double> terms(100000);
  for (std::size_t i = 0; i < terms.size(); ++i) terms[i] = 1.0 / static_cast<double>(3 * i + 1);
  const auto sum = [&] {
    return parallel_reduce(
        terms.size(), 0.0,
        [&](std::size_t begin, std::size_t end) {
          return std::accumulate(terms.begin() + static_cast<std::ptrdiff_t>(begin),
                                 terms.begin() + static_cast<std::ptrdiff_t>(end), 0.0);
        },
        std::plus<>{});
  };
  set_threads(1);
  const double alone = sum();
  REQUIRE(std::abs(alone - std::accumulate(terms.begin(), terms.end(), 0.0)) < 1e-12);
  for (const int n : {2, 3, 7}) {
    set_threads(n);
    for (int k = 0; k < 20; ++k) REQUIRE(sum() == alone);
  }
  set_threads(before);
}
