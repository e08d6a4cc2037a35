// A pile from an STL file, in place before the sand is filled around it, then pushed down: read, checked for
// leaks, weighed, cut out of the sand and used as a rigid body. Its history goes to a table.
//
//   g++ -std=c++20 -O3 -march=native -Iinclude -I/usr/include/eigen3 examples/stl_body.cpp -o stl_body -pthread && ./stl_body
//   prints: depth 0.020 m, force   274.3 N on 36 nodes
#include <arenite/arenite.hpp>
#include <arenite/geometry/triangle_surface.hpp>
#include <arenite/io/output_file.hpp>
#include <arenite/io/stl.hpp>
#include <arenite/observe/csv.hpp>
#include <cstdio>
#include <ostream>
using namespace arenite;

/// A file as of a CAD program, in millimetres: a six-sided pile, radius 50, its tip 80 high, 250 long.
void write_pile(std::ostream& file) {
  const auto corner = [](int k, double y) {
    return std::array{50 * std::cos(k * pi / 3), y, 50 * std::sin(k * pi / 3)};
  };
  const auto facet = [&](std::initializer_list<std::array<double, 3>> corners) {
    file << "facet normal 0 0 0\nouter loop\n";
    for (const auto& [x, y, z] : corners) file << "vertex " << x << ' ' << y << ' ' << z << '\n';
    file << "endloop\nendfacet\n";
  };
  file << "solid pile\n";
  for (int k = 0; k < 6; ++k) {
    const int next = (k + 1) % 6;
    facet({{0, 0, 0}, corner(k, 80), corner(next, 80)});
    facet({corner(k, 80), corner(k, 250), corner(next, 250)});
    facet({corner(k, 80), corner(next, 250), corner(next, 80)});
    facet({{0, 250, 0}, corner(next, 250), corner(k, 250)});
  }
  file << "endsolid pile\n";
}

int main() {
  replace_file("pile.stl", [](std::ostream& file) { write_pile(file); });
  const TriangleSurface pile(read_stl("pile.stl", 1e-3));  // throws unless closed
  const double steel = mass_properties(pile, 7850).mass;

  // The tip lies in the sand, up to where the shaft begins.
  const auto placed_pile = placed(pile, {.at = {0.16, 0.12, 0.16}});
  const Box<3> ground{{0, 0, 0}, {0.32, 0.2, 0.32}};
  const MohrCoulomb sand{
      {.density = 1540, .young = 5_MPa, .poisson = 0.33, .friction = 35_deg, .cohesion = 100}};
  Scene scene{ThreeDimensional{},
              CartesianGrid<3>{{.lower = {0, 0, 0}, .upper = {0.32, 0.32, 0.32}, .cell = 0.02}},
              Numerics<QuadraticBSpline>{.transfer = {.fraction = 0.99}},
              bodies(fill<"sand">(ground - placed_pile, sand,
                                  {.per_cell = 8, .stress = Geostatic{.surface = 0.2, .k0 = 0.43}})),
              walls(bottom(fixed), left(roller), right(roller), front(roller), back(roller)),
              gravity({0, -9.81, 0}),
              rigids(rigid<"pile">(DistanceSurface{placed_pile}, Prescribed{[](double) {
                                     return std::array{0.0, -0.5, 0.0};
                                   }},
                                   Friction(20_deg)))};
  const double tip = 0.5 * std::sqrt(3) * 0.05 * 0.05 * 0.08;  // volume of the six-sided pyramid
  const double filled = scene.body().initial_volume, expected = 0.32 * 0.32 * 0.2 - tip;
  std::printf("pile %.2f kg, sand %.6f m3, box less tip %.6f m3\n", steel, filled, expected);

  run(scene, {.end = 0.04},
      every(0.004,
            csv("pile.csv", CsvColumn{"depth", [](const auto& s) { return -s.rigid().displacement[1]; }},
                CsvColumn{"force", [](const auto& s) { return s.rigid().force; }})),
      every(0.01, [](const auto& s) {
        std::printf("depth %.3f m, force %7.1f N on %zu nodes\n", -s.rigid().displacement[1],
                    s.rigid().force[1], s.rigid().contact_nodes);
      }));
  return std::abs(filled / expected - 1) < 1e-3 && scene.rigid().force[1] > 0 ? 0 : 1;
}
