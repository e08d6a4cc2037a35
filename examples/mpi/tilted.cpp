// How does a tilted penetrometer move in sand that is too large for one machine? examples/tilted.cpp, cut into tiles.
//
//   mpicxx -std=c++20 -O3 -march=native -Iinclude -I/usr/include/eigen3 examples/mpi/tilted.cpp -o tilted -pthread && mpirun -n 2 ./tilted
//   prints: it went -36.4 mm and turns at 2.90 rad/s
//
// mpirun -n 2 ./tilted 0.0017 20: cells of 1.7 mm, ten million points, the first 20 steps
#include <arenite/arenite.hpp>
#include <arenite/mpi.hpp>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <limits>
using namespace arenite;

int main(int argc, char** argv) {
  return mpi::program(argc, argv, [&](mpi::World& world) {
    const double cell = argc > 1 ? std::atof(argv[1]) : 0.02;
    const std::size_t most =
        argc > 2 ? std::strtoul(argv[2], nullptr, 10) : std::numeric_limits<std::size_t>::max();
    const auto whole = [cell](double length) { return cell * std::ceil(length / cell - 1e-9); };  // cells
    const double x = whole(0.12), y = whole(0.28), z = whole(0.08);
    const MohrCoulomb sand{{.density = 1540, .young = 2_MPa, .poisson = 0.3, .friction = 35_deg}};
    const Capsule capsule({-0.03, 0.23, 0}, {0.03, 0.20, 0}, 0.02);
    const auto make = [&](auto mesh, auto portion) {
      return Scene{ThreeDimensional{},
                   mesh,
                   Numerics<QuadraticBSpline, Apic>{},
                   bodies(fill(Box{{-x, 0, -z}, {x, 0.16, z}}, sand, {.per_cell = 8})),
                   walls(bottom(fixed), left(roller), right(roller), front(roller), back(roller)),
                   gravity({0, -9.81, 0}),
                   rigid<"penetrometer">(
                       DistanceSurface{capsule},
                       Free{.mass = 1, .inertia = 5e-4, .centre = {0, 0.215, 0}, .velocity = {0, -2, 0}},
                       Friction(20_deg)),
                   portion};
    };
    const CartesianGrid<3> grid{{.lower = {-x, 0, -z}, .upper = {x, y, z}, .cell = cell}};
    std::vector<double> weights;  // there is sand in the lower cells
    for (Index c = 0; c < grid.cell_count(); ++c) weights.push_back(grid.corner(c)[1] < 0.16 ? 1 : 0.01);
    auto scene = distribute(world, grid, {.tiles = 8, .weights = weights}, make);
    const double points = scene.sum([](const auto& tile) { return tile.point_count(); });
    const auto start = std::chrono::steady_clock::now();
    run(scene, {.end = 0.05}, rebalancing(make),
        [most](const auto& tile) { return tile.steps >= most ? RunFlow::stop : RunFlow::go_on; });
    const double took = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    scene.for_each_tile([&](const auto& tile) {
      if (!tile.communicator().first()) return;
      const auto& body = tile.template rigid<"penetrometer">();
      std::printf("it went %.1f mm and turns at %.2f rad/s\n", 1e3 * body.displacement[1], body.spin[2]);
      std::printf("%.0f points on %d ranks, %zu steps of %.3g s\n", points, world.size(), tile.steps,
                  took / static_cast<double>(tile.steps));
    });
  });
}
