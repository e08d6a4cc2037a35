// Loops without their types, for the thread pool, which is compiled once for all loops (`parallel/loop_once.hpp`).
#pragma once
// SPDX-License-Identifier: BSD-3-Clause

#include <cstddef>

#include <arenite/core/instruction_set.hpp>

namespace arenite::inline ARENITE_INSTRUCTION_SET::shared_detail {

struct Loop {
  void (*items)(const void* body, std::size_t begin, std::size_t end);  ///< runs the items [begin, end)
  const void* body;
  /// The first item of part `part` of `parts`.
  std::size_t (*cut)(const void* cuts, std::size_t part, std::size_t parts);
  const void* cuts;
};

/// Runs the items [0, n) of a loop on the threads of the process: `ThreadPool::run`.
void run_loop(std::size_t n, const Loop& loop);

/// Threads that loops may use, the caller's among them.
int pool_threads();
void set_pool_threads(int n);

}  // namespace arenite::inline ARENITE_INSTRUCTION_SET::shared_detail

#ifndef ARENITE_COLD_LIBRARY
#include <arenite/parallel/loop_once.hpp>
#endif
