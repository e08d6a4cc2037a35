// Scenes cut into tiles in one process: the same points as the whole, output of the whole, saved and restored.
#include <arenite/arenite.hpp>
#include <arenite/io/pvd.hpp>
#include <arenite/observe/csv.hpp>
#include <arenite/observe/vtu.hpp>
#include <arenite/tiles.hpp>

#include <filesystem>
#include <fstream>
#include <set>
#include <sstream>

#include "catch.hpp"
#include "meshes.hpp"
#include "message.hpp"

using namespace arenite;

namespace {

/// A column of sand that collapses across all cuts.
auto column() {
  return [](auto mesh, auto... portion) {
    return Scene{
        PlaneStrain{},
        mesh,
        Numerics<LinearSimplex, Flip, Musl>{},
        bodies(fill<"sand">(Box{{0., 0.}, {0.4, 0.6}},
                            MohrCoulomb{{.density = 1500, .young = 1e6, .poisson = 0.3, .friction = 35_deg}},
                            {.per_cell = 3, .jitter = 0.4, .seed = 5})),
        walls(bottom(fixed), left(roller), right(roller)),
        gravity({0, -9.81}),
        PointIds{},
        portion...};
  };
}
const MeshData<2>& mesh() {
  static const auto data = test::triangles({0, 0}, {1, 1}, 20, 20);
  return data;
}

/// A new folder for the files of a test.
std::filesystem::path new_folder(const std::string& name) {
  std::filesystem::remove_all(name);
  std::filesystem::create_directory(name);
  return name;
}

/// The numbers of a table of a file, row by row.
std::vector<double> numbers_of(const std::filesystem::path& file) {
  std::ifstream in(file);
  std::string line;
  std::getline(in, line);
  std::vector<double> numbers;
  while (std::getline(in, line)) {
    std::ranges::replace(line, ',', ' ');
    std::istringstream words(line);
    for (double x; words >> x;) numbers.push_back(x);
  }
  return numbers;
}

/// Positions of all points, sorted.
template <class S>
void add_places(const S& scene, std::vector<std::array<double, 2>>& places) {
  scene.for_each_body([&](const auto& body, const auto&) {
    for (std::size_t p = 0; p < body.points.size(); ++p)
      places.push_back({body.points.position[p][0], body.points.position[p][1]});
  });
}
template <class S>
std::vector<std::array<double, 2>> places_of(const Tiled<S>& tiled) {
  std::vector<std::array<double, 2>> places;
  tiled.for_each_tile([&](const auto& scene) { add_places(scene, places); });
  std::ranges::sort(places);
  return places;
}

}  // namespace

TEST_CASE("Tiles are filled with the points of the whole, jittered ones too, with their own ids") {
  OneRank here;
  const auto whole = column()(SimplexMesh<2>(mesh()));
  std::vector<std::array<double, 2>> expected;
  add_places(whole, expected);
  std::ranges::sort(expected);
  for (const int tiles : {1, 2, 5}) {
    const auto tiled = distribute(here, mesh(), {.tiles = tiles}, column());
    CHECK(tiled.tiles_here() == static_cast<std::size_t>(tiles));
    CHECK(places_of(tiled) == expected);
    std::set<std::uint64_t> ids;
    tiled.for_each_tile(
        [&](const auto& scene) { ids.insert(scene.body().points.id.begin(), scene.body().points.id.end()); });
    CHECK(ids.size() == expected.size());
    CHECK(*ids.rbegin() == expected.size() - 1);
  }
}

TEST_CASE("One tile has the same bits as the whole scene") {
  OneRank here;
  auto whole = column()(SimplexMesh<2>(mesh()));
  auto tiled = distribute(here, mesh(), {.tiles = 1}, column());
  run(whole, {.end = 0.05});
  run(tiled, {.end = 0.05});
  std::vector<std::array<double, 2>> expected;
  add_places(whole, expected);
  std::ranges::sort(expected);
  CHECK(places_of(tiled) == expected);
}

TEST_CASE("Tables and sums of tiles are those of the whole; VTU pieces are in one list") {
  const auto folder = new_folder("tiles_of_a_table");
  OneRank here;
  const auto force = [](const auto& scene) {
    return section_force(scene, {.through = {0, 0.2, 0}, .normal = {0, 1, 0}, .thickness = 0.1});
  };
  auto whole = column()(SimplexMesh<2>(mesh()));
  auto tiled = distribute(here, mesh(), {.tiles = 3}, column());
  const RunOptions options{.end = 0.02, .max_step = 2e-4};
  run(whole, options, csv(folder / "whole.csv", CsvColumn{"force", force}));
  run(tiled, options, csv(folder / "tiles.csv", CsvColumn{"force", force}),
      every(0.01, vtu(folder / "out/run")));
  const auto expected = numbers_of(folder / "whole.csv"), found = numbers_of(folder / "tiles.csv");
  REQUIRE(found.size() == expected.size());
  REQUIRE(found.size() > 300);
  for (std::size_t k = 0; k < found.size(); ++k)
    CHECK(found[k] == Approx(expected[k]).epsilon(1e-9).margin(1e-9));
  CHECK(tiled.sum([](const auto& scene) { return static_cast<double>(scene.point_count()); }) ==
        static_cast<double>(whole.point_count()));
  CHECK(pvd_times(folder / "out/run.pvd").size() == 3);
  for (const int piece : {0, 1, 2})
    CHECK(std::filesystem::exists(folder / ("out/run_sand_p" + std::to_string(piece) + "_0002.vtu")));
  // So do tiles that may move on the way.
  auto moving = distribute(here, mesh(), {.tiles = 3}, column());
  run(moving, options, rebalancing(column(), {.every = 7}),
      csv(folder / "moving.csv", CsvColumn{"force", force}));
  CHECK(numbers_of(folder / "moving.csv") == found);
  CHECK(moving.time() == options.end);
  using Catch::Matchers::Contains;
  CHECK_THROWS_WITH(rebalancing(column(), {.every = 0}),
                    Contains("RebalanceOptions.every = 0: must be at least 1"));
  CHECK_THROWS_WITH(rebalancing(column(), {.most = 0.5}),
                    Contains("RebalanceOptions.most = 0.5: must be at least 1"));
}

TEST_CASE("Saved tiles continue with the same bits; a folder of other tiles, or none, is refused") {
  const auto folder = new_folder("saved_tiles");
  OneRank here;
  auto first = distribute(here, mesh(), {.tiles = 3}, column());
  const RunOptions options{.end = 0.04, .max_step = 1e-4};
  run(first, options, [&](const auto& scene) {
    if (scene.steps == 100) SavedTiles(folder / "state")(scene);
  });
  auto second = distribute(here, mesh(), {.tiles = 3}, column());
  restore_state(second, folder / "state");
  second.for_each_tile([](const auto& scene) { CHECK(scene.steps == 100); });
  run(second, options);
  CHECK(places_of(second) == places_of(first));
  save_state(second, folder / "state");  // the new save takes the place of the old one
  std::size_t files = 0;
  for (const auto& entry : std::filesystem::directory_iterator(folder / "state"))
    files += entry.path().extension() == ".state";
  CHECK(files == 3);
  auto other = distribute(here, mesh(), {.tiles = 2}, column());
  CHECK_THAT(test::message<error>([&] { restore_state(other, folder / "state"); }),
             Catch::Matchers::Contains("saved tiles = 3: must be as many as those of the scene, 2"));
  auto fresh = distribute(here, mesh(), {.tiles = 2}, column());
  CHECK_THAT(test::message<error>([&] { restore_state(fresh, folder / "nothing"); }),
             Catch::Matchers::Contains("tiles.txt"));
}

TEST_CASE(
    "The watch of a run sees the energy of all tiles: what is pushed across a cut is no gain, what comes "
    "from nowhere is") {
  OneRank here;
  const auto flying_block = [](auto mesh, auto portion) {
    return Scene{PlaneStrain{}, mesh, Numerics<LinearSimplex, Flip, Musl>{},
                 bodies(fill(Box{{0.1, 0.3}, {0.4, 0.7}},
                             LinearElastic{{.density = 1000, .young = 1e7, .poisson = 0.3}},
                             {.per_cell = 3, .velocity = {1, 0, 0}})),
                 portion};
  };
  auto tiled = distribute(here, mesh(), {.tiles = 4}, flying_block);
  run(tiled, {.end = 0.4});  // through all tiles
  double lost = 0;
  tiled.for_each_tile([&](const auto& scene) { lost += static_cast<double>(scene.lost_points()); });
  CHECK(lost == 0);
  auto gains = distribute(here, mesh(), {.tiles = 4}, flying_block);
  CHECK_THAT(test::message<run_error>([&] {
               run(gains, {.end = 0.2}, [](const auto& scene) {
                 auto& points = const_cast<std::remove_cvref_t<decltype(scene)>&>(scene).body().points;
                 for (std::size_t p = 0; p < points.size(); ++p)
                   points.velocity.set(p, 1.001 * points.velocity[p]);
               });
             }),
             Catch::Matchers::Contains("energy"));
}

TEST_CASE("Warnings of new tiles are said once: most are of the whole") {
  std::vector<std::string> told;
  const auto hook = on_warning([&](const auto& text) { told.push_back(text); });
  OneRank here;
  const auto make = [](auto mesh, auto portion) {
    warn("a wall is thin");
    warn(joined_text({"tile ", portion.portion.number, " alone"}));
    return column()(std::move(mesh), std::move(portion));
  };
  distribute(here, mesh(), {.tiles = 2}, make);
  warn("another");  // the hook is back
  on_warning(hook);
  CHECK(told == std::vector<std::string>{"a wall is thin", "tile 0 alone", "tile 1 alone", "another"});
}
