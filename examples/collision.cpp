// Two elastic discs collide and part: initial velocities, contact of bodies, and an energy balance that shows
// where the energy goes. Their momentum together stays to round-off.
//
//   g++ -std=c++20 -O3 -march=native -Iinclude -I/usr/include/eigen3 examples/collision.cpp -o collision -pthread && ./collision
//   prints: t = 0.40 s  kinetic 110.0 J  strain 12.1 J  contact 22.3 J  residual +0.8 J
#include <arenite/arenite.hpp>
#include <cstdio>
using namespace arenite;

int main() {
  const LinearElastic rubber{{.density = 1000, .young = 1_MPa, .poisson = 0.3}};
  Scene scene{PlaneStrain{},
              CartesianGrid<2>{{.lower = {0, 0}, .upper = {1, 1}, .cell = 0.02}},
              Numerics<QuadraticBSpline>{},
              bodies(fill<"left">(Ball({0.3, 0.3}, 0.15), rubber, {.per_cell = 4, .velocity = {1, 1, 0}}),
                     fill<"right">(Ball({0.7, 0.7}, 0.15), rubber, {.per_cell = 4, .velocity = {-1, -1, 0}})),
              Coulomb{Friction(0)},
              TrackEnergy{}};
  const auto total = [&]() -> Vec<double, 2> {
    return momentum(scene.body<"left">()) + momentum(scene.body<"right">());
  };
  const auto before = total();
  const double size = (mass(scene.body<"left">()) + mass(scene.body<"right">())) * std::sqrt(2.0);
  for (const double end : {0.11, 0.4}) {  // pressed together, and apart
    run(scene, {.end = end});
    const Energies e = energies(scene);
    std::printf("t = %.2f s  kinetic %.1f J  strain %.1f J  contact %.1f J  residual %+.1f J\n", scene.time,
                e.kinetic, e.strain, e.contact, e.residual);
  }
  const double change = (total() - before).norm() / size;
  const double speed = momentum(scene.body<"left">())[0] / mass(scene.body<"left">());
  std::printf("change of momentum %.1e of m v; the left disc flies off at %.8f m/s\n", change, speed);
  return change < 1e-12 && speed < -0.8 ? 0 : 1;
}
