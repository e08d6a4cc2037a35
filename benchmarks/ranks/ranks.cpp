// benchmark.ranks TILES POINTS STEPS: a scene of tetrahedra on the ranks that there are, cut into TILES tiles (0: one for each rank), of
// POINTS points in all. Prints one line: what a step takes, what of it is exchange of nodes; what points cost that change tiles, beside
// their relocation; and how long the ranks stand still while tiles move, because all points lie on one half of the cells.
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

/// Sand in cubes of edge 1 / k m, up to x = `filled`, that moves with `speed`, m/s; and what makes it.
auto sand_in_tiles(mpi::World& world, int tiles, int k, double filled, double speed) {
  const auto make = [=](auto mesh, auto portion) {
    return Scene{ThreeDimensional{},
                 mesh,
                 Numerics<LinearSimplex, Flip, Musl, NodalAveraging>{},
                 bodies(fill(Box{{0., 0., 0.}, {filled, 1., 1.}}, bench::sand(),
                             {.per_cell = 10,
                              .velocity = {speed, 0.4 * speed, 0},
                              .stress = Geostatic{.surface = 1, .k0 = 0.5}})),
                 walls(bottom(fixed), left(roller), right(roller), front(roller), back(roller)),
                 gravity({0, 0, -9.81}),
                 portion};
  };
  return std::pair{distribute(world, bench::tetrahedra(k, 1.0 / k), {.tiles = tiles}, make), make};
}

/// Costs of changing tiles, s, medians of steps.
struct Migration {
  double share = 0;                        ///< of the points that change tiles in a step
  double find = 0, move = 0, regroup = 0;  ///< cells of points, the exchange of points, lists of cells
};
Migration migration(mpi::World& world, int tiles, int k, int steps) {
  auto scene = sand_in_tiles(world, tiles, k, 1, 1.5).first;
  std::array<std::vector<double>, 3> times;
  std::array<double, 2> points{};
  scene.together([&](auto& s) {
    constexpr int width = std::remove_cvref_t<decltype(s)>::NumericsType::template width<double>;
    for (int n = 0; n < 5 + steps; ++n) {
      const auto of_bodies = [&](auto&& f) {
        return median(1, [&] { s.for_each_body([&](auto& body, auto&) { f(body); }); });
      };
      const double find = of_bodies([&](auto& body) { find_cells<width>(body, s.mesh, s.blocks); });
      double leave = 0;
      for (const Index c : s.template body<0>().points.cell)
        leave += c < s.mesh.cell_count() && !s.portion().owns_cell(c);
      s.communicator().least(0);
      const double move = median(1, [&] { migrate(s); });
      const double regrouping = of_bodies([&](auto& body) { regroup(body, s.blocks); });
      if (n >= 5 && s.communicator().first()) {
        times[0].push_back(find), times[1].push_back(move), times[2].push_back(regrouping);
        points[0] += leave, points[1] += static_cast<double>(s.point_count());
      }
      step_towards(s, {.end = 1e9}, 1);
    }
  });
  if (world.rank() != 0) return {};
  for (auto& t : times) std::ranges::nth_element(t, t.begin() + steps / 2);
  const auto at = static_cast<std::size_t>(steps / 2);
  return {points[0] / points[1], times[0][at], times[1][at], times[2][at]};
}

/// How long all ranks stand still while tiles move, in steps, and the fullest rank's share of the points over the mean.
struct Standstill {
  int moved = 0;
  double before = 1, after = 1, steps = 0;
};
Standstill standstill(mpi::World& world, int tiles, int k) {
  auto sand = sand_in_tiles(world, tiles, k, 0.5, 0.05);
  auto& scene = sand.first;  // no structured binding: clang++ 14 captures none in a lambda
  auto& make = sand.second;
  double step = 0;
  const auto time_steps = [&] {
    scene.together([&](auto& s) {
      const double of = median(15, [&] { step_towards(s, {.end = 1e9}, 1); });
      if (s.communicator().first()) step = of;
    });
  };
  time_steps();
  Rebalanced done;
  world.meet();
  const double still = median(1, [&] { done = rebalance(scene, make); });
  time_steps();
  return {done.moved, done.before, done.after, step > 0 ? still / step : 0};
}

void work(mpi::World& world, int tiles, double points, int steps) {
  const int k = std::max(2, static_cast<int>(std::lround(std::cbrt(points / 60))));
  auto scene = sand_in_tiles(world, tiles, k, 1, 0.05).first;
  std::vector<double> times;
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
  // Only exchanges: of as many numbers a node as P2G sums.
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
  std::array<std::int64_t, 2> all{0, copies};
  scene.for_each_tile([&](const auto& s) { all[0] += static_cast<std::int64_t>(s.point_count()); });
  world.sum(all);
  const Migration change = migration(world, scene.tiles(), k, steps);
  const Standstill still = standstill(world, scene.tiles(), k);
  if (world.rank() != 0) return;
  std::ranges::nth_element(times, times.begin() + steps / 2);
  const double step = times[static_cast<std::size_t>(steps / 2)];
  std::printf(
      "{\"ranks\": %d, \"tiles\": %d, \"threads\": %d, \"points\": %ld, \"step\": %.4g, \"copies\": %.4g, "
      "\"exchange\": %.4g, \"reduction\": %.4g, "
      "\"migrating\": %.4g, \"find\": %.4g, \"move\": %.4g, \"regroup\": %.4g, \"moved_tiles\": %d, "
      "\"before\": %.4g, \"after\": %.4g, \"still\": %.4g}\n",
      world.size(), scene.tiles(), threads(), static_cast<long>(all[0]), step,
      static_cast<double>(all[1]) / world.size(), exchange, reduction, change.share, change.find, change.move,
      change.regroup, still.moved, still.before, still.after, still.steps);
}

}  // namespace

int main(int argc, char** argv) {
  return mpi::program(argc, argv, [&](mpi::World& world) {
    require(argc == 4, "benchmark.ranks: arguments", argc - 1, "must be three: tiles, points, steps");
    work(world, std::stoi(argv[1]), std::stod(argv[2]), std::stoi(argv[3]));
  });
}
