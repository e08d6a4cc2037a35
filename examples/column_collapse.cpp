// A column of dry sand collapses, plane strain: the smallest whole scene. SI units.
//
//   g++ -std=c++20 -O3 -march=native -Iinclude -I/usr/include/eigen3 examples/column_collapse.cpp -o column_collapse -pthread && ./column_collapse
//   prints: the toe of the heap lies at x = 0.263 m after 2620 steps
#include <arenite/matter.hpp>
#include <arenite/observe/vtu.hpp>
#include <arenite/run/progress.hpp>
using namespace arenite;

int main() {
  const MohrCoulomb sand{{.density = 1540, .young = 1_MPa, .poisson = 0.3, .friction = 35_deg}};
  Scene scene{PlaneStrain{},
              CartesianGrid<2>{{.lower = {0, 0}, .upper = {0.4, 0.2}, .cell = 0.01}},
              Numerics<QuadraticBSpline>{Flip{.time = 0.1}},
              bodies(fill(Box{{0, 0}, {0.1, 0.15}}, sand, {.per_cell = 4})),
              walls(bottom(fixed), left(roller), right(roller)),
              gravity({0, -9.81})};
  run(scene, {.end = 0.4, .courant = 0.8}, Progress(0.4), every(0.1, vtu("out/column_collapse")));

  double reach = 0;
  for (const auto& x : scene.body().points.position) reach = std::max(reach, x[0]);
  std::printf("the toe of the heap lies at x = %.3f m after %zu steps\n", reach, scene.steps);
}
