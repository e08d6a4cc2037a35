// World: the ranks of MPI.
#pragma once
// SPDX-License-Identifier: BSD-3-Clause

#include <algorithm>
#include <array>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <exception>
#include <iostream>
#include <limits>
#include <span>
#include <string>
#include <string_view>
#include <thread>
#include <utility>
#include <vector>

// Without the bindings for C++ of MPI 2, which would have to be linked.
#ifndef OMPI_SKIP_MPICXX
#define OMPI_SKIP_MPICXX 1
#endif
#ifndef MPICH_SKIP_MPICXX
#define MPICH_SKIP_MPICXX 1
#endif
#include <mpi.h>

#include <arenite/core/error.hpp>
#include <arenite/core/hash.hpp>
#include <arenite/core/warning.hpp>
#include <arenite/tiles/ranks.hpp>

namespace arenite::inline ARENITE_INSTRUCTION_SET::mpi {

/// The processes of an MPI communicator. A rank that waits for others checks for failure messages, and throws if one has arrived.
class World final : public Ranks {
 public:
  /// The ranks of a host's communicator. MPI must be there, for one thread at a time (MPI_THREAD_SERIALIZED) at least.
  explicit World(MPI_Comm host = MPI_COMM_WORLD) {
    int level = 0, ready = 0;
    MPI_Initialized(&ready);
    require(ready != 0, "mpi::World", "MPI", "must be initialised: mpi::program does it, or the host");
    MPI_Query_thread(&level);
    require(level >= MPI_THREAD_SERIALIZED, "mpi::World: level of threads", level,
            "must be MPI_THREAD_SERIALIZED at least");
    MPI_Comm_rank(host, &rank_);
    MPI_Comm_size(host, &size_);
    for (MPI_Comm* comm : {&failures_, &work_}) {
      MPI_Comm made;
      MPI_Request request;
      MPI_Comm_idup(host, &made, &request);
      wait({&request, 1}, "the ranks of a scene");
      *comm = made;
    }
  }
  World(const World&) = delete;
  World& operator=(const World&) = delete;
  ~World() override {
    int over = 0;
    MPI_Finalized(&over);
    if (over != 0 || failed_ || !sent_.empty()) return;  // messages not received yet would block it
    MPI_Comm_free(&failures_);
    MPI_Comm_free(&work_);
  }

  int rank() const override { return rank_; }
  int size() const override { return size_; }
  MPI_Comm comm() const { return work_; }
  /// Whether this rank is to say why all end: it has failed by itself, and no lower rank has within a moment.
  bool speaks_of_failure() {
    for (int k = 0; k < 30 && !told_.empty() && lowest_failed_ > 0; ++k) {
      std::this_thread::sleep_for(std::chrono::milliseconds(10));
      take_failures();
    }
    return !told_.empty() && lowest_failed_ == rank_;
  }

  void swap(std::span<const Swap> with) override {
    std::vector<MPI_Request> requests;
    for (const auto& s : with) {
      MPI_Irecv(s.from.data(), count_of(s.from.size()), MPI_BYTE, s.rank, nodes, work_,
                &requests.emplace_back());
      MPI_Isend(s.to.data(), count_of(s.to.size()), MPI_BYTE, s.rank, nodes, work_, &requests.emplace_back());
    }
    wait(requests);
  }
  std::vector<std::string> exchange(std::span<const int> ranks, const std::vector<std::string>& to) override {
    std::vector<std::uint64_t> lengths(ranks.size()), expected(ranks.size());
    std::vector<Swap> swaps;
    for (std::size_t k = 0; k < ranks.size(); ++k) {
      lengths[k] = to[k].size();
      swaps.push_back({ranks[k], std::as_bytes(std::span(&lengths[k], 1)),
                       std::as_writable_bytes(std::span(&expected[k], 1))});
    }
    swap(swaps);
    std::vector<std::string> from(ranks.size());
    std::vector<MPI_Request> requests;
    for (std::size_t k = 0; k < ranks.size(); ++k) {
      from[k].resize(expected[k]);
      if (!from[k].empty())
        MPI_Irecv(from[k].data(), count_of(from[k].size()), MPI_BYTE, ranks[k], points, work_,
                  &requests.emplace_back());
      if (!to[k].empty())
        MPI_Isend(to[k].data(), count_of(to[k].size()), MPI_BYTE, ranks[k], points, work_,
                  &requests.emplace_back());
    }
    wait(requests);
    return from;
  }
  void sum(std::span<std::int64_t> numbers) override {
    MPI_Request request;
    MPI_Iallreduce(MPI_IN_PLACE, numbers.data(), count_of(numbers.size()), MPI_INT64_T, MPI_SUM, work_,
                   &request);
    wait({&request, 1});
  }
  std::vector<double> gather(const std::vector<double>& numbers) override {
    return gathered(numbers, MPI_DOUBLE, work_);
  }
  std::string gather(const std::string& bytes) override { return gathered(bytes, MPI_CHAR, work_); }
  double least(double number) override {
    MPI_Request request;
    MPI_Iallreduce(MPI_IN_PLACE, &number, 1, MPI_DOUBLE, MPI_MIN, work_, &request);
    wait({&request, 1});
    return number;
  }
  /// Waits for all ranks.
  void meet() {
    MPI_Request request;
    MPI_Ibarrier(work_, &request);
    wait({&request, 1});
  }
  void fail(const std::string& what) override {
    if (std::exchange(failed_, true)) return;
    told_ = what;
    lowest_failed_ = rank_;
    tell_others(failure);
  }
  bool agree(const Question& question, bool yes = false) override {
    if (size_ == 1) return yes;
    const std::string words = question.packed();
    Hash hash;
    hash.add(words.data(), words.size());
    said_ = {hash.value(), yes};
    heard_.resize(static_cast<std::size_t>(size_));
    MPI_Request request;
    MPI_Iallgather(said_.data(), 2, MPI_UINT64_T, heard_.data(), 2, MPI_UINT64_T, failures_, &request);
    wait({&request, 1}, question.asks);
    if (std::ranges::any_of(heard_, [&](const auto& of_rank) { return of_rank[0] != said_[0]; }))
      refuse_different(gathered(words, MPI_CHAR, failures_));
    return std::ranges::any_of(heard_, [](const auto& of_rank) { return of_rank[1] != 0; });
  }
  void leave() override { tell_others(end_of_program); }

 private:
  static constexpr int nodes = 1, points = 2;            // tags of work
  static constexpr int failure = 0, end_of_program = 1;  // and of failures
  static constexpr std::chrono::seconds grace{2}, long_wait{10};
  using Clock = std::chrono::steady_clock;

  static int count_of(std::size_t count) {
    require(count <= static_cast<std::size_t>(std::numeric_limits<int>::max()), "mpi: numbers in one message",
            count, "must be below 2^31");
    return static_cast<int>(count);
  }

  void tell_others(int tag) {
    for (int r = 0; r < size_; ++r)
      if (r != rank_)
        MPI_Isend(told_.data(), tag == failure ? count_of(told_.size()) : 0, MPI_CHAR, r, tag, failures_,
                  &sent_.emplace_back());
  }
  /// The items of all ranks, in their order.
  template <class Items>
  Items gathered(const Items& items, MPI_Datatype type, MPI_Comm comm) {
    std::vector<int> counts(static_cast<std::size_t>(size_)), first(counts.size());
    const int own = count_of(items.size());
    MPI_Request request;
    MPI_Iallgather(&own, 1, MPI_INT, counts.data(), 1, MPI_INT, comm, &request);
    wait({&request, 1});
    std::size_t count = 0;
    for (std::size_t r = 0; r < counts.size(); ++r) {
      first[r] = count_of(count);
      count += static_cast<std::size_t>(counts[r]);
    }
    Items all(count, {});
    MPI_Iallgatherv(items.data(), own, type, all.data(), counts.data(), first.data(), type, comm, &request);
    wait({&request, 1});
    return all;
  }

  /// Waits for requests; checks for failures of others from time to time. Yields, for machines with more ranks than processors. Where
  /// all ranks must ask for something, `asks` names it: others may never come.
  void wait(std::span<MPI_Request> requests, std::string_view asks = {}) {
    const auto begin = Clock::now();
    bool warned = asks.empty();
    for (unsigned k = 1;; ++k) {
      int done = 0;
      MPI_Testall(static_cast<int>(requests.size()), requests.data(), &done, MPI_STATUSES_IGNORE);
      if (done != 0) return;
      if (k % 64 != 0) continue;
      std::this_thread::yield();
      const auto now = Clock::now();
      if (failures_ != MPI_COMM_NULL) {
        look_for_failures();
        look_for_end(now);
      }
      // Others may still pass on messages that an ended rank sent earlier.
      if (ended_ >= 0 && now - std::max(begin, ended_at_) > grace) {
        failed_ = true;
        throw error(joined_text({"rank ", rank_, " asks for ", asks.empty() ? "more" : asks,
                                 " while the program of rank ", ended_,
                                 " has ended: all ranks must ask for the same"}));
      }
      if (warned || now - begin < long_wait) continue;
      warned = true;
      warn(joined_text({"rank ", rank_, " asks for ", asks, " and has waited ", long_wait.count(),
                        " s for the others, which must all ask for the same"}));
    }
  }
  void look_for_end(Clock::time_point now) {
    int there = 0;
    MPI_Status status;
    MPI_Iprobe(MPI_ANY_SOURCE, end_of_program, failures_, &there, &status);
    if (there == 0) return;
    MPI_Recv(nullptr, 0, MPI_CHAR, status.MPI_SOURCE, end_of_program, failures_, MPI_STATUS_IGNORE);
    ended_ = status.MPI_SOURCE;
    ended_at_ = now;
  }
  void look_for_failures() {
    const std::string what = take_failures();
    if (what.empty()) return;
    failed_ = true;
    throw run_error(what);
  }
  /// Receives the failure messages of other ranks; returns the first one, or nothing.
  std::string take_failures() {
    std::string all;
    for (;;) {
      int there = 0, length = 0;
      MPI_Status status;
      MPI_Iprobe(MPI_ANY_SOURCE, failure, failures_, &there, &status);
      if (there == 0) return all;
      MPI_Get_count(&status, MPI_CHAR, &length);
      std::string what(static_cast<std::size_t>(length), ' ');
      MPI_Recv(what.data(), length, MPI_CHAR, status.MPI_SOURCE, failure, failures_, MPI_STATUS_IGNORE);
      lowest_failed_ = std::min(lowest_failed_, status.MPI_SOURCE);
      if (all.empty()) all = joined_text({"rank ", status.MPI_SOURCE, ": ", what});
    }
  }

  MPI_Comm work_ = MPI_COMM_NULL, failures_ = MPI_COMM_NULL;
  int rank_ = 0, size_ = 1;
  std::array<std::uint64_t, 2> said_{};                // in `agree`: hash of the question, and whether yes
  std::vector<std::array<std::uint64_t, 2>> heard_{};  // [ranks] the same
  int ended_ = -1;                                     // a rank whose program has ended
  Clock::time_point ended_at_{};                       // when it said so
  bool failed_ = false;
  int lowest_failed_ = std::numeric_limits<int>::max();
  std::string told_{};
  std::vector<MPI_Request> sent_{};
};

/// The body of an MPI program: initialises MPI, calls `body(world)` and returns 0. If a rank fails, all end, with 1, and the one that failed
/// first writes its message to the standard error.
template <class Body>
int program(int argc, char** argv, Body&& body) {
  int level = 0;
  MPI_Init_thread(&argc, &argv, MPI_THREAD_SERIALIZED, &level);
  {
    World world;
    try {
      body(world);
      world.agree({"the end of the program"});
    } catch (const std::exception& e) {
      world.fail(e.what());
      const bool speaks = world.speaks_of_failure();
      if (speaks)
        std::cerr << "error (rank " << world.rank() << " of " << world.size() << "): " << e.what() << '\n'
                  << std::flush;
      // Others close their files; then all are ended, whatever they wait for.
      std::this_thread::sleep_for(std::chrono::seconds(speaks ? 2 : 5));
      MPI_Abort(MPI_COMM_WORLD, 1);
    }
  }
  MPI_Finalize();
  return 0;
}

}  // namespace arenite::inline ARENITE_INSTRUCTION_SET::mpi
