// benchmark.ranks TILES POINTS STEPS: a scene of tetrahedra on the ranks that there are, cut into so many tiles (0: one for each rank), of
// so many points in all. Prints one line: what a step takes, and what of it is exchange of nodes and migration.
#include <arenite/mpi.hpp>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <string>
#include <vector>

#include "../scenes.hpp"

using namespace arenite;
using Clock = std::chrono::steady_clock;

namespace {

double seconds(Clock::time_point since) {
  return std::chrono::duration<double>(Clock::now() - since).count();
}

/// Median of what `f` takes, s.
template <class F>
double median(int times, F&& f) {
  std::vector<double> all;
  for (int k = 0; k < times; ++k) {
    const auto start = Clock::now();
    f();
    all.push_back(seconds(start));
  }
  std::ranges::nth_element(all, all.begin() + times / 2);
  return all[static_cast<std::size_t>(times / 2)];
}

void work(mpi::World& world, int tiles, double points, int steps) {
  const int k = std::max(2, static_cast<int>(std::lround(std::cbrt(points / 60))));
  const double h = 1.0 / k;
  auto scene = distribute(world, bench::tetrahedra(k, h), {.tiles = tiles}, [&](auto mesh, auto portion) {
    return Scene{
        ThreeDimensional{},
        mesh,
        Numerics<LinearSimplex, Flip, Musl, NodalAveraging>{},
        bodies(fill(
            Box{{0., 0., 0.}, {1., 1., 1.}}, bench::sand(),
            {.per_cell = 10, .velocity = {0.05, 0.02, 0}, .stress = Geostatic{.surface = 1, .k0 = 0.5}})),
        walls(bottom(fixed), left(roller), right(roller), front(roller), back(roller)),
        gravity({0, 0, -9.81}),
        portion};
  });
  std::vector<double> times;
  std::size_t migrated = 0;
  double moved = 0;
  scene.together([&](auto& s) {
    for (int n = 0; n < 5; ++n) step_towards(s, {.end = 1e9}, 1);
    s.communicator().least(0);
    const bool tells = s.communicator().first();
    for (int n = 0; n < steps; ++n) {
      const auto start = Clock::now();
      step_towards(s, {.end = 1e9}, 1);
      if (tells) times.push_back(seconds(start));
    }
  });
  migrated = scene.shared().migrated_bytes();
  // Exchanges alone: of as many numbers a node as P2G sums.
  constexpr std::size_t lanes = 8;
  double exchange = 0, reduction = 0;
  scene.together([&](auto& s) {
    std::vector<double> values(lanes * LinearSimplex::node_count(s.mesh), 1.0);
    s.communicator().least(0);
    const double a = median(200, [&] { s.communicator().sum_nodes(std::span<double>(values), lanes); });
    const double b = median(200, [&] { s.communicator().least(1); });
    if (s.communicator().first()) exchange = a, reduction = b;
  });
  std::int64_t copies = 0;
  for (const auto& tile : scene.shared().halo().tiles) copies += static_cast<std::int64_t>(tile.nodes.size());
  std::array<std::int64_t, 3> all{0, copies, static_cast<std::int64_t>(migrated)};
  scene.for_each_tile([&](const auto& s) { all[0] += static_cast<std::int64_t>(s.point_count()); });
  world.sum(all);
  moved = static_cast<double>(all[2]) / (steps + 5);
  if (world.rank() != 0) return;
  std::ranges::nth_element(times, times.begin() + steps / 2);
  const double step = times[static_cast<std::size_t>(steps / 2)];
  std::printf(
      "{\"ranks\": %d, \"tiles\": %d, \"threads\": %d, \"points\": %ld, \"step\": %.4g, \"copies\": %.4g, "
      "\"exchange\": %.4g, \"reduction\": %.4g, "
      "\"migrated\": %.4g}\n",
      world.size(), scene.tiles(), threads(), static_cast<long>(all[0]), step,
      static_cast<double>(all[1]) / world.size(), exchange, reduction, moved);
}

}  // namespace

int main(int argc, char** argv) {
  return mpi::program(argc, argv, [&](mpi::World& world) {
    require(argc == 4, "benchmark.ranks: arguments", argc - 1, "must be three: tiles, points, steps");
    work(world, std::stoi(argv[1]), std::stod(argv[2]), std::stoi(argv[3]));
  });
}
