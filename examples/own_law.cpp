// A law of your own, the class HardeningMetal of own_law.hpp: along a path of strains, without a scene, and
// in a rod that hits a wall (Taylor's test).
//
//   g++ -std=c++20 -O3 -march=native -Iinclude -I/usr/include/eigen3 examples/own_law.cpp -o own_law -pthread && ./own_law
//   prints: sheared in 1000 steps: 234.091974 MPa, exact: 234.091974 MPa
#include "own_law.hpp"

#include <cstdio>
using namespace arenite;

int main() {
  const double shear = 43e9, strength = 400e6, hardening = 100e6;  // copper, Pa
  const HardeningMetal copper{{.density = 8930,
                               .young = 2 * 1.35 * shear,
                               .poisson = 0.35,
                               .strength = strength,
                               .hardening = hardening}};

  // A law works without a scene. Sheared to gamma, the metal carries the yield stress in shear and G H/(3 G +
  // H) of the strain beyond it, in 10 steps as in 1000.
  const double gamma = 0.1, yield = strength / std::sqrt(3.0);
  const double tangent = shear * hardening / (3 * shear + hardening);
  const double exact = yield + tangent * (gamma - yield / shear);
  for (const int steps : {10, 100, 1000}) {
    Sym<double, 3> stress;
    HardeningMetal::History<double> history;
    StrainStep<double, 3> step;
    step.strain[3] = gamma / 2 / steps;
    for (int k = 0; k < steps; ++k) copper.update(stress, step, history);
    std::printf("sheared in %4d steps: %.6f MPa, exact: %.6f MPa\n", steps, stress[3] / 1e6, exact / 1e6);
    if (!(std::abs(stress[3] / exact - 1) < 1e-12)) return 1;
  }

  const double length = 32.4e-3, radius = 3.2e-3;
  Scene scene{Axisymmetric{}, CartesianGrid<2>{{.lower = {0, 0}, .upper = {9.6e-3, 33.6e-3}, .cell = 0.8e-3}},
              Numerics<QuadraticBSpline, Apic>{},
              bodies(fill(Box{{0, 0}, {radius, length}}, copper, {.per_cell = 4, .velocity = {0, -227, 0}})),
              walls(left(roller), bottom(roller))};
  run(scene, {.end = 80e-6, .courant = 0.4});
  double top = 0, plastic = 0;
  const auto& points = scene.body().points;
  for (std::size_t p = 0; p < points.size(); ++p) {
    top = std::max(top, points.position[p][1]);
    plastic = std::max(plastic, points.load_history(p).plastic);
  }
  std::printf("the rod of %.1f mm is %.2f mm long, plastic strain up to %.2f\n", length * 1e3, top * 1e3,
              plastic);
}
