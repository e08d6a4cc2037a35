// How whole steps are timed: each repetition makes the scene again, takes it through the same first steps and
// times the same steps after them, the search for the stable step included, as `run` does it.
#pragma once

#include <benchmark/benchmark.h>

#include <memory>
#include <string>

#include "scenes.hpp"

namespace arenite::bench {

/// The parameters of one repetition.
struct Timing {
  int warm_up = 10;  ///< steps before the clock starts
  int steps = 30;    ///< steps on the clock
  int threads = 1;
  double courant = 0.4;
};

/// Rivals have their points as a member, scenes do not.
template <class Scene>
concept is_rival = requires(Scene scene) {
  scene.points;
};

template <class Scene>
void take_step(Scene& scene, double courant) {
  if constexpr (is_rival<Scene>)
    scene.step(courant * scene.stable_step());
  else
    step(scene, courant * stable_step(scene));
}

template <class Scene>
double count_points(const Scene& scene) {
  if constexpr (is_rival<Scene>)
    return static_cast<double>(scene.points.size());
  else
    return static_cast<double>(scene.point_count());
}

/// Bytes of columns a point, of a scene's first body; of the struct for a rival.
template <class Scene>
double bytes_per_point(const Scene& scene) {
  if constexpr (is_rival<Scene>)
    return sizeof(scene.points[0]);
  else
    return static_cast<double>(scene.template body<0>().points.bytes_per_point());
}

/// Registers the steps of what `make()` makes. Names read scene/scalar/who, then sizes and threads as
/// name:value.
template <class Make>
void add_steps(const std::string& name, const Timing& timing, Make make) {
  benchmark::RegisterBenchmark((name + "/threads:" + std::to_string(timing.threads)).c_str(),
                               [=](benchmark::State& state) {
                                 set_threads(timing.threads);
                                 // On the heap: scenes of many types would otherwise make one great frame.
                                 const auto scene = std::make_unique<decltype(make())>(make());
                                 for (int k = 0; k < timing.warm_up; ++k) take_step(*scene, timing.courant);
                                 for (auto _ : state) take_step(*scene, timing.courant);
                                 const double points = count_points(*scene);
                                 state.counters["points"] = points;
                                 state.counters["threads"] = timing.threads;
                                 state.counters["bytes_per_point"] = bytes_per_point(*scene);
                                 state.counters["point-steps/s"] = benchmark::Counter(
                                     points, benchmark::Counter::kIsIterationInvariantRate);
                               })
      ->UseRealTime()
      ->Unit(benchmark::kMillisecond)
      ->Iterations(timing.steps);
}

/// Whether `word` is among the arguments; takes it out, since Google Benchmark does not know it.
inline bool take_flag(int& argc, char** argv, const std::string& word) {
  bool found = false;
  int kept = 0;
  for (int i = 0; i < argc; ++i) {
    if (argv[i] == word)
      found = true;
    else
      argv[kept++] = argv[i];
  }
  argc = kept;
  return found;
}

inline int run_benchmarks(int argc, char** argv) {
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 1;
  benchmark::RunSpecifiedBenchmarks();
  return 0;
}

}  // namespace arenite::bench
