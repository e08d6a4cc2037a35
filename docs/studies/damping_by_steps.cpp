// How much energy transfers take of a motion that is smooth, by the number of steps: a free elastic bar that vibrates in its first mode
// for five periods. Writes the table of docs/transfers.md ("Damping by the number of steps"):
//
//   c++ -O3 -std=c++20 -isystem include -isystem /usr/include/eigen3 docs/studies/damping_by_steps.cpp -o damping && ./damping
//
// Some seconds on one core.
#include <arenite/arenite.hpp>
#include <array>
#include <cmath>
#include <cstdio>

using namespace arenite;

namespace {

constexpr std::array courants{0.8, 0.4, 0.2, 0.1, 0.05};

/// Share of the energy that is lost, %. The bar is 1 m long, two cells wide, at strains of 0.5 %.
template <class N>
double lost(const N& numerics, int cells, double courant) {
  const double cell = 1.0 / cells, speed = std::sqrt(1e6 / 1000.0);
  const LinearElastic rubber{{.density = 1000, .young = 1e6, .poisson = 0}};
  const auto mode = [](const auto& x) { return std::array{0.05 * std::cos(pi * x[0]), 0.0, 0.0}; };
  Scene scene{PlaneStrain{},
              CartesianGrid<2>{{.lower = {-4 * cell, 0}, .upper = {1 + 4 * cell, 2 * cell}, .cell = cell}},
              numerics,
              bodies(fill(Box{{0, 0}, {1, 2 * cell}}, rubber, {.per_cell = 4, .velocity = mode})),
              walls(bottom(roller), top(roller)),
              TrackEnergy{}};
  const auto energy = [&] { return energies(scene).kinetic + energies(scene).strain; };
  const double before = energy();
  run(scene, {.end = 5 * 2 / speed, .courant = courant, .watch = false});
  return 100 * (1 - energy() / before);
}

template <class N>
void row(const char* name, const N& numerics) {
  std::printf("| %s |", name);
  for (const int cells : {16, 32})
    for (const double courant : courants) std::printf(" %.1f |", lost(numerics, cells, courant));
  std::printf("\n");
}

}  // namespace

int main() {
  row("APIC, USL", Numerics<QuadraticBSpline, Apic, Usl>{});
  row("APIC, MUSL", Numerics<QuadraticBSpline, Apic, Musl>{});
  row("AFLIP, USL", Numerics<QuadraticBSpline, Aflip, Usl>{});
  row("FLIP, USL", Numerics<QuadraticBSpline, Flip, Usl>{});
  row("FLIP with 1 % of PIC, USL", Numerics<QuadraticBSpline, Flip, Usl>{Flip{0.99}});
  row("FLIP with a time of 0.1 s, USL", Numerics<QuadraticBSpline, Flip, Usl>{Flip{.time = 0.1}});
}
