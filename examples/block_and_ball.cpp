// On a slope of 30 degrees a soft block slides over a rigid bed, and a rigid ball rolls over a soft one. The
// block accelerates by g (sin - mu cos); the ball, in the plane a cylinder, by 2/3 g sin.
//
//   g++ -std=c++20 -O3 -march=native -Iinclude -I/usr/include/eigen3 examples/block_and_ball.cpp -o block_and_ball -pthread && ./block_and_ball
//   prints: block 1.803 m/s2, exact 1.813 m/s2, -0.53 %
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

/// Along the slope, m/s2, from 0.2 s, when the bodies have settled, to 0.5 s.
template <class S, class Speed>
double acceleration(S& scene, Speed speed) {
  run(scene, {.end = 0.2, .courant = 0.4});
  const double begin = scene.time, before = speed();
  run(scene, {.end = 0.5, .courant = 0.4});
  return (speed() - before) / (scene.time - begin);
}

bool compare(const char* name, double found, double exact) {
  std::printf("%s %.3f m/s2, exact %.3f m/s2, %+.2f %%\n", name, found, exact, 100 * (found / exact - 1));
  return std::abs(found / exact - 1) < 0.02;
}

int main() {
  const double friction = 20_deg;
  auto slides = on_slope(Box{{0.2, 0.1 + cell_size / 2}, {0.6, 0.3 + cell_size / 2}},
                         rigid(DistanceSurface{Box{{-1, -1}, {3, 0.1}}}, Prescribed{[](double) {
                                 return std::array{0.0, 0.0, 0.0};
                               }},
                               Friction(friction)));
  const double block = acceleration(slides, [&] { return momentum(slides.body())[0] / mass(slides.body()); });

  const double radius = 0.2, kilograms = 500;        // kg a metre
  const double high = 0.1 + radius + cell_size / 2;  // contact acts half a cell outside of the ball
  auto rolls = on_slope(
      Box{{0, 0}, {1.6, 0.1}},
      rigid(DistanceSurface{Ball({0.4, high}, radius)},
            Free{.mass = kilograms, .inertia = kilograms * radius * radius / 2, .centre = {0.4, high, 0}},
            Friction(35_deg)));
  const double ball = acceleration(rolls, [&] { return rolls.rigid().velocity[0]; });

  const bool block_is_right =
      compare("block", block, g * (std::sin(slope) - std::tan(friction) * std::cos(slope)));
  return compare("ball", ball, g * std::sin(slope) * 2 / 3) && block_is_right ? 0 : 1;
}
