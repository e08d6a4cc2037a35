// A disc of rubber that spins: radius and energy with the strain of a step taken at its beginning and at the middle of its motion. Writes the
// table of docs/transfers.md ("Strain at the middle of the motion"):
//
//   c++ -O3 -std=c++20 -isystem include -isystem /usr/include/eigen3 docs/studies/midpoint_strain.cpp -o midpoint && ./midpoint
//
// Some minutes on one core.
#include <arenite/arenite.hpp>
#include <arenite/mesh/box_mesh.hpp>
#include <array>
#include <cmath>
#include <cstdio>

using namespace arenite;

namespace {

struct Spun {
  double radius, energy;  // over those at the start
};

/// After five turns at a rim speed of 0.05 of the wave speed.
template <class N, class Mesh>
Spun spin(const Mesh& mesh, double courant) {
  const double radius = 0.3, rate = 0.05 * std::sqrt(1e6 / 1000 * 0.7 / (1.3 * 0.4)) / radius;
  const LinearElastic rubber{{.density = 1000, .young = 1e6, .poisson = 0.3}};
  const auto turning = [&](const auto& x) {
    return std::array{-rate * (x[1] - 0.5), rate * (x[0] - 0.5), 0.0};
  };
  Scene scene{PlaneStrain{}, mesh, N{},
              bodies(fill(Ball({0.5, 0.5}, radius), rubber,
                          {.per_cell = is_simplex_mesh<Mesh> ? 3 : 4, .velocity = turning})),
              TrackEnergy{}};
  const auto size = [&] {
    double sum = 0;
    const auto& points = scene.template body<0>().points;
    for (std::size_t p = 0; p < points.size(); ++p)
      sum += (Vec<double, 2>(points.position[p]) - Vec<double, 2>(0.5, 0.5)).squaredNorm();
    return std::sqrt(sum);
  };
  const double before = size(), energy = energies(scene).kinetic;
  run(scene, {.end = 5 * 2 * pi / rate, .courant = courant, .watch = false});
  const Energies e = energies(scene);
  return {size() / before, (e.kinetic + e.strain) / energy};
}

template <class Shape, class Transfer, class Order, class Mesh>
void rows(const char* name, const Mesh& mesh) {
  for (const double courant : {0.5, 0.25}) {
    const Spun begin = spin<Numerics<Shape, Transfer, Order>>(mesh, courant),
               middle = spin<Numerics<Shape, Transfer, MidpointStrain<Order>>>(mesh, courant);
    std::printf("| %s | %.2f | %.4f | %.4f | %.4f | %.4f |\n", name, courant, begin.radius, middle.radius,
                begin.energy, middle.energy);
  }
}

}  // namespace

int main() {
  const CartesianGrid<2> grid{{.lower = {0, 0}, .upper = {1, 1}, .cell = 1.0 / 32}};
  const SimplexMesh<2> triangles{box_mesh(BoxMesh<2>{.lower = {0, 0}, .upper = {1, 1}, .bricks = {32, 32}})};
  std::printf(
      "| numerics | Courant number | radius | with MidpointStrain | energy | with MidpointStrain |\n");
  rows<QuadraticBSpline, Apic, Usl>("B-splines, APIC, USL", grid);
  rows<QuadraticBSpline, Apic, Musl>("B-splines, APIC, MUSL", grid);
  rows<QuadraticBSpline, Apic, Usf>("B-splines, APIC, USF", grid);
  rows<QuadraticBSpline, Flip, Usl>("B-splines, FLIP, USL", grid);
  rows<LinearSimplex, Tpic, Usl>("triangles, TPIC, USL", triangles);
  rows<LinearSimplex, Flip, Musl>("triangles, FLIP, MUSL", triangles);
}
