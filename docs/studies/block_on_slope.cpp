// An elastic block that lies on a rough slope, or falls onto it: how far it goes, and how far contact with a rigid body lifts it. Writes the
// rows of docs/components_contact.md ("What rests on a rigid body"):
//
//   c++ -O3 -std=c++20 -isystem include -isystem /usr/include/eigen3 docs/studies/block_on_slope.cpp -o block && ./block
//
// A minute on one core. The watch is off: what it would stop is part of the answer, and stands in the last column.
#include <algorithm>
#include <arenite/arenite.hpp>
#include <arenite/mesh/box_mesh.hpp>
#include <array>
#include <cmath>
#include <cstdio>

using namespace arenite;

namespace {

constexpr double cell = 0.02;  // m

struct Case {
  double friction, place;      // rad; of the surface above a line of the grid, cells
  double fall = 0, end = 0.5;  // m, s
  double farther_out = 0;      // surface of the rigid body, m
};

/// Travel along the slope and greatest rise across it, mm, and the energy residual, J.
template <class N, class Coupling, class Mesh>
void row(const char* name, const Mesh& mesh, const Coupling& coupling, const Case& c) {
  const double surface = 0.2 + c.place * cell, begin = surface + c.fall, off = 1e-6, slope = 30_deg;
  const auto at_rest = [](double) { return std::array{0., 0., 0.}; };
  const LinearElastic rubber{{.density = 1800, .young = 1e6, .poisson = 0.3}};
  Scene scene{PlaneStrain{},
              mesh,
              N{},
              bodies(fill(Box{{0.2, begin - off}, {0.4, begin + 0.1 - off}}, rubber,
                          {.per_cell = is_simplex_mesh<Mesh> ? 3 : 4})),
              gravity({9.81 * std::sin(slope), -9.81 * std::cos(slope)}),
              rigid(DistanceSurface{Box{{-1, -1}, {4, surface + c.farther_out}}}, Prescribed{at_rest},
                    Friction(c.friction), coupling),
              TrackEnergy{}};
  const auto centre = [&] {
    Vec<double, 2> sum = Vec<double, 2>::Zero();
    const auto& points = scene.template body<0>().points;
    double mass = 0;
    for (std::size_t p = 0; p < points.size(); ++p) {
      sum += points.mass[p] * points.position[p];
      mass += points.mass[p];
    }
    return Vec<double, 2>(sum / mass);
  };
  const Vec<double, 2> before = centre();
  double rise = 0;
  run(scene, {.end = c.end, .courant = 0.4, .watch = false},
      every(0.01, [&](const auto&) { rise = std::max(rise, centre()[1] - before[1]); }));
  std::printf("| %s | %.0f deg | %.1f | %.2f m | %.2f | %.2f | %.3f |\n", name, c.friction * 180 / pi,
              c.place, c.fall, 1e3 * (centre()[0] - before[0]), 1e3 * rise, energies(scene).residual);
}

template <class Coupling>
void rows(const char* name, const Coupling& coupling) {
  const CartesianGrid<2> grid{{.lower = {0, 0}, .upper = {3, 0.6}, .cell = cell}};
  const SimplexMesh<2> triangles{
      box_mesh(BoxMesh<2>{.lower = {0, 0}, .upper = {3, 0.6}, .bricks = {150, 30}})};
  std::printf("%s\n", name);
  for (const double place : {0.0, 0.5}) {
    const Case sticks{40_deg, place}, slides{25_deg, place}, falls{40_deg, place, 0.05, 1};
    row<Numerics<QuadraticBSpline, Apic, Musl>>("splines; APIC; MUSL", grid, coupling, sticks);
    row<Numerics<QuadraticBSpline, Flip, Usl>>("splines; FLIP; USL", grid, coupling, sticks);
    row<Numerics<QuadraticBSpline, Flip, Musl>>("splines; FLIP; MUSL", grid, coupling, sticks);
    row<Numerics<LinearSimplex, Flip, Usl>>("triangles; FLIP; USL", triangles, coupling, sticks);
    row<Numerics<LinearSimplex, Flip, Musl>>("triangles; FLIP; MUSL", triangles, coupling, sticks);
    row<Numerics<LinearSimplex, Tpic, Musl>>("triangles; TPIC; MUSL", triangles, coupling, sticks);
    row<Numerics<QuadraticBSpline, Apic, Musl>>("splines; APIC; MUSL", grid, coupling, slides);
    row<Numerics<QuadraticBSpline, Apic, Musl>>("splines; APIC; MUSL", grid, coupling, falls);
  }
}

}  // namespace

int main() {
  std::printf(
      "| numerics | friction | above a line, cells | fall | travel, mm | greatest rise, mm | residual, J "
      "|\n");
  rows("RigidVelocity", RigidVelocity{});
  rows("NodalGap", NodalGap{});
  std::printf("PointContact\n");
  const CartesianGrid<2> grid{{.lower = {0, 0}, .upper = {3, 0.6}, .cell = cell}};
  for (const double place : {0.0, 0.5}) {
    using N = Numerics<QuadraticBSpline, Flip, Usl>;
    row<N>("splines; FLIP; USL; half of a point farther out", grid, PointContact{},
           {.friction = 40_deg, .place = place, .farther_out = cell / 4});
    row<N>("splines; FLIP; USL", grid, PointContact{},
           {.friction = 40_deg, .place = place, .fall = 0.05, .end = 1});
  }
}
