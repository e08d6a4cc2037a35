// Steps one scene of each composition and writes all numbers of its points. Compiled twice: with the
// compositions of arenite::compositions, and (HEADERS_ALONE) from the headers.
#ifdef HEADERS_ALONE
#include <arenite/arenite.hpp>
#else
#include <arenite/compositions.hpp>
#endif
#include <cstdio>

using namespace arenite;

namespace {

MohrCoulomb<> sand() {
  return MohrCoulomb<>{{.density = 1540, .young = 1_MPa, .poisson = 0.3, .friction = 35_deg}};
}

template <class Scene>
void show(Scene scene) {
  for (int k = 0; k < 30; ++k) step(scene, 0.4 * stable_step(scene));
  std::printf("%a", scene.time);
  scene.body().points.for_each_column([](const auto& column) {
    for (const auto& x : column) std::printf(" %a", static_cast<double>(x));
  });
  scene.for_each_rigid([](const auto& body) { std::printf(" %a %a", body.velocity[1], body.impulse[1]); });
  std::printf("\n");
}

}  // namespace

int main() {
  const CartesianGrid<2> plane({.lower = {0, 0}, .upper = {0.4, 0.2}, .cell = 0.02});
  const CartesianGrid<3> space({.lower = {0, 0, 0}, .upper = {0.2, 0.2, 0.2}, .cell = 0.02});
  const auto box = fill(Box{{0, 0}, {0.1, 0.15}}, sand());
  const auto cube = fill(Inside{[](const auto& x) { return x.maxCoeff() - 0.12; }}, sand(), {.per_cell = 8});
  show(Scene{PlaneStrain{}, plane, Numerics<QuadraticBSpline, Apic>{}, bodies(box), walls(bottom(fixed)),
             gravity({0, -9.81})});
  show(Scene{Axisymmetric{}, plane, Numerics<QuadraticBSpline>{}, bodies(box), walls(bottom(fixed)),
             gravity({0, -9.81}),
             rigid(DistanceSurface{ConeCylinder({.radius = 0.03, .apex = 1, .length = 0.1, .tip = 0.15})},
                   Prescribed{[](double) {
                     return std::array{0.0, -1.0, 0.0};
                   }},
                   Friction(20_deg))});
  show(Scene{ThreeDimensional{}, space, Numerics<QuadraticBSpline, Apic>{}, bodies(cube),
             walls(bottom(roller)), gravity({0, -9.81, 0})});
  show(Scene{
      ThreeDimensional{}, space, Numerics<QuadraticBSpline, Apic>{}, bodies(cube), walls(bottom(roller)),
      gravity({0, -9.81, 0}),
      rigid(DistanceSurface{[](const auto& x) { return 0.12 - x[1]; }}, Guided{.mass = 1}, Friction(0))});
}
