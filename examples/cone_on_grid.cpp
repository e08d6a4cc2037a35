// A cone pushed into sand at constant speed on a Cartesian grid: a rigid body with a signed distance and a
// prescribed motion, and its force as a history. No mesh to fit, no penetrometer to guide.
//
//   g++ -std=c++20 -O3 -march=native -Iinclude -I/usr/include/eigen3 examples/cone_on_grid.cpp -o cone_on_grid -pthread && ./cone_on_grid
//   prints: depth 0.0500 m  force     49.0 N on 6 nodes
#include <arenite/arenite.hpp>
#include <cstdio>
using namespace arenite;

int main() {
  const MohrCoulomb sand{
      {.density = 1540, .young = 5_MPa, .poisson = 0.33, .friction = 35_deg, .cohesion = 100}};
  const ConeCylinder cone{{.radius = 0.02, .apex = 60_deg, .length = 0.3, .tip = 0.2}};
  Scene scene{Axisymmetric{},
              CartesianGrid<2>{{.lower = {0, 0}, .upper = {0.15, 0.3}, .cell = 0.01}},
              Numerics<QuadraticBSpline>{.transfer = {.fraction = 0.99}},
              bodies(fill(Box{{0, 0}, {0.15, 0.2}}, sand,
                          {.per_cell = 4, .stress = Geostatic{.surface = 0.2, .k0 = 0.43}})),
              walls(bottom(fixed), right(roller)),
              gravity({0, -9.81}),
              rigids(rigid(DistanceSurface{cone}, Prescribed{[](double) {
                             return std::array{0.0, -1.0, 0.0};
                           }},
                           Friction(20_deg)))};
  run(scene, {.end = 0.05}, every(0.005, [](const auto& s) {
        const auto& body = s.rigid();
        std::printf("depth %.4f m  force %8.1f N on %zu nodes\n", -body.displacement[1], body.force[1],
                    body.contact_nodes);
      }));
}
