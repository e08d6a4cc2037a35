// Construction stages: a trench with vertical sides is dug in clay, stage by stage, until its side fails. The
// stability number rho g H / c at failure is known: between 3.760 and 3.786 (Pastor, Thai and Francescato
// 2000); Taylor's slip circle gives 3.83, Coulomb's wedge 4.
//
//   example.excavation [cell, m]     half of a trench of 12 m width, clay 6 m deep; cells of 0.25 m
//
//   g++ -std=c++20 -O3 -march=native -Iinclude -I/usr/include/eigen3 examples/excavation.cpp -o excavation -pthread && ./excavation
//   prints: 4.25 m deep, rho g H / c = 4.17: fails
#include <arenite/arenite.hpp>
#include <arenite/io/csv.hpp>
#include <cstdio>
#include <cstdlib>
using namespace arenite;

int main(int argc, char** argv) {
  const double cell = argc > 1 ? std::atof(argv[1]) : 0.25, depth = 6, width = 12, stage = 0.25;
  const double strength = 20_kPa, density = 2000, g = 9.81;

  // 1. Undrained clay at rest under its weight, horizontal stress equal to the vertical one.
  const MohrCoulomb clay{
      {.density = density, .young = 20_MPa, .poisson = 0.3, .friction = 0, .cohesion = strength}};
  Scene scene{PlaneStrain{},
              CartesianGrid<2>{{.lower = {0, 0}, .upper = {width, depth}, .cell = cell}},
              Numerics<QuadraticBSpline, Flip, Musl>{},
              bodies(fill<"clay">(Box{{0., 0.}, {width, depth}}, clay,
                                  {.stress = Geostatic{.surface = depth, .k0 = 1}})),
              walls(left(roller), right(roller), bottom(fixed)),
              gravity({0, -g}),
              LocalDamping{},
              TrackEnergy{}};

  // 2. Each stage takes a layer out of the right half, and lets the rest come to rest.
  double cut = 0, stood = 0, failed = 0;
  while (failed == 0 && cut < depth) {
    cut = cut < 3 ? cut + 1 : cut + stage;
    remove_points<"clay">(scene, Box{{width / 2, depth - cut}, {width, 2 * depth}});
    try {
      settle(scene, {.ratio = 1e-3, .end = scene.time + 3, .courant = 0.7});
      stood = cut;
    } catch (const run_error&) {  // it still moves after 3 s
      failed = cut;
    }
    std::printf("%.2f m deep, rho g H / c = %.2f: %s\n", cut, density * g * cut / strength,
                failed > 0 ? "fails" : "stands");
  }

  // 3. The bracket, and how fast each point moves as the side fails.
  const double low = density * g * stood / strength, high = density * g * failed / strength, exact = 3.773;
  replace_file("validation_vertical_cut.csv", [&](std::ostream& file) {
    file << "composition,quantity,unit,computed,exact\n"
         << "cells of " << cell << " m,rho g H / c: the deepest that stands,-," << low << ',' << exact
         << "\ncells of " << cell << " m,rho g H / c: the next stage fails,-," << high << ',' << exact
         << '\n';
  });
  CsvWriter map("validation_vertical_cut_map.csv", {"x (m)", "y (m)", "speed as the side fails (mm/s)"});
  const auto& points = scene.body().points;
  for (std::size_t p = 0; p < points.size(); ++p)
    map.row({points.position[p][0], points.position[p][1], 1e3 * points.velocity[p].norm()});
  return low > 0.9 * exact && high < 1.15 * exact ? 0 : 1;
}
