// Functions of loop.hpp that are compiled once: loops run on the thread pool.
#pragma once
// SPDX-License-Identifier: BSD-3-Clause

#include <arenite/core/cold.hpp>
#include <arenite/parallel/loop.hpp>
#include <arenite/parallel/thread_pool.hpp>

namespace arenite::inline ARENITE_INSTRUCTION_SET::shared_detail {

ARENITE_ONCE void run_loop(std::size_t n, const Loop& loop) { ThreadPool::instance().run(n, loop); }
ARENITE_ONCE int pool_threads() { return ThreadPool::instance().threads(); }
ARENITE_ONCE void set_pool_threads(int n) { ThreadPool::instance().set_threads(n); }

}  // namespace arenite::inline ARENITE_INSTRUCTION_SET::shared_detail
