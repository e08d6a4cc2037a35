// Loops on the threads of the process, by functions that are compiled once for all of them.
#pragma once
// SPDX-License-Identifier: BSD-3-Clause

#include <cstddef>

#include <arenite/core/cold.hpp>
#include <arenite/core/instruction_set.hpp>
#include <arenite/parallel/loop_items.hpp>

namespace arenite::inline ARENITE_INSTRUCTION_SET::shared_detail {

/// Runs the items [0, n) of a loop on the threads of the process: `ThreadPool::run`.
void run_loop(std::size_t n, const Loop& loop);

/// Threads that loops may use, the caller's among them.
int pool_threads();
void set_pool_threads(int n);

}  // namespace arenite::inline ARENITE_INSTRUCTION_SET::shared_detail

#if ARENITE_HAS_COLD

#include <arenite/parallel/thread_pool.hpp>

namespace arenite::inline ARENITE_INSTRUCTION_SET::shared_detail {

ARENITE_ONCE void run_loop(std::size_t n, const Loop& loop) { ThreadPool::instance().run(n, loop); }
ARENITE_ONCE int pool_threads() { return ThreadPool::instance().threads(); }
ARENITE_ONCE void set_pool_threads(int n) { ThreadPool::instance().set_threads(n); }

}  // namespace arenite::inline ARENITE_INSTRUCTION_SET::shared_detail

#endif  // ARENITE_HAS_COLD
