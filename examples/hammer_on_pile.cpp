// A hammer falls on a pile that stands on the ground: two rigid bodies that touch each other. The impact is
// inelastic: both continue with the speed m v / (m + M), and the ground stops them together.
//
//   g++ -std=c++20 -O3 -march=native -Iinclude -I/usr/include/eigen3 examples/hammer_on_pile.cpp -o hammer_on_pile -pthread && ./hammer_on_pile
//   prints: hammer -1.979 m/s (free fall -1.981), with the pile -1.583 m/s, exact -1.581 m/s
#include <arenite/arenite.hpp>
#include <cstdio>
using namespace arenite;

int main() {
  const double g = 9.81, hammer_mass = 40, pile_mass = 10, drop = 0.2;  // of the full circle
  const LinearElastic ground{{.density = 1800, .young = 5_MPa, .poisson = 0.3}};

  // In axisymmetry bodies move along the axis. The pile stands half a cell above the ground, where contact
  // acts.
  const Box pile{{-0.1, 0.52}, {0.1, 1.}}, hammer{{-0.15, 1. + drop}, {0.15, 1.4 + drop}};
  Scene scene{
      Axisymmetric{},
      CartesianGrid<2>{{.lower = {0, 0}, .upper = {1, 0.6}, .cell = 0.04}},
      Numerics<QuadraticBSpline, Apic, Usl>{},
      bodies(fill(Box{{0, 0}, {1, 0.5}}, ground, {.per_cell = 4})),
      walls(bottom(fixed), right(roller)),
      gravity({0, -g}),
      rigid<"pile">(DistanceSurface{pile}, Free{.mass = pile_mass, .centre = {0, 0.76, 0}}, Friction(20_deg)),
      rigid<"hammer">(DistanceSurface{hammer}, Free{.mass = hammer_mass, .centre = {0, 1.2 + drop, 0}},
                      Friction(20_deg)),
      RigidContact{Friction(20_deg)}};

  const auto& top = scene.rigid<"hammer">();
  const auto& below = scene.rigid<"pile">();
  const auto& contact = scene.part<RigidContact>();
  double before = 0, exact = 0, after = 0, deepest = 0;
  run(scene, {.end = 0.25, .courant = 0.4}, [&](const auto&) {
    if (contact.dissipated == 0) {
      before = top.velocity[1];  // the last step before the impact
      exact = (hammer_mass * before + pile_mass * below.velocity[1]) / (hammer_mass + pile_mass);
    } else if (after == 0 && std::abs(top.velocity[1] - below.velocity[1]) < 1e-9) {
      after = below.velocity[1];
    }
    deepest = std::min(deepest, below.displacement[1]);
  });
  std::printf("hammer %.3f m/s (free fall %.3f), with the pile %.3f m/s, exact %.3f m/s\n", before,
              -std::sqrt(2 * g * drop), after, exact);
  std::printf("pile down to %.1f mm; %.2f J lost by the impact, exact %.2f J\n", 1000 * deepest,
              contact.dissipated, before * before / 2 * hammer_mass * pile_mass / (hammer_mass + pile_mass));
  return std::abs(after / exact - 1) < 0.02 && deepest < -0.002 ? 0 : 1;
}
