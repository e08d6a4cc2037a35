// Cost of each stage of a step, in points a second, for one scene of each family; one thread. The scenes step
// on between measurements, so that points move, change cells and yield as they do in a run.
#include <benchmark/benchmark.h>

#include <chrono>

#include "scenes.hpp"

namespace arenite::bench {
namespace {

enum class Stage { relocate, scatter, nodes, remap, deform, whole };

/// Steps a scene and times one stage of each step.
template <class Make>
void run_stage(benchmark::State& state, Stage stage, Make make) {
  set_threads(1);
  auto scene = make(100000.0);
  for (int k = 0; k < 10; ++k) step(scene, 0.4 * stable_step(scene));
  for (auto _ : state) {
    const double dt = 0.4 * stable_step(scene);
    double spent = 0;
    const auto timed = [&](Stage which, auto&& f) {
      const auto from = std::chrono::steady_clock::now();
      f();
      if (which == stage || stage == Stage::whole)
        spent += std::chrono::duration<double>(std::chrono::steady_clock::now() - from).count();
    };
    timed(Stage::relocate, [&] { relocate(scene); });
    timed(Stage::scatter, [&] { scatter(scene); });
    timed(Stage::nodes, [&] {
      advance(scene, dt);
      constrain(scene);
      collide(scene, dt);
    });
    timed(Stage::remap, [&] { remap(scene); });
    timed(Stage::deform, [&] { deform(scene, dt); });
    finish(scene, dt);
    state.SetIterationTime(spent);
  }
  const auto points = static_cast<double>(scene.point_count());
  state.counters["points/s"] = benchmark::Counter(points, benchmark::Counter::kIsIterationInvariantRate);
  state.counters["points"] = points;
}

/// `remaps`: whether the scene maps velocities back to the nodes.
template <class Make>
void add(const std::string& name, bool remaps, Make make) {
  struct Named {
    const char* word;
    Stage stage;
  };
  for (const Named& named :
       {Named{"relocate", Stage::relocate}, Named{"p2g", Stage::scatter}, Named{"nodes", Stage::nodes},
        Named{"remap", Stage::remap}, Named{"deform", Stage::deform}, Named{"step", Stage::whole}}) {
    if (named.stage == Stage::remap && !remaps) continue;
    benchmark::RegisterBenchmark((name + "/" + named.word).c_str(),
                                 [=](benchmark::State& state) { run_stage(state, named.stage, make); })
        ->UseManualTime()
        ->Unit(benchmark::kMillisecond)
        ->Iterations(30);  // a time to fill would take short stages through thousands of steps
  }
}

}  // namespace
}  // namespace arenite::bench

int main(int argc, char** argv) {
  using namespace arenite;
  using namespace arenite::bench;
  add("tetrahedra_mohr_coulomb_averaged", true,
      [](double n) { return tetrahedral_scene<double, NodalAveraging>(sand(), n); });
  add("tetrahedra_mohr_coulomb_averaged_float", true,
      [](double n) { return tetrahedral_scene<float, NodalAveraging>(sand(), n); });
  add("tetrahedra_elastic", true,
      [](double n) { return tetrahedral_scene<double, NoAntiLocking>(elastic(), n); });
  add("bspline_3d_apic_drucker_prager", false, [](double n) { return spline_scene<double, 3>(grains(), n); });
  add("bspline_2d_apic_elastic", false, [](double n) { return spline_scene<double, 2>(elastic(), n); });
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 1;
  benchmark::RunSpecifiedBenchmarks();
}
