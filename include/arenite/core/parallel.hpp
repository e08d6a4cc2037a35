// Parallel loops with OpenMP where it is found, plain loops where it is not. Every reduction works in chunks
// of fixed size, joined in order, so that a result does not depend on the number of threads.
#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

#ifdef _OPENMP
#include <omp.h>
#endif

namespace arenite {

/// Threads that loops may use from here on; `n` < 1 leaves the number as it is.
inline void set_threads([[maybe_unused]] int n) {
#ifdef _OPENMP
  if (n >= 1) omp_set_num_threads(n);
#endif
}

inline int threads() {
#ifdef _OPENMP
  return omp_get_max_threads();
#else
  return 1;
#endif
}

/// Calls `f(i)` for i in [0, n), in any order; on one thread unless `worthwhile`: waking threads costs some
/// microseconds, and far more where other programs want the cores too. `f` must not throw.
template <class F>
void parallel_for(std::size_t n, [[maybe_unused]] bool worthwhile, F&& f) {
  const auto count = static_cast<std::ptrdiff_t>(n);
#ifdef _OPENMP
#pragma omp parallel for schedule(static) if (worthwhile && count > 1)
#endif
  for (std::ptrdiff_t i = 0; i < count; ++i) f(static_cast<std::size_t>(i));
}

inline constexpr std::size_t chunk_size = 1024;
inline constexpr std::size_t least_items = 4 * chunk_size;  ///< fewer do not pay for threads

/// Calls `f(begin, end)` for consecutive chunks of [0, n).
template <class F>
void parallel_chunks(std::size_t n, F&& f) {
  parallel_for((n + chunk_size - 1) / chunk_size, n >= least_items,
               [&](std::size_t k) { f(k * chunk_size, std::min(n, (k + 1) * chunk_size)); });
}

/// Joins `f(begin, end)` of all chunks of [0, n) in order: `value = join(value, part)`, from `start`.
template <class R, class F, class Join>
R parallel_reduce(std::size_t n, R start, F&& f, Join&& join) {
  const std::size_t chunks = (n + chunk_size - 1) / chunk_size;
  if (chunks == 0) return start;
  if (chunks == 1) return join(start, f(std::size_t{0}, n));
  std::vector<R> part(chunks, start);
  parallel_for(chunks, n >= least_items,
               [&](std::size_t k) { part[k] = f(k * chunk_size, std::min(n, (k + 1) * chunk_size)); });
  for (const R& p : part) start = join(start, p);
  return start;
}

}  // namespace arenite
