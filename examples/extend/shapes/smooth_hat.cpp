// An elastic bar on a shape function of your own: fixed at one end, free at the other, in its first mode. The
// library does not change; smooth_hat.hpp has the functions of a cell along one axis, and nothing else.
#include "smooth_hat.hpp"

#include <cstdio>
using namespace arenite;

int main() {
  const double length = 1, h = 0.1, k = pi / 2;
  const LinearElastic steel{{.density = 1000, .young = 1e5, .poisson = 0.25}};
  Scene scene{PlaneStrain{}, CartesianGrid<2>{{.lower = {0, 0}, .upper = {length + 4 * h, h}, .cell = h}},
              Numerics<SmoothHat, Apic, Usl>{},
              bodies(fill(Box{{0., 0.}, {length, h}}, steel, {.per_cell = 4})),
              walls(left(roller), bottom(roller), top(roller))};
  auto& points = scene.body().points;
  for (std::size_t p = 0; p < points.size(); ++p)
    points.velocity.set(p, Vec<double, 2>(0.01 * std::sin(k * points.position[p][0]), 0));

  const double period = 2 * pi / (k * std::sqrt(steel.wave_modulus() / steel.density()));
  double before = 0, then = 0, half_period = 0;  // when the bar turns round
  run(scene, {.end = 0.9 * period, .courant = 0.5}, [&](const auto& s) {
    const double now = momentum(s.body())[0];
    if (before < 0 && now >= 0 && half_period == 0)
      half_period = 2.0 / 3 * (then + (s.time - then) * before / (before - now));
    before = now;
    then = s.time;
  });
  std::printf("half a period: %.5f s, exact %.5f s\n", half_period, period / 2);
  return std::abs(half_period / (period / 2) - 1) < 0.3 * square(k * h) ? 0 : 1;
}
