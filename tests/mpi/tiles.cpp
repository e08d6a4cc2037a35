// `tests.mpi.tiles [grid] TILES STEPS [balance | save FOLDER STEP | restore FOLDER | fail | outside | mesh | cut | run | alone | killed FOLDER]`: sand with a body that
// is pushed into it, cut into tiles on the ranks that there are; prints a hash of all points, and what moved between ranks.
#include <arenite/arenite.hpp>
#include <arenite/mpi.hpp>

#include <csignal>
#include <cstdio>
#include <string>

#include "meshes.hpp"

using namespace arenite;

namespace {

MeshData<2> soil_and_block() {
  auto data = test::triangles({0, 0}, {1, 1}, 30, 30);
  test::name_region(data, "block", [](const auto& x) { return std::abs(x[0] - 0.5) < 0.2 && x[1] > 0.6; });
  test::name_region(data, "soil", [](const auto& x) { return x[1] < 0.6; });
  return data;
}

auto make(SimplexMesh<2> mesh, OnPortion<MeshPortion<2>, TileCommunicator> portion) {
  return Scene{
      PlaneStrain{},
      mesh,
      Numerics<LinearSimplex, Flip, Musl, NodalAndElementAverage>{},
      bodies(fill<"sand">(
          Cells("soil"),
          MohrCoulomb<RemembersOpening>{
              {.density = 1500, .young = 1e6, .poisson = 0.3, .friction = 35_deg, .dilatancy = 10_deg}},
          {.per_cell = 3,
           .velocity = {1, 0, 0},
           .stress = Geostatic{.surface = 0.6, .k0 = 0.5},
           .jitter = 0.3,
           .seed = 2})),
      walls(bottom(fixed), left(roller), right(roller)),
      gravity({0, -9.81}),
      rigids(rigid(MeshSurface{"block"}, Guided{.mass = 100, .velocity = -2}, Friction(20_deg))),
      MovingMesh<>{.fixed_below = 0.1, .moving_from = 0.6},
      TrackEnergy{},
      PointIds{},
      portion};
}

/// The same sand in space, on a grid.
auto make_on_grid(WindowGrid<CartesianGrid<3>> mesh, OnPortion<MeshPortion<3>, TileCommunicator> portion) {
  return Scene{
      ThreeDimensional{},
      mesh,
      Numerics<QuadraticBSpline, Apic, Usl>{},
      bodies(fill<"sand">(
          Box{{0., 0., 0.}, {0.7, 0.6, 0.7}},
          DruckerPrager{{.density = 1500, .young = 1e6, .poisson = 0.3, .friction = 35_deg, .cohesion = 100}},
          {.per_cell = 8, .velocity = {2, 0, 1}, .jitter = 0.3, .seed = 2})),
      walls(bottom(fixed), left(roller)),
      gravity({0, -9.81, 0}),
      rigid(DistanceSurface{Ball{{0.4, 0.75, 0.4}, 0.15}}, Guided{.mass = 20, .velocity = -2},
            Friction(20_deg)),
      TrackEnergy{},
      PointIds{},
      portion};
}

/// A number that all bits of a point, whatever its place in memory, change.
std::uint64_t bits_of(const auto& points, std::size_t p) {
  Hash hash;
  points.for_each_column([&](const auto& column) {
    const auto value = column[p];
    hash.add(&value, sizeof(value));
  });
  return std::stoull(hash.digits().substr(0, 12), nullptr, 16);
}

/// An observer that goes with its tile.
struct CountsCalls {
  std::size_t calls = 0;

  template <class Scene>
  void operator()(const Scene&) {
    ++calls;
  }
  template <class Scene>
  void finish(const Scene& scene) const {
    require(calls == scene.steps + 1, "calls of an observer", calls, {"must be ", scene.steps + 1});
  }
  template <class F>
  void visit_state(F&& f) {
    f("calls", calls);
  }
};

template <class Mesh, class Make>
void work(mpi::World& world, const std::vector<std::string>& given, const Mesh& mesh, Make&& make) {
  const auto steps = std::stoul(given.at(2));
  const std::string what = given.size() > 3 ? given[3] : "", folder = given.size() > 4 ? given[4] : "";
  const int tiles = std::stoi(given.at(1)) + (what == "cut" ? world.rank() : 0);
  if (what == "mesh" && world.rank() == 1) throw error("mesh.msh: the sentence of a failure");
  auto scene = distribute(world, mesh, {.tiles = tiles}, make);
  if (what == "restore") restore_state(scene, folder);
  if (what == "outside" && world.rank() == world.size() - 1) throw error("the sentence of a failure");
  if (what == "run") run(scene, {.end = world.rank() == 1 ? 0.02 : 0.01});
  if (what == "alone" && world.rank() == 1) scene.sum([](const auto& s) { return s.point_count(); });
  if (what == "alone") return;
  const auto save_at = what == "save" ? std::stoul(given.at(5)) : 0;
  const auto ranks_before = scene.shared().rank_of();
  if (what == "balance")
    run(scene, {.end = 1}, rebalancing(make, {.every = 50, .most = 1}), CountsCalls{},
        [steps](const auto& s) { return s.steps < steps ? RunFlow::go_on : RunFlow::stop; });
  int moved = 0;
  for (std::size_t t = 0; t < ranks_before.size(); ++t)
    moved += ranks_before[t] != scene.shared().rank_of()[t];
  scene.together([&](auto& s) {
    while (s.steps < steps) {
      step_towards(s, {.end = 1e9}, 1);
      if (what == "save" && s.steps == save_at) SavedTiles{folder}(s);
      if (what == "fail" && s.steps == 20 && s.portion().number == 4)
        throw run_error("the sentence of a failure");
      if (what == "killed") {
        SavedTiles{folder}(s);
        if (s.steps == 10 && s.portion().number == 7) std::raise(SIGKILL);
      }
    }
  });
  std::int64_t count = 0, bits = 0, migrated = static_cast<std::int64_t>(scene.shared().migrated_bytes());
  scene.for_each_tile([&](auto& s) {
    auto& points = s.body().points;
    for (std::size_t p = 0; p < points.size(); ++p) {
      ++count;
      points.id[p] = 0;  // the rest of a point identifies it
      points.cell[p] = static_cast<Index>(s.portion().whole_cell[points.cell[p]]);
      bits += static_cast<std::int64_t>(bits_of(points, p));
    }
  });
  std::array<std::int64_t, 3> all{count, bits, migrated};
  world.sum(all);
  if (world.rank() == 0)
    std::printf("points %ld %lx migrated %ld bytes, moved %d tiles\n", static_cast<long>(all[0]),
                static_cast<unsigned long>(all[1]), static_cast<long>(all[2]), moved);
}

}  // namespace

int main(int argc, char** argv) {
  std::vector<std::string> given(argv, argv + argc);
  return mpi::program(argc, argv, [&](mpi::World& world) {
    if (given.at(1) == "grid") {
      given.erase(given.begin() + 1);
      work(world, given, CartesianGrid<3>({.lower = {0, 0, 0}, .upper = {1, 1, 1}, .cell = 0.1}),
           make_on_grid);
    } else {
      work(world, given, soil_and_block(), make);
    }
  });
}
