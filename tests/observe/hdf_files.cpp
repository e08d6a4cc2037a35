// VTKHDF files: one run in one file, resumed and of tiles. check_hdf_files.py reads the files that this test leaves
// with h5py, and compares them with VTU files.
#include <algorithm>
#include <arenite/arenite.hpp>
#include <arenite/mesh/box_mesh.hpp>
#include <arenite/observe/vtkhdf.hpp>
#include <arenite/run/saved_state.hpp>
#include <arenite/tiles.hpp>
#include <array>
#include <filesystem>
#include <fstream>
#include <set>

#include "../run/saved_files.hpp"
#include "catch.hpp"

using namespace arenite;
using Catch::Matchers::Contains;
using test::steps;

namespace {

/// A heap that falls and spreads, on a mesh or a portion of it.
template <class... Portion>
auto make_on(SimplexMesh<2> mesh, const Portion&... portion) {
  return Scene{PlaneStrain{},
               std::move(mesh),
               Numerics<LinearSimplex>{},
               bodies(fill<"sand">(Box{{0., 0.}, {0.3, 0.4}},
                                   MohrCoulomb<RemembersOpening>{
                                       {.density = 1500, .young = 1e6, .poisson = 0.3, .friction = 35_deg}})),
               walls(bottom(fixed), left(roller)),
               gravity({0, -9.81}),
               PointIds{},
               LocalDamping{},
               portion...,
               TrackEnergy{}};
}
MeshData<2> box() { return box_mesh<2>({{0, 0}, {1, 0.5}, {20, 10}}); }
auto make() { return make_on(SimplexMesh<2>(box())); }

}  // namespace

TEST_CASE("VTKHDF: a run in one file, with points that get lost; resumed it continues with the same steps") {
  std::filesystem::remove_all("series");
  const VtuOptions options{.mesh = true, .points = {.mass = true, .id = true}};
  auto scene = make();
  VtuSeries pieces("series/run", options);  // for check_hdf_files.py
  VtkhdfSeries series("series/run", options);
  const auto frame = [&](int count) {
    steps(scene, count);
    pieces(std::as_const(scene));
    series(std::as_const(scene));
  };
  frame(3);
  frame(5);
  remove_points<"sand">(scene, Box{{0., 0.3}, {0.3, 0.4}});
  frame(5);
  save_state(scene, {"series.state"}, series);
  frame(5);
  VtkhdfSeries resumed("series/run", options);  // without the last step, which is written again
  restore_state(scene, {"series.state"}, resumed);
  steps(scene, 5);
  resumed(std::as_const(scene));
  const auto rows = [](const std::string& file, const std::string& name) {
    return count_rows(Hdf5File(file, Hdf5Access::read), name);
  };
  CHECK(rows("series/run_sand.vtkhdf", "VTKHDF/Steps/Values") == 4);
  CHECK(rows("series/run_sand.vtkhdf", "VTKHDF/NumberOfPoints") == 3);  // at first, without some, resumed
  CHECK(rows("series/run_mesh.vtkhdf", "VTKHDF/Points") == 2 * 231);    // as it does not move; resumed
  VtkhdfSeries other("series/run", options);
  CHECK_THROWS_WITH(other(std::as_const(scene)),
                    Contains("run_sand.vtkhdf: holds 4 frames of an earlier run"));
  VtuOptions more = options;
  more.resumed = true;
  VtkhdfSeries later("series/run", more);
  later(std::as_const(scene));  // in the place of the one at the same time
  CHECK(rows("series/run_sand.vtkhdf", "VTKHDF/Steps/Values") == 4);
  VtkhdfWriter missing("series/none.vtkhdf", true);
  CHECK_THROWS_WITH(missing.keep(2), Contains("none.vtkhdf: no such file"));
  VtkhdfWriter shorter("series/run_sand.vtkhdf", true);
  CHECK_THROWS_WITH(shorter.keep(9), Contains("has 4 steps, and must have 9"));
  CHECK_THROWS_AS(VtkhdfWriter("no/such/folder/a.vtkhdf"), output_error);
  std::ofstream("series/precious") << "precious";  // a link is replaced, not followed
  std::filesystem::create_symlink("precious", "series/link.vtkhdf");
  const std::vector<double> origin(3);
  VtuData one_point;
  one_point.points = vtu_array("", 3, origin);
  VtkhdfWriter("series/link.vtkhdf").add(0, one_point);
  CHECK(std::filesystem::file_size("series/precious") == 8);
  std::filesystem::create_symlink("run_sand.vtkhdf", "series/other.vtkhdf");
  CHECK_THROWS_AS(VtkhdfWriter("series/other.vtkhdf", true).keep(1), output_error);
}

TEST_CASE("VTKHDF: tiles write one file, with the points and cells of all; restored they continue with it") {
  const int tiles = GENERATE(1, 4);
  CAPTURE(tiles);
  std::filesystem::remove_all("tiles");
  std::filesystem::remove_all("tiles_saved");
  const VtuOptions options{.mesh = true, .points = {.mass = true, .id = true}};
  const auto portion = [](SimplexMesh<2> mesh, auto on) { return make_on(std::move(mesh), on); };
  auto whole = make();
  VtkhdfSeries alone("tiles/alone", options);
  OneRank here;
  auto scene = distribute(here, box(), {.tiles = tiles}, portion);
  const auto run_to = [&](auto& all, double end) {
    RunOfTiles run(all, RunOptions{.end = end, .watch = false}, rebalancing(portion),
                   every(0.01, VtkhdfSeries("tiles/all", options)));
    if (end == 0.02)
      run.begin();
    else
      run.restore(SavedState("tiles_saved", "tiles"));
    while (!run.has_ended()) run.advance(50);
    run.finish();
    run.save(SavedState("tiles_saved", "tiles"));
  };
  run_to(scene, 0.02);
  auto again = distribute(here, box(), {.tiles = tiles}, portion);
  run_to(again, 0.04);
  auto due = every(0.01, alone);
  for (const double end : {0.02, 0.04}) run(whole, {.end = end, .watch = false}, due);
  const auto numbers = [](const std::string& file, const std::string& name, Hdf5Type type, auto value) {
    const Hdf5File from(file, Hdf5Access::read);
    std::vector<decltype(value)> all(count_rows(from, name) * (name == "VTKHDF/Points" ? 3 : 1));
    get_numbers(from, name, type, all.data());
    return all;
  };
  const std::size_t count = whole.point_count();
  const auto points_of = [&](const std::string& file) {  // of the last step
    const auto ids = numbers(file, "VTKHDF/PointData/id", {'u', 8}, std::uint64_t{});
    const auto places = numbers(file, "VTKHDF/Points", {'f', 8}, double{});
    const auto masses = numbers(file, "VTKHDF/PointData/mass", {'f', 8}, double{});
    REQUIRE((ids.size() >= count && places.size() >= 3 * count && masses.size() >= count));
    std::vector<std::array<double, 3>> all;
    for (std::size_t p = count; p > 0; --p) {
      const double* x = &places[places.size() - 3 * p];
      all.push_back({x[0], x[1], masses[masses.size() - p]});
    }
    std::ranges::sort(all);
    return std::pair{std::set(ids.end() - static_cast<std::ptrdiff_t>(count), ids.end()).size(), all};
  };
  const auto [ids, points] = points_of("tiles/all_sand.vtkhdf");
  const auto [ids_alone, points_alone] = points_of("tiles/alone_sand.vtkhdf");
  CHECK((ids == count && ids_alone == count));
  for (std::size_t p = 0; p < count; ++p)
    for (std::size_t k = 0; k < 3; ++k) REQUIRE(std::abs(points[p][k] - points_alone[p][k]) < 1e-9);
  const std::string mesh = "tiles/all_mesh.vtkhdf";
  CHECK(numbers("tiles/all_sand.vtkhdf", "VTKHDF/Steps/Values", {'f', 8}, double{}).size() == 5);
  auto corners = numbers(mesh, "VTKHDF/Connectivity", {'i', 8}, std::int64_t{});
  const auto of_parts = numbers(mesh, "VTKHDF/NumberOfConnectivityIds", {'i', 8}, std::int64_t{});
  corners.resize(static_cast<std::size_t>(of_parts.front()));  // written again by the second run
  const auto nodes = numbers(mesh, "VTKHDF/Points", {'f', 8}, double{});
  REQUIRE(corners.size() >= 3 * 400);
  double area = 0;  // each triangle, by the nodes of its tile
  for (std::size_t c = 0; c < corners.size(); c += 3) {
    const auto at = [&](std::size_t k, std::size_t axis) {
      return nodes[static_cast<std::size_t>(corners[c + k]) * 3 + axis];
    };
    const double of =
        (at(1, 0) - at(0, 0)) * (at(2, 1) - at(0, 1)) - (at(2, 0) - at(0, 0)) * (at(1, 1) - at(0, 1));
    REQUIRE(std::abs(of - 0.0025) < 1e-12);
    area += of / 2;
  }
  CHECK((tiles == 1 ? std::abs(area - 0.5) < 1e-12 : area > 0.5));
}
