// World: the ranks of MPI.
#pragma once
// SPDX-License-Identifier: BSD-3-Clause

#include <algorithm>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <exception>
#include <iostream>
#include <limits>
#include <span>
#include <string>
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
#include <arenite/tiles/ranks.hpp>

namespace arenite::inline ARENITE_INSTRUCTION_SET::mpi {

/// The processes of a communicator of MPI. A rank that waits for others looks for the word of one that has failed, and throws then.
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
    MPI_Comm_dup(host, &work_);
    MPI_Comm_dup(host, &failures_);
    MPI_Comm_rank(work_, &rank_);
    MPI_Comm_size(work_, &size_);
  }
  World(const World&) = delete;
  World& operator=(const World&) = delete;
  ~World() override {
    int over = 0;
    MPI_Finalized(&over);
    if (over != 0 || failed_) return;  // what others have not taken in yet would hold it
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
    std::vector<int> counts(static_cast<std::size_t>(size_)), first(counts.size());
    const int own = count_of(numbers.size());
    MPI_Request request;
    MPI_Iallgather(&own, 1, MPI_INT, counts.data(), 1, MPI_INT, work_, &request);
    wait({&request, 1});
    std::size_t all = 0;
    for (std::size_t r = 0; r < counts.size(); ++r) {
      first[r] = count_of(all);
      all += static_cast<std::size_t>(counts[r]);
    }
    std::vector<double> gathered(all);
    MPI_Iallgatherv(numbers.data(), own, MPI_DOUBLE, gathered.data(), counts.data(), first.data(), MPI_DOUBLE,
                    work_, &request);
    wait({&request, 1});
    return gathered;
  }
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
    for (int r = 0; r < size_; ++r)
      if (r != rank_)
        MPI_Isend(told_.data(), count_of(told_.size()), MPI_CHAR, r, 0, failures_, &sent_.emplace_back());
  }

 private:
  static constexpr int nodes = 1, points = 2;  // tags

  static int count_of(std::size_t count) {
    require(count <= static_cast<std::size_t>(std::numeric_limits<int>::max()), "mpi: numbers in one message",
            count, "must be below 2^31");
    return static_cast<int>(count);
  }

  /// Waits for requests; looks for failures of others from time to time. Gives way on a machine with more ranks than processors.
  void wait(std::span<MPI_Request> requests) {
    for (unsigned k = 1;; ++k) {
      int done = 0;
      MPI_Testall(static_cast<int>(requests.size()), requests.data(), &done, MPI_STATUSES_IGNORE);
      if (done != 0) return;
      if (k % 64 != 0) continue;
      look_for_failures();
      std::this_thread::yield();
    }
  }
  void look_for_failures() {
    const std::string what = take_failures();
    if (what.empty()) return;
    failed_ = true;
    throw run_error(what);
  }
  /// What other ranks say of their failures.
  std::string take_failures() {
    std::string all;
    for (;;) {
      int there = 0, length = 0;
      MPI_Status status;
      MPI_Iprobe(MPI_ANY_SOURCE, 0, failures_, &there, &status);
      if (there == 0) return all;
      MPI_Get_count(&status, MPI_CHAR, &length);
      std::string what(static_cast<std::size_t>(length), ' ');
      MPI_Recv(what.data(), length, MPI_CHAR, status.MPI_SOURCE, 0, failures_, MPI_STATUS_IGNORE);
      lowest_failed_ = std::min(lowest_failed_, status.MPI_SOURCE);
      if (all.empty()) all = joined_text({"rank ", status.MPI_SOURCE, ": ", what});
    }
  }

  MPI_Comm work_ = MPI_COMM_NULL, failures_ = MPI_COMM_NULL;
  int rank_ = 0, size_ = 1;
  bool failed_ = false;
  int lowest_failed_ = std::numeric_limits<int>::max();
  std::string told_{};
  std::vector<MPI_Request> sent_{};
};

/// The body of a program of MPI: initialises it, calls `body(world)` and returns 0. If a rank fails, all end, with 1, and the one that failed
/// first writes its sentence to the standard error.
template <class Body>
int program(int argc, char** argv, Body&& body) {
  int level = 0;
  MPI_Init_thread(&argc, &argv, MPI_THREAD_SERIALIZED, &level);
  {
    World world;
    try {
      body(world);
      world.meet();
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
