// The collapsing column of the tests in C++: its points at an end time, s, as hexadecimal numbers; with a
// second argument the time of its steps, s, and their number.
#include <arenite/arenite.hpp>
#include <chrono>
#include <cstdio>
#include <cstdlib>
using namespace arenite;

int main(int count, char** given) {
  const MohrCoulomb sand{{.density = 1540, .young = 1_MPa, .poisson = 0.3, .friction = 35_deg}};
  const double cell = count > 2 ? std::atof(given[2]) : 0.01;
  Scene scene{PlaneStrain{},
              CartesianGrid<2>{{.lower = {0, 0}, .upper = {0.4, 0.2}, .cell = cell}},
              Numerics<QuadraticBSpline, Apic>{},
              bodies(fill(Box{{0, 0}, {0.1, 0.15}}, sand, {.per_cell = 4})),
              walls(bottom(fixed), left(roller)),
              gravity({0, -9.81}),
              TrackEnergy{}};
  const auto begin = std::chrono::steady_clock::now();
  run(scene, {.end = std::atof(given[1])});
  const std::chrono::duration<double> took = std::chrono::steady_clock::now() - begin;
  if (count > 2) {
    std::printf("%.6f %zu\n", took.count(), scene.steps);
    return 0;
  }
  std::printf("%zu\n", scene.steps);
  const auto& points = scene.body().points;
  for (std::size_t p = 0; p < points.size(); ++p) {
    const auto x = points.position[p], v = points.velocity[p];
    const auto s = points.stress[p];
    std::printf("%a %a %a %a %a %a %a %a\n", x[0], x[1], v[0], v[1], s[0], s[1], s[2], s[3]);
  }
}
