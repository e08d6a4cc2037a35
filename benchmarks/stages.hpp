// How the stages of a step are timed: a scene steps on between measurements, so that points move, change
// cells and yield as they do in a run, and of each step one stage counts. One thread.
#pragma once

#include <chrono>

#include "whole.hpp"

namespace arenite::bench {

enum class Stage { relocate, scatter, nodes, contact, remap, deform, whole };

/// Takes a scene or a rival through one step; calls `timed(stage, f)` for each of its stages. Stages that it
/// does not have are left out.
template <class Scene, class Timed>
void take_stages(Scene& scene, Timed&& timed) {
  if constexpr (is_rival<Scene>) {
    using T = std::remove_cvref_t<decltype(scene.points[0].mass)>;
    const T dt = static_cast<T>(0.4 * scene.stable_step());
    if constexpr (requires { scene.relocate(); }) timed(Stage::relocate, [&] { scene.relocate(); });
    timed(Stage::scatter, [&] {
      if constexpr (requires { scene.p2g(dt); })
        scene.p2g(dt);
      else
        scene.p2g();
    });
    timed(Stage::nodes, [&] { scene.update_grid(dt); });
    if constexpr (requires { scene.map_back(); }) timed(Stage::remap, [&] { scene.map_back(); });
    timed(Stage::deform, [&] { scene.g2p(dt); });
  } else {
    const double dt = 0.4 * stable_step(scene);
    timed(Stage::relocate, [&] { relocate(scene); });
    timed(Stage::scatter, [&] { p2g(scene, dt); });
    timed(Stage::nodes, [&] {
      add_forces(scene, dt);
      centre_stress(scene, dt);
      update_grid(scene, dt);
      constrain(scene, dt);
    });
    if constexpr (Scene::Needs::contact)
      timed(Stage::contact, [&] { contact_impulses(scene, dt); });
    else
      contact_impulses(scene, dt);
    if constexpr (Scene::NumericsType::maps_back) timed(Stage::remap, [&] { map_back(scene, dt); });
    timed(Stage::deform, [&] { g2p(scene, dt); });
    follow(scene, dt);
    finish(scene, dt);
  }
}

/// Registers the stages of what `make()` makes, each as name/stage.
template <class Make>
void add_stages(const std::string& name, Make make) {
  using Scene = decltype(make());
  struct Named {
    const char* word;
    Stage stage;
    bool there = true;
  };
  bool contact = false, maps_back = false, relocates = true;
  if constexpr (is_rival<Scene>) {
    maps_back = requires(Scene s) { s.map_back(); };
    relocates = requires(Scene s) { s.relocate(); };
  } else {
    contact = Scene::Needs::contact;
    maps_back = Scene::NumericsType::maps_back;
  }
  for (const Named& named : {Named{"relocate", Stage::relocate, relocates}, Named{"p2g", Stage::scatter},
                             Named{"nodes", Stage::nodes}, Named{"contact", Stage::contact, contact},
                             Named{"remap", Stage::remap, maps_back}, Named{"deform", Stage::deform},
                             Named{"step", Stage::whole}}) {
    if (!named.there) continue;
    benchmark::RegisterBenchmark(
        (name + "/" + named.word).c_str(),
        [=](benchmark::State& state) {
          set_threads(1);
          const auto scene = std::make_unique<Scene>(make());
          for (int k = 0; k < 10; ++k) take_stages(*scene, [](Stage, auto&& f) { f(); });
          for (auto _ : state) {
            double spent = 0;
            take_stages(*scene, [&](Stage stage, auto&& f) {
              const auto from = std::chrono::steady_clock::now();
              f();
              if (stage == named.stage || named.stage == Stage::whole)
                spent += std::chrono::duration<double>(std::chrono::steady_clock::now() - from).count();
            });
            state.SetIterationTime(spent);
          }
          state.counters["points"] = count_points(*scene);
        })
        ->UseManualTime()
        ->Unit(benchmark::kMillisecond)
        ->Iterations(30);  // a time to fill would take short stages through thousands of steps
  }
}

}  // namespace arenite::bench
