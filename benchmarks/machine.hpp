// The machine's own limits, to compare others with: how fast it moves memory and how fast it multiplies
// and adds.
#pragma once

#include <arenite/parallel/parallel.hpp>
#include <arenite/simd/pack.hpp>
#include <arenite/transfer/numerics.hpp>
#include <array>
#include <cstddef>
#include <memory>

namespace arenite::bench {

/// a = b + s c (STREAM's triad) over three arrays. Each thread owns one part and touches it first.
class Triad {
 public:
  /// `bytes` of all three arrays together.
  Triad(std::size_t bytes, int threads)
      : n_(bytes / (3 * sizeof(double)) / static_cast<std::size_t>(threads)),
        threads_(threads),
        // for_overwrite: pages come to be where the thread that works on them first writes
        a_(std::make_unique_for_overwrite<double[]>(n_ * static_cast<std::size_t>(threads))),
        b_(std::make_unique_for_overwrite<double[]>(n_ * static_cast<std::size_t>(threads))),
        c_(std::make_unique_for_overwrite<double[]>(n_ * static_cast<std::size_t>(threads))) {
    set_threads(threads_);
    parallel_for(static_cast<std::size_t>(threads_), true, [&](std::size_t t) {
      for (std::size_t k = t * n_; k < (t + 1) * n_; ++k) {
        a_[k] = 0;
        b_[k] = 1;
        c_[k] = 2;
      }
    });
  }

  /// Bytes that one pass reads and writes (what the write of `a` fetches first is not counted, as in STREAM).
  double bytes() const { return 24.0 * static_cast<double>(n_) * threads_; }

  void run(int passes) {
    parallel_for(static_cast<std::size_t>(threads_), true, [&](std::size_t t) {
      const std::size_t from = t * n_;
      for (int pass = 0; pass < passes; ++pass) {
        part(&a_[from], &b_[from], &c_[from], n_);
        asm volatile("" : : "r"(a_.get()) : "memory");  // no pass may be left out
      }
    });
  }

 private:
  static void part(double* __restrict a, const double* __restrict b, const double* __restrict c,
                   std::size_t n) {
    for (std::size_t i = 0; i < n; ++i) a[i] = b[i] + 3.0 * c[i];
  }

  std::size_t n_;
  int threads_;
  std::unique_ptr<double[]> a_, b_, c_;
};

/// Multiply-adds in enough independent chains to fill the pipelines: `rounds` times `fma_operations<T>`
/// floating point operations on one core.
inline constexpr std::size_t fma_chains = 12;
template <class T>
inline constexpr double fma_operations = 2.0 * fma_chains* native_register_bytes / sizeof(T);

template <class T>
T multiply_add(int rounds) {
  using V = typename Pack<T, static_cast<int>(native_register_bytes / sizeof(T))>::vector;
  V chain[fma_chains];
  for (std::size_t k = 0; k < fma_chains; ++k) chain[k] = V{} + static_cast<T>(k);
  V factor = V{} + static_cast<T>(0.999), term = V{} + static_cast<T>(0.001);
  asm volatile("" : "+x"(factor), "+x"(term));  // the compiler must not know them
  for (int round = 0; round < rounds; ++round)
    for (std::size_t k = 0; k < fma_chains; ++k) chain[k] = chain[k] * factor + term;
  V sum = V{};
  for (std::size_t k = 0; k < fma_chains; ++k) sum += chain[k];
  return sum[0];
}

}  // namespace arenite::bench
