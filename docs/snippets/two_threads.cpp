// The lines of docs/use.md, run: two scenes in two threads of a program have the bits of each alone.
#include <algorithm>
#include <arenite/arenite.hpp>
#include <thread>
using namespace arenite;

int main() {
  const MohrCoulomb sand{{.density = 1540, .young = 1_MPa, .poisson = 0.3, .friction = 35_deg}};
  const auto column = [&](double width) {
    return Scene{PlaneStrain{},
                 CartesianGrid<2>{{.lower = {0, 0}, .upper = {0.4, 0.2}, .cell = 0.02}},
                 Numerics<QuadraticBSpline, Apic>{},
                 bodies(fill(Box{{0, 0}, {width, 0.14}}, sand)),
                 walls(bottom(fixed), left(roller), right(roller)),
                 gravity({0, -9.81})};
  };
  const RunOptions options{.end = 0.05};
  set_threads(2);

  auto narrow = column(0.1), wide = column(0.2);
  std::thread other([&] { run(wide, options); });
  run(narrow, options);
  other.join();

  auto alone = column(0.1), wide_alone = column(0.2);
  run(alone, options);
  run(wide_alone, options);
  const auto same = [](const auto& a, const auto& b) {
    const auto &p = a.body().points, &q = b.body().points;
    return a.time == b.time && p.size() == q.size() &&
           std::equal(p.position.begin(), p.position.end(), q.position.begin()) &&
           std::equal(p.velocity.begin(), p.velocity.end(), q.velocity.begin());
  };
  return same(narrow, alone) && same(wide, wide_alone) && !same(narrow, wide) ? 0 : 1;
}
