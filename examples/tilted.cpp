// A tilted penetrometer in space: a free rigid body falls on sand with one end ahead, and turns.
//
//   g++ -std=c++20 -O3 -march=native -Iinclude -I/usr/include/eigen3 examples/tilted.cpp -o tilted -pthread && ./tilted
//   prints: it went -36.4 mm and turns at 2.90 rad/s
#include <arenite/arenite.hpp>
#include <cstdio>
using namespace arenite;

int main() {
  const double mass = 1;
  const MohrCoulomb sand{{.density = 1540, .young = 2_MPa, .poisson = 0.3, .friction = 35_deg}};
  const Capsule capsule({-0.03, 0.23, 0}, {0.03, 0.20, 0}, 0.02);  // tilted; its centre of mass in the middle
  Scene scene{ThreeDimensional{},
              CartesianGrid<3>{{.lower = {-0.12, 0, -0.08}, .upper = {0.12, 0.28, 0.08}, .cell = 0.02}},
              Numerics<QuadraticBSpline, Apic>{},
              bodies(fill(Box{{-0.12, 0, -0.08}, {0.12, 0.16, 0.08}}, sand, {.per_cell = 8})),
              walls(bottom(fixed), left(roller), right(roller), front(roller), back(roller)),
              gravity({0, -9.81, 0}),
              rigid<"penetrometer">(
                  DistanceSurface{capsule},
                  Free{.mass = mass, .inertia = 5e-4 * mass, .centre = {0, 0.215, 0}, .velocity = {0, -2, 0}},
                  Friction(20_deg))};
  run(scene, {.end = 0.05});
  const auto& body = scene.rigid<"penetrometer">();
  std::printf("it went %.1f mm and turns at %.2f rad/s\n", 1e3 * body.displacement[1], body.spin[2]);

  const double gained = mass * (body.velocity[1] + 2 + 9.81 * scene.time);  // beyond a free fall
  const double off = std::abs(body.impulse[1] / gained - 1);
  std::printf("impulse of the sand %.4f N s, off the momentum that it gained by %.0e\n", body.impulse[1],
              off);
  return std::abs(body.displacement[1] + 0.0364) < 0.0004 && off < 1e-9 ? 0 : 1;
}
