// A scene of a composition that is compiled once.
#include <arenite/compositions.hpp>

int main() {
  using namespace arenite;
  const MohrCoulomb sand{{.density = 1540, .young = 1_MPa, .poisson = 0.3, .friction = 35_deg}};
  compositions::PlaneSand scene{PlaneStrain{},
                                CartesianGrid<2>{{.lower = {0, 0}, .upper = {0.4, 0.2}, .cell = 0.02}},
                                Numerics<QuadraticBSpline, Apic>{},
                                bodies(fill(Box{{0, 0}, {0.1, 0.15}}, sand)),
                                walls(bottom(fixed), left(roller), right(roller)),
                                gravity({0, -9.81})};
  run(scene, {.end = 0.01});
  return scene.steps > 0 ? 0 : 1;
}
