// Loads in time: a bar is loaded at its end, and the wave that runs in is compared with the exact one. Both
// ways of loading a surface: on the faces of the mesh, and on points of the body.
//
//   g++ -std=c++20 -O3 -march=native -Iinclude -I/usr/include/eigen3 examples/loaded_bar.cpp -o loaded_bar -pthread && ./loaded_bar
//   prints: stress 1.0000 of the load, reaction of the wall 1.0005 of twice the load
#include <arenite/arenite.hpp>
#include <cmath>
#include <cstdio>
using namespace arenite;

// 1. Material and load: 1 kPa within a millisecond or so, then constant.
const LinearElastic steel{{.density = 7800, .young = 200_GPa, .poisson = 0.3}};
const double pressed = 1e3, length = 1, thick = 0.02;
const double wave_speed = std::sqrt(steel.wave_modulus() / steel.density());  // m/s
const Ramp in_time{.to = pressed, .over = 0.2 * length / wave_speed};

// 2. A scene: guided by rollers, so that nothing but the axial strain is left. The grid is longer than the
// bar where the load is on points.
template <class Load>
auto bar(double grid_length, const Load& load) {
  return Scene{PlaneStrain{},
               CartesianGrid<2>{{.lower = {0, 0}, .upper = {grid_length, thick}, .cell = thick / 2}},
               Numerics<QuadraticBSpline, Apic, Usl>{},
               bodies(fill<"bar">(Box{{0., 0.}, {length, thick}}, steel, {.per_cell = 4})),
               walls(left(roller), bottom(roller), top(roller)),
               load,
               Reactions{},
               TrackEnergy{}};
}

// 3. Runs until the wave has been reflected at the wall, where stresses double, and is half-way back.
template <class Scene>
bool run_and_compare(Scene scene, const char* name) {
  run(scene, {.end = 1.5 * length / wave_speed});
  const double force = reaction(scene, "left").force[0] / (2 * pressed * thick);
  double stress = 0, n = 0;
  const auto& points = scene.template body<"bar">().points;
  for (std::size_t p = 0; p < points.size(); ++p)
    if (const double x = points.position[p][0]; x > 0.6 && x < 0.9) {  // the wave has not come back there
      stress -= points.stress[p][0] / pressed;
      ++n;
    }
  const Energies e = energies(scene);
  std::printf("%-22s stress %.4f of the load, reaction of the wall %.4f of twice the load, energy off %.1e\n",
              name, stress / n, force, e.residual / e.external);
  return std::abs(stress / n - 1) < 0.01 && std::abs(force - 1) < 0.02 &&
         std::abs(e.residual) < 0.01 * e.external;
}

int main() {
  // 4. On the face of the mesh, which the bar fills.
  const bool on_face = run_and_compare(bar(length, pressure(right(), in_time)), "on the mesh's face:");
  // 5. On the points of the last layer, half a cell thick, wherever they are.
  const auto end = surface("bar", Box{{length - thick / 4, 0.}, {length, thick}},
                           {.normal = {1, 0}, .thickness = thick / 4});
  const bool on_points = run_and_compare(bar(length + 2 * thick, pressure(end, in_time)), "on points:");
  return on_face && on_points ? 0 : 1;
}
