// The lines of docs/restart.md, run: a column that collapses is stopped, and goes on from its saved state.
#include <arenite/arenite.hpp>
#include <arenite/observe/vtu.hpp>
#include <arenite/run/run_in_folder.hpp>
#include <arenite/run/saved_state.hpp>
#include <filesystem>
using namespace arenite;

int main() {
  const MohrCoulomb sand{{.density = 1540, .young = 1_MPa, .poisson = 0.3, .friction = 35_deg}};
  const auto make_scene = [&] {
    return Scene{PlaneStrain{},
                 CartesianGrid<2>{{.lower = {0, 0}, .upper = {0.4, 0.2}, .cell = 0.02}},
                 Numerics<QuadraticBSpline, Apic>{},
                 bodies(fill(Box{{0, 0}, {0.1, 0.15}}, sand)),
                 walls(bottom(fixed), left(roller), right(roller)),
                 gravity({0, -9.81})};
  };
  {
    auto stopped = make_scene();
    Watch watch;
    auto pictures = every(0.1, vtu("out/column"));
    run(stopped, {.end = 9.5}, watch, pictures);
    save_state(stopped, "column.state", watch, pictures);
  }
  {
    auto scene = make_scene();  // the recipe, the same in both runs
    Watch watch;
    auto pictures = every(0.1, vtu("out/column"));
    if (std::filesystem::exists("column.state")) restore_state(scene, "column.state", watch, pictures);
    run(scene, {.end = 10}, watch, pictures,
        every(0.5, [&](const auto& s) { save_state(s, "column.state", watch, pictures); }));
    if (scene.time < 10) return 1;
  }

  auto scene = make_scene();  // the recipe, the same each time
  const RunEnd end =
      run_in_folder(scene, {.end = 10}, {.folder = "out/column", .checkpoint_every = 0.5, .resume = true},
                    every(0.1, vtu("out/column/points")));
  return end == RunEnd::finished ? 0 : 1;
}
