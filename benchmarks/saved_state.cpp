// The cost of saving and restoring a state, beside a plain copy of as many bytes into a file and back: a
// scene of tetrahedra in the working folder's file system.
#include <arenite/run/saved_state.hpp>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <vector>

#include "whole.hpp"

namespace arenite::bench {
namespace {

constexpr const char* path = "benchmark.state";

template <class Work>
void add(const std::string& name, double bytes, Work work) {
  benchmark::RegisterBenchmark(("saved_state/" + name).c_str(),
                               [bytes, work](benchmark::State& state) mutable {
                                 for (auto _ : state) work();
                                 state.counters["bytes"] = bytes;
                                 state.counters["bytes_per_second"] =
                                     benchmark::Counter(bytes, benchmark::Counter::kIsIterationInvariantRate);
                               })
      ->UseRealTime()
      ->Unit(benchmark::kMillisecond);
}

}  // namespace
}  // namespace arenite::bench

int main(int argc, char** argv) {
  using namespace arenite;
  using namespace arenite::bench;
  auto scene = tetrahedral_scene<double, NodalAveraging>(sand(), 1e5);
  step(scene, 0.4 * stable_step(scene));
  save_state(scene, path);
  const auto size = std::filesystem::file_size(path);
  const std::vector<char> bytes(size, 'x');
  std::vector<char> back(size);
  add("step", 0, [&] { step(scene, 0.4 * stable_step(scene)); });
  add("save", static_cast<double>(size), [&] { save_state(scene, path); });
  const auto write_rival = [&] {
    shared_detail::replace_file(
        "benchmark.bytes",
        [&](std::ostream& out) { out.write(bytes.data(), static_cast<std::streamsize>(size)); },
        shared_detail::Sync::disk);
  };
  write_rival();  // benchmarks run in random order: it is there before it is read
  add("save_rival", static_cast<double>(size), write_rival);
  add("restore", static_cast<double>(size), [&] { restore_state(scene, path); });
  add("restore_rival", static_cast<double>(size), [&] {
    std::ifstream("benchmark.bytes", std::ios::binary).read(back.data(), static_cast<std::streamsize>(size));
    benchmark::DoNotOptimize(back.data());
  });
  const int status = run_benchmarks(argc, argv);
  std::filesystem::remove(path);
  std::filesystem::remove("benchmark.bytes");
  return status;
}
