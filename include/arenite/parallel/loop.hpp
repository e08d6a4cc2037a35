// Loops on the threads of the process, by functions that are compiled once for all of them (`parallel/loop_once.hpp`).
#pragma once
// SPDX-License-Identifier: BSD-3-Clause

#include <cstddef>

#include <arenite/core/instruction_set.hpp>
#include <arenite/parallel/loop_items.hpp>

namespace arenite::inline ARENITE_INSTRUCTION_SET::shared_detail {

/// Runs the items [0, n) of a loop on the threads of the process: `ThreadPool::run`.
void run_loop(std::size_t n, const Loop& loop);

/// Threads that loops may use, the caller's among them.
int pool_threads();
void set_pool_threads(int n);

}  // namespace arenite::inline ARENITE_INSTRUCTION_SET::shared_detail

#ifndef ARENITE_COLD_LIBRARY
#include <arenite/parallel/loop_once.hpp>
#endif
