// A cylinder rolls down a slope: a rigid body with a mass, a moment of inertia and a pose, on an elastic bed.
// Without slip it accelerates by g sin / (1 + I / (m R^2)), 2/3 of a block that slides without friction.
//
//   g++ -std=c++20 -O3 -march=native -Iinclude -I/usr/include/eigen3 examples/rolling_cylinder.cpp -o rolling_cylinder -pthread && ./rolling_cylinder
//   prints: acceleration 2.208 m/s2, R times that of the spin 2.150 m/s2, exact 2.237 m/s2
#include <arenite/arenite.hpp>
#include <cstdio>
using namespace arenite;

int main() {
  const double g = 9.81, slope = 20_deg, cell = 0.02, radius = 0.4, mass = 500;  // of a metre of cylinder
  const LinearElastic rubber{{.density = 2000, .young = 3_MPa, .poisson = 0.2}};

  // Gravity is tilted instead of the bed. Contact acts half a cell outside of the body.
  const Ball cylinder({0.5, 0.1 + radius + cell / 2}, radius);
  Scene scene{PlaneStrain{},
              CartesianGrid<2>{{.lower = {0, 0}, .upper = {1.5, 0.16}, .cell = cell}},
              Numerics<QuadraticBSpline, Apic, Usl>{},
              bodies(fill(Box{{0, 0}, {1.5, 0.1}}, rubber, {.per_cell = 4})),
              walls(left(roller), right(roller), bottom(fixed)),
              gravity({g * std::sin(slope), -g * std::cos(slope)}),
              rigid<"cylinder">(DistanceSurface{cylinder},
                                Free{.mass = mass,
                                     .inertia = mass * radius * radius / 2,
                                     .centre = {0.5, 0.1 + radius + cell / 2, 0}},
                                Friction(35_deg))};

  const auto& body = scene.rigid<"cylinder">();
  run(scene, {.end = 0.3, .courant = 0.4});  // it settles into the bed
  const double begin = scene.time, speed = body.velocity[0], spin = body.spin[0];
  run(scene, {.end = 0.6, .courant = 0.4}, every(0.05, [&](const auto& s) {
        std::printf("t %.2f s: at x = %.3f m, %.3f m/s, turned by %.3f rad, %.3f rad/s, torque %.0f N m\n",
                    s.time, body.position()[0], body.velocity[0], body.orientation.angle(), body.spin[0],
                    body.torque[0]);
      }));
  const double time = scene.time - begin, exact = 2.0 / 3 * g * std::sin(slope);
  const double found = (body.velocity[0] - speed) / time, rolled = -radius * (body.spin[0] - spin) / time;
  std::printf("acceleration %.3f m/s2, R times that of the spin %.3f m/s2, exact %.3f m/s2\n", found, rolled,
              exact);
  return std::abs(found / exact - 1) < 0.03 && std::abs(rolled / exact - 1) < 0.05 ? 0 : 1;
}
