// A steel ball falls into loose glass beads: a rigid body that is free along the axis. Measured depths: 0.14
// / mu (rho_ball / rho_beads)^(1/2) D^(2/3) H^(1/3) (Uehara, Ambroso, Ojha and Durian 2003, Phys. Rev. Lett.
// 90).
//
//   g++ -std=c++20 -O3 -march=native -Iinclude -I/usr/include/eigen3 examples/ball_into_sand.cpp -o ball_into_sand -pthread && ./ball_into_sand
//   prints: depth 36.4 mm, measured 38.2 mm, -4.6 %; at rest after 0.043 s
#include <arenite/arenite.hpp>
#include <cstdio>
using namespace arenite;

int main() {
  const double g = 9.81, diameter = 0.0254, height = 0.2, cell = diameter / 10, size = 40 * cell;
  const double repose = 24_deg;  // of the beads; taken for both angles of friction
  const MohrCoulomb beads{{.density = 1520, .young = 1_MPa, .poisson = 0.3, .friction = repose}};
  const double mass = 7800 * pi / 6 * std::pow(diameter, 3);
  Scene scene{Axisymmetric{},
              CartesianGrid<2>{{.lower = {0, -size}, .upper = {size, 20 * cell}, .cell = cell}},
              Numerics<QuadraticBSpline, Apic>{},
              bodies(fill(Box{{0., -size}, {size, 0.}}, beads,
                          {.per_cell = 4, .stress = Geostatic{.surface = 0, .k0 = 0.5}})),
              walls(bottom(fixed), left(roller), right(roller)),
              gravity({0, -g}),
              rigid<"ball">(DistanceSurface{Ball({0., diameter / 2}, diameter / 2)},
                            Guided{.mass = mass, .velocity = -std::sqrt(2 * g * height)}, Friction(repose))};
  const auto& ball = scene.rigid<"ball">();
  run(scene, {.end = 1, .courant = 0.8},
      [&](const auto&) { return ball.velocity[1] < 0 ? RunFlow::go_on : RunFlow::stop; });

  const double depth = -ball.displacement[1];
  double measured = height;
  for (int k = 0; k < 100; ++k)  // H counts from where the ball comes to rest
    measured = 0.14 / std::tan(repose) * std::sqrt(7800.0 / 1520) * std::pow(diameter, 2.0 / 3) *
               std::cbrt(height + measured);
  std::printf("depth %.1f mm, measured %.1f mm, %+.1f %%; at rest after %.3f s\n", 1e3 * depth,
              1e3 * measured, 100 * (depth / measured - 1), scene.time);
  return std::abs(depth / measured - 1) < 0.15 ? 0 : 1;
}
