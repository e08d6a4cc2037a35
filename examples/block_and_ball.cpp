// On a slope of 30 degrees a soft block slides over a rigid bed, and a rigid ball rolls over a soft one. Friction
// is tan(20 deg) of the block's normal force; the ball, in the plane a cylinder, accelerates by 2/3 g sin.
//
//   g++ -std=c++20 -O3 -march=native -Iinclude -I/usr/include/eigen3 examples/block_and_ball.cpp -o block_and_ball -pthread && ./block_and_ball
//   prints: block friction 0.364, exact 0.364, -0.00 %
#include <arenite/arenite.hpp>
#include <cstdio>
using namespace arenite;

const double g = 9.81, slope = 30_deg, cell_size = 0.02;

/// Gravity is tilted in place of the bed.
template <class Shape, class Body>
auto on_slope(const Shape& shape, const Body& body) {
  const MohrCoulomb rubber{
      // too strong to yield
      {.density = 2000, .young = 3_MPa, .poisson = 0.2, .friction = 45_deg, .cohesion = 1_MPa}};
  return Scene{PlaneStrain{},
               CartesianGrid<2>{{.lower = {0, 0}, .upper = {1.6, 0.4}, .cell = cell_size}},
               Numerics<QuadraticBSpline, Apic>{},
               bodies(fill(shape, rubber, {.per_cell = 4})),
               walls(left(roller), right(roller), bottom(fixed)),
               gravity({g * std::sin(slope), -g * std::cos(slope)}),
               body};
}

/// Mean along and across the slope, m/s2, from 0.2 s, when the bodies have settled, to 0.5 s.
template <class S, class Velocity>
std::array<double, 2> acceleration(S& scene, Velocity velocity) {
  run(scene, {.end = 0.2, .courant = 0.4});
  const double begin = scene.time;
  const auto before = velocity();
  run(scene, {.end = 0.5, .courant = 0.4});
  const auto after = velocity();
  return {(after[0] - before[0]) / (scene.time - begin), (after[1] - before[1]) / (scene.time - begin)};
}

bool compare(const char* name, double found, double exact) {
  std::printf("%s %.3f, exact %.3f, %+.2f %%\n", name, found, exact, 100 * (found / exact - 1));
  return std::abs(found / exact - 1) < 0.02;
}

int main() {
  const double friction = 20_deg;
  auto slides = on_slope(Box{{0.2, 0.1 + cell_size / 2}, {0.6, 0.3 + cell_size / 2}},
                         rigid(DistanceSurface{Box{{-1, -1}, {3, 0.1}}}, Prescribed{[](double) {
                                 return std::array{0.0, 0.0, 0.0};
                               }},
                               Friction(friction)));
  // The block is elastic and bounces a little: friction is compared with the mean of the normal force.
  const auto block =
      acceleration(slides, [&] { return (momentum(slides.body()) / mass(slides.body())).eval(); });

  const double radius = 0.2, kilograms = 500;        // kg a metre
  const double high = 0.1 + radius + cell_size / 2;  // contact acts half a cell outside of the ball
  auto rolls = on_slope(
      Box{{0, 0}, {1.6, 0.1}},
      rigid(DistanceSurface{Ball({0.4, high}, radius)},
            Free{.mass = kilograms, .inertia = kilograms * radius * radius / 2, .centre = {0.4, high, 0}},
            Friction(35_deg)));
  const auto ball = acceleration(rolls, [&] { return rolls.rigid().velocity; });

  const bool block_is_right =
      compare("block friction", (g * std::sin(slope) - block[0]) / (g * std::cos(slope) + block[1]),
              std::tan(friction));
  return compare("ball m/s2", ball[0], g * std::sin(slope) * 2 / 3) && block_is_right ? 0 : 1;
}
