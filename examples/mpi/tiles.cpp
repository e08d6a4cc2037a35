// A scene on many machines: what does it take? A column of dry sand collapses in space, cut into eight tiles. The same bits on any
// number of ranks.
//
//   mpicxx -std=c++20 -O3 -march=native -Iinclude -I/usr/include/eigen3 examples/mpi/tiles.cpp -o tiles && mpirun -n 2 ./tiles
//   prints: the toe of the heap lies at x = 0.165 m, of 8000 points
#include <arenite/arenite.hpp>
#include <arenite/mpi.hpp>
#include <arenite/observe/vtu.hpp>
#include <arenite/run/progress.hpp>

#include <algorithm>
#include <cstdio>
using namespace arenite;

int main(int argc, char** argv) {
  return mpi::program(argc, argv, [](mpi::World& world) {
    const MohrCoulomb sand{{.density = 1540, .young = 1_MPa, .poisson = 0.3, .friction = 35_deg}};
    const CartesianGrid<3> grid{{.lower = {0, 0, 0}, .upper = {0.3, 0.12, 0.1}, .cell = 0.01}};
    const auto make = [&](auto mesh, auto portion) {
      return Scene{ThreeDimensional{},
                   mesh,
                   Numerics<QuadraticBSpline>{Flip{.time = 0.1}},
                   bodies(fill<"sand">(Box{{0., 0., 0.}, {0.1, 0.1, 0.1}}, sand, {.per_cell = 8})),
                   walls(bottom(fixed), left(roller), right(roller), front(roller), back(roller)),
                   gravity({0, -9.81, 0}),
                   portion};
    };
    auto scene = distribute(world, grid, {.tiles = 8}, make);
    run(scene, {.end = 0.2, .courant = 0.8}, rebalancing(make), Progress(0.2), every(0.1, vtu("out/tiles")),
        every(0.1, save_tiles("out/state")));

    const double toe = -scene.least([](const auto& tile) {
      double reach = 0;
      const auto& position = tile.template body<"sand">().points.position;
      for (std::size_t p = 0; p < position.size(); ++p) reach = std::max(reach, position[p][0]);
      return -reach;
    });
    const double points = scene.sum([](const auto& tile) { return tile.point_count(); });  // all ranks ask
    if (world.rank() == 0)
      std::printf("the toe of the heap lies at x = %.4g m, of %.0f points\n", toe, points);
  });
}
