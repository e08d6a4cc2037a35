// A point joins a running scene, in a program that does nothing else with points.
#include <arenite/arenite.hpp>
#include <cstdio>
using namespace arenite;

int main() {
  const LinearElastic clay{{.density = 1800, .young = 1_MPa, .poisson = 0.3}};
  Scene scene{PlaneStrain{}, CartesianGrid<2>{{.lower = {0, 0}, .upper = {0.2, 0.2}, .cell = 0.02}},
              Numerics<QuadraticBSpline>{}, bodies(fill<"clay">(Box{{0, 0}, {0.1, 0.1}}, clay))};
  const auto brought =
      insert_points<"clay">(scene, {{.position = {0.15, 0.1}, .velocity = {1, 0}, .volume = 1e-5}});
  std::printf("one point of %.3f kg joins %zu others\n", brought.mass, scene.point_count() - brought.count);
  return std::abs(brought.mass - 1800 * 1e-5) < 1e-12 && scene.point_count() == 101 ? 0 : 1;
}
