// Balls dropped into loose glass beads, axisymmetric, beside the depth of Uehara, Ambroso, Ojha and Durian
// (2003, Phys. Rev. Lett. 90, 194301). Writes what docs/validation.py puts into docs/validation.md:
//
//   c++ -O3 -std=c++20 -I include -isystem /usr/include/eigen3 docs/studies/ball_in_sand.cpp -o ball &&
//   ./ball
//
// Some two minutes on two cores.
#include <arenite/arenite.hpp>
#include <cmath>
#include <cstdio>

#include "../../tests/support/validation.hpp"

using namespace arenite;

namespace {

constexpr double diameter = 0.0254, g = 9.81, bulk = 1520;
const double repose = 24_deg;  // angle of repose of the beads

/// Depth, m, from a fall of `height` above the surface: d = 0.14 / mu (rho_b / rho_g)^(1/2) D^(2/3) H^(1/3),
/// with the whole way H = height + d.
double measured(double density, double height) {
  double d = height;
  for (int k = 0; k < 100; ++k)
    d = 0.14 / std::tan(repose) * std::sqrt(density / bulk) * std::pow(diameter, 2.0 / 3) *
        std::cbrt(height + d);
  return d;
}

double penetration(double density, double height, double cell) {
  const double depth = 6 * diameter, radius = 4 * diameter, top = 2 * diameter;
  const auto whole = [&](double x) { return cell * std::round(x / cell); };
  const MohrCoulomb beads{{.density = bulk, .young = 1e6, .poisson = 0.3, .friction = repose}};
  const double mass = density * pi / 6 * std::pow(diameter, 3);
  Scene scene{
      Axisymmetric{},
      CartesianGrid<2>{{.lower = {0, -whole(depth)}, .upper = {whole(radius), whole(top)}, .cell = cell}},
      Numerics<QuadraticBSpline, Apic>{},
      bodies(fill<"beads">(Box{{0., -depth}, {radius, 0.}}, beads,
                           {.stress = Geostatic{.surface = 0, .k0 = 0.5}})),
      walls(bottom(fixed), left(roller), right(roller)),
      rigids(rigid<"ball">(DistanceSurface{Ball({0., diameter / 2}, diameter / 2)},
                           Guided{.mass = mass, .velocity = -std::sqrt(2 * g * height)}, Friction(repose))),
      gravity({0, -g})};
  run(scene, {.end = 1, .courant = 0.8}, [](const auto& s) {
    return s.template rigid<"ball">().velocity[1] < 0 ? RunFlow::go_on : RunFlow::stop;
  });
  return -scene.template rigid<"ball">().displacement[1];
}

}  // namespace

int main() {
  test::Validation validation("ball_in_sand", "measured");
  for (const double cell : {diameter / 10, diameter / 20})
    for (const double density : {700.0, 2500.0, 7800.0})
      for (const double height : {0.05, 0.2, 0.5}) {
        const double computed = penetration(density, height, cell), exact = measured(density, height);
        std::printf("%g kg/m3 from %g m, cells of %.2f mm: %.1f mm, measured %.1f mm\n", density, height,
                    1e3 * cell, 1e3 * computed, 1e3 * exact);
        std::fflush(stdout);
        validation.value(joined_text("cells of ", 1e3 * cell, " mm"),
                         joined_text("depth of a ball of ", density, " kg/m3 from ", height, " m"), "mm",
                         1e3 * computed, 1e3 * exact);
      }
}
