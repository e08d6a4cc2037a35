// A dam breaks: water is a law of one's own (extend/laws). Shallow water's wave (Ritter 1892) is 4/9 of the
// depth where the dam was, and 8/27 h sqrt(g h) of water a second passes there.
//
//   g++ -std=c++20 -O3 -march=native -Iinclude -I/usr/include/eigen3 examples/dam_break.cpp -o dam_break -pthread && ./dam_break
//   prints: at the dam 0.465 of the depth, theory 0.444; flow 0.281 h sqrt(g h), theory 0.296
#include <cstdio>

#include "extend/laws/newtonian_fluid.hpp"
using namespace arenite;

int main() {
  // 1. Sound is 20 times as fast as the wave; before the wave that runs back reaches the reservoir's end, all
  // is over.
  const double depth = 0.2, g = 9.81, cell = 0.0125, reservoir = 5 * depth, density = 1000;
  const double wave = std::sqrt(g * depth), time = 4 * depth / wave;
  const NewtonianFluid water{
      {.density = density, .bulk = density * std::pow(20 * wave, 2), .viscosity = 1e-3}};
  Scene scene{PlaneStrain{},
              CartesianGrid<2>{{.lower = {-reservoir, 0}, .upper = {9 * depth, 1.25 * depth}, .cell = cell}},
              Numerics<QuadraticBSpline, Apic>{},
              bodies(fill(Box{{-reservoir, 0.}, {0., depth}}, water,
                          {.per_cell = 4, .stress = Geostatic{.surface = depth, .k0 = 1, .may_move = true}})),
              walls(bottom(roller), left(roller)),
              gravity({0, -g})};
  run(scene, {.end = time});

  // 2. Water over the length of four cells at the dam, and all that has passed it.
  double there = 0, passed = 0;
  const auto& points = scene.body().points;
  for (std::size_t p = 0; p < points.size(); ++p) {
    const double x = points.position[p][0], area = points.mass[p] / density;
    if (std::abs(x) < 2 * cell) there += area / (4 * cell * depth);
    if (x > 0) passed += area / (time * wave * depth);
  }
  std::printf("at the dam %.3f of the depth, theory %.3f; flow %.3f h sqrt(g h), theory %.3f\n", there,
              4. / 9, passed, 8. / 27);
  return std::abs(there / (4. / 9) - 1) < 0.08 && std::abs(passed / (8. / 27) - 1) < 0.08 ? 0 : 1;
}
