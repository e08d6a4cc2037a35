// Co-simulation: a spring outside of the scene drives the cone; between two steps the program takes the force
// of the sand and gives the velocity.
//
//   g++ -std=c++20 -O3 -march=native -Iinclude -I/usr/include/eigen3 examples/co_simulation.cpp -o co_simulation -pthread && ./co_simulation
//   prints: after 0.050 s the cone lies 0.0323 m deep and moves at 1.037 m/s
#include <arenite/arenite.hpp>
#include <cstdio>
using namespace arenite;

int main() {
  double speed = -2;  // m/s; the scene reads it in each step
  const MohrCoulomb sand{{.density = 1540, .young = 5_MPa, .poisson = 0.33, .friction = 35_deg}};
  const ConeCylinder cone{{.radius = 0.02, .apex = 60_deg, .length = 0.3, .tip = 0.2}};
  Scene scene{Axisymmetric{},
              CartesianGrid<2>{{.lower = {0, 0}, .upper = {0.15, 0.3}, .cell = 0.01}},
              Numerics<QuadraticBSpline>{},
              bodies(fill(Box{{0, 0}, {0.15, 0.2}}, sand, {.per_cell = 4})),
              walls(bottom(fixed), right(roller)),
              gravity({0, -9.81}),
              rigids(rigid<"cone">(DistanceSurface{cone}, Prescribed{[&](double) {
                                     return std::array{0.0, speed, 0.0};
                                   }},
                                   Friction(20_deg)))};

  const auto& body = scene.rigid<"cone">();
  const double mass = 1, stiffness = 2e3, end = 0.05;  // kg, N/m, s
  while (scene.time < end) {
    const double dt = std::min(0.5 * stable_step(scene), end - scene.time);
    step(scene, dt);
    const double force = body.force[1] - stiffness * body.displacement[1] - mass * 9.81;
    speed += dt * force / mass;
  }
  std::printf("after %.3f s the cone lies %.4f m deep and moves at %.3f m/s\n", scene.time,
              -body.displacement[1], speed);
  return std::abs(-body.displacement[1] - 0.0323) < 0.0005 ? 0 : 1;
}
