// The limits of the machine, measured in the same run as everything that is compared with them: the triad's
// bandwidth from the second cache, at the size of a scene of 100,000 points and at 512 MB (where a third
// cache is greater still, nothing that a scene fills reaches memory itself), and multiply-adds a second.
#include "machine.hpp"

#include <benchmark/benchmark.h>

namespace arenite::bench {
namespace {

/// Sizes, all three arrays together: half of a second-level cache of 2 MB for each thread, 64 MB, 512 MB.
void triad(benchmark::State& state, std::size_t bytes, int threads) {
  Triad arrays(bytes, threads);
  // As many passes in one parallel region as make the wake-up of threads a trifle.
  const int passes = static_cast<int>(std::max(1.0, 1e8 / arrays.bytes()));
  arrays.run(1);
  for (auto _ : state) arrays.run(passes);
  state.counters["bytes/s"] =
      benchmark::Counter(arrays.bytes() * passes, benchmark::Counter::kIsIterationInvariantRate);
  state.counters["bytes"] = arrays.bytes();
  state.counters["threads"] = threads;
}

template <class T>
void fma(benchmark::State& state) {
  constexpr int rounds = 100000;
  for (auto _ : state) benchmark::DoNotOptimize(multiply_add<T>(rounds));
  state.counters["flop/s"] =
      benchmark::Counter(fma_operations<T> * rounds, benchmark::Counter::kIsIterationInvariantRate);
  state.counters["register_bytes"] = native_register_bytes;
}

}  // namespace
}  // namespace arenite::bench

int main(int argc, char** argv) {
  using namespace arenite::bench;
  for (const int threads : {1, 2}) {
    const std::size_t in_cache = static_cast<std::size_t>(threads) << 20;
    const auto add = [&](const char* where, std::size_t bytes) {
      benchmark::RegisterBenchmark(
          ("machine/triad_" + std::string(where) + "/threads:" + std::to_string(threads)).c_str(),
          [=](benchmark::State& state) { triad(state, bytes, threads); })
          ->UseRealTime()
          ->Unit(benchmark::kMillisecond)
          ->MinTime(0.2);
    };
    add("L2", in_cache);
    add("64MB", std::size_t{64} << 20);
    add("512MB", std::size_t{512} << 20);
  }
  benchmark::RegisterBenchmark("machine/fma/double", fma<double>)->UseRealTime()->MinTime(0.1);
  benchmark::RegisterBenchmark("machine/fma/float", fma<float>)->UseRealTime()->MinTime(0.1);
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 1;
  benchmark::RunSpecifiedBenchmarks();
}
