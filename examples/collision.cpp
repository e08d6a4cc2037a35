// Two elastic blocks meet: Coulomb contact between bodies, and the energy balance that shows where it goes.
#include <arenite/arenite.hpp>
#include <cstdio>
using namespace arenite;

int main() {
  const LinearElastic rubber{{.density = 1000, .young = 1_MPa, .poisson = 0.3}};
  Scene scene{
      PlaneStrain{},
      CartesianGrid<2>{{.lower = {0, 0}, .upper = {0.5, 0.2}, .cell = 0.0125}},
      Numerics<QuadraticBSpline, Apic, Usl>{},
      bodies(fill<"left">(Box{{0.05, 0.05}, {0.2, 0.15}}, rubber, {.per_cell = 4, .velocity = {1, 0, 0}}),
             fill<"right">(Box{{0.25, 0.05}, {0.4, 0.15}}, rubber, {.per_cell = 4})),
      Coulomb{Friction(20_deg)},
      TrackEnergy{}};
  run(scene, {.end = 0.1}, every(0.02, [](const auto& s) {
        const Energies e = energies(s);
        std::printf("t = %.3f s  kinetic %.3f J  strain %.3f J  contact %.3f J  residual %+.3f J\n", s.time,
                    e.kinetic, e.strain, e.contact, e.residual);
      }));
  std::printf("velocities: %.3f and %.3f m/s\n",
              momentum(scene.body<"left">())[0] / mass(scene.body<"left">()),
              momentum(scene.body<"right">())[0] / mass(scene.body<"right">()));
}
