// Parallel loops. Every reduction works in chunks of fixed size, joined in order, so that a result does not
// depend on the number of threads.
#pragma once
// SPDX-License-Identifier: BSD-3-Clause

#include <algorithm>
#include <cstddef>
#include <vector>

#include <arenite/core/instruction_set.hpp>
#include <arenite/parallel/loop.hpp>

namespace arenite::inline ARENITE_INSTRUCTION_SET {

/// Threads that loops may use from here on; `n` < 1 leaves the number as it is. The default is that of the
/// environment's ARENITE_THREADS, else one for each processor.
inline void set_threads(int n) {
  if (n >= 1) shared_detail::set_pool_threads(n);
}

/// Threads that loops may use now.
inline int threads() { return shared_detail::pool_threads(); }

/// Calls `f(i)` for i in [0, n), in any order; on one thread unless `worthwhile`. Each thread begins with
/// its own part; the first item of part t of `parts` is `cut(t, parts)`. `f` must not throw.
template <class F, class Cut>
void parallel_for(std::size_t n, bool worthwhile, const F& f, const Cut& cut) {
  if (n == 0) return;
  // The one place where `f` is compiled: loops are most of what a scene's compilation takes.
  constexpr auto items = [](const void* body, std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) (*static_cast<const F*>(body))(i);
  };
  if (worthwhile && n > 1)
    shared_detail::run_loop(n, {items, &f,
                                [](const void* cuts, std::size_t t, std::size_t parts) -> std::size_t {
                                  return (*static_cast<const Cut*>(cuts))(t, parts);
                                },
                                &cut});
  else
    items(&f, 0, n);
}
/// A parallel loop over parts of equal length.
template <class F>
void parallel_for(std::size_t n, bool worthwhile, const F& f) {
  parallel_for(n, worthwhile, f, [n](std::size_t t, std::size_t parts) { return n * t / parts; });
}

/// Items of a chunk.
inline constexpr std::size_t chunk_size = 1024;
inline constexpr std::size_t least_items = 4 * chunk_size;  ///< fewer do not pay for threads

/// Calls `f(begin, end)` for consecutive chunks of [0, n).
template <class F>
void parallel_chunks(std::size_t n, F&& f) {
  parallel_for((n + chunk_size - 1) / chunk_size, n >= least_items,
               [&](std::size_t k) { f(k * chunk_size, std::min(n, (k + 1) * chunk_size)); });
}

/// Parts of a reduction, in memory that is kept for the next one: a step allocates nothing. A reduction
/// nested in one of the same type gets its own memory.
template <class R>
class ReductionParts {
 public:
  ReductionParts(std::size_t n, const R& start) : kept_{!in_use()} {
    auto& parts = kept_ ? store() : own_;
    in_use() = true;
    parts.assign(n, start);
    data_ = &parts;
  }
  ~ReductionParts() {
    if (kept_) in_use() = false;
  }
  ReductionParts(const ReductionParts&) = delete;
  ReductionParts& operator=(const ReductionParts&) = delete;

  R& operator[](std::size_t k) { return (*data_)[k]; }
  auto begin() const { return data_->begin(); }
  auto end() const { return data_->end(); }

 private:
  static std::vector<R>& store() {
    thread_local std::vector<R> parts;
    return parts;
  }
  static bool& in_use() {
    thread_local bool value = false;
    return value;
  }

  bool kept_;
  std::vector<R> own_;
  std::vector<R>* data_;
};

/// Joins `f(begin, end)` of all chunks of [0, n) in order: `value = join(value, part)`, from `start`.
template <class R, class F, class Join>
R parallel_reduce(std::size_t n, R start, F&& f, Join&& join) {
  const std::size_t chunks = (n + chunk_size - 1) / chunk_size;
  if (chunks == 0) return start;
  if (chunks == 1) return join(start, f(std::size_t{0}, n));
  ReductionParts<R> part(chunks, start);
  parallel_for(chunks, n >= least_items,
               [&](std::size_t k) { part[k] = f(k * chunk_size, std::min(n, (k + 1) * chunk_size)); });
  for (const R& p : part) start = join(start, p);
  return start;
}

}  // namespace arenite::inline ARENITE_INSTRUCTION_SET
