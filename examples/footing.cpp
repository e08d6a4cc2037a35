// A strip footing is pushed into weightless clay: a driven wall, its reaction, and local damping. The mean
// pressure at failure is (2 + pi) c (Prandtl 1920).
//
//   g++ -std=c++20 -O3 -march=native -Iinclude -I/usr/include/eigen3 examples/footing.cpp -o footing -pthread && ./footing
//   prints: pressure 5.110 c, exact 5.142 c, -0.6 %
#include <arenite/arenite.hpp>
#include <cstdio>
using namespace arenite;

int main() {
  const double half = 0.5, strength = 20_kPa, speed = 0.01, end = 0.45;  // of the footing m; Pa, m/s, s
  const MohrCoulomb clay{
      {.density = 2000, .young = 1e4 * strength, .poisson = 0.3, .friction = 0, .cohesion = strength}};
  const auto below = [&](const auto& x) { return x[0] <= half * (1 + 1e-9) && x[1] > 2 - 1e-9; };
  Scene scene{
      PlaneStrain{},
      CartesianGrid<2>{{.lower = {0, 0}, .upper = {3, 2}, .cell = 0.125}},
      Numerics<QuadraticBSpline>{},
      bodies(fill(Box{{0, 0}, {3, 2}}, clay, {.per_cell = 4})),
      walls(left(roller), right(roller), bottom(fixed)),
      driven(named("footing", where(below, symmetry({0, 1, 0}))), {0, -speed, 0}, Ramp{.over = 0.2 * end}),
      LocalDamping{},
      Reactions{}};
  run(scene, {.end = 0.9 * end, .courant = 0.9});
  const double before = reaction(scene, "footing").impulse[1];
  const double begin = scene.time;
  run(scene, {.end = end, .courant = 0.9});
  const double force = -(reaction(scene, "footing").impulse[1] - before) / (scene.time - begin);

  const double found = force / half / strength, exact = 2 + pi;
  std::printf("pressure %.3f c, exact %.3f c, %+.1f %%\n", found, exact, 100 * (found / exact - 1));
  return std::abs(found / exact - 1) < 0.02 ? 0 : 1;
}
