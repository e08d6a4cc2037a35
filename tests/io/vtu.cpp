// VTU and PVD files out. Beside each NAME.vtu this test leaves NAME.txt with the numbers it gave to the
// writer, in hexadecimal form; check_vtu.py then reads both and compares. The folder is named by the
// environment variable ARENITE_TEST_VTU (by default the working folder).
#include <arenite/io/pvd.hpp>
#include <arenite/io/vtu.hpp>
#include <arenite/law/linear_elastic.hpp>
#include <arenite/law/mohr_coulomb.hpp>
#include <arenite/observe/vtu.hpp>

#include <array>
#include <atomic>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <limits>
#include <random>
#include <string>
#include <system_error>
#include <thread>
#include <vector>

#include "catch.hpp"

using namespace arenite;
namespace fs = std::filesystem;

namespace {

fs::path folder() {
  const char* const name = std::getenv("ARENITE_TEST_VTU");
  const fs::path path = name != nullptr ? name : ".";
  fs::create_directories(path);
  return path;
}

/// NAME.txt: a line "array WHERE TYPE ITEMS COMPONENTS NAME", then the numbers; integers as they are.
class Reference {
 public:
  explicit Reference(const fs::path& vtu)
      : file_(std::fopen(fs::path(vtu).replace_extension("txt").c_str(), "w")) {
    REQUIRE(file_ != nullptr);
  }
  ~Reference() { std::fclose(file_); }
  Reference(const Reference&) = delete;
  Reference& operator=(const Reference&) = delete;

  template <class T>
  void add(const char* where, const char* type, const char* name, std::size_t components,
           const std::vector<T>& values) {
    std::fprintf(file_, "array %s %s %zu %zu %s\n", where, type, values.size() / components, components,
                 name);
    for (const T v : values) {
      if constexpr (std::is_floating_point_v<T>)
        std::fprintf(file_, "%a\n", static_cast<double>(v));
      else
        std::fprintf(file_, "%lld\n", static_cast<long long>(v));
    }
  }

 private:
  std::FILE* file_;
};

template <class T>
std::vector<T> random_values(std::size_t n, unsigned seed) {
  std::mt19937 engine(seed);
  std::vector<T> values(n);
  for (T& v : values) v = static_cast<T>(static_cast<double>(engine()) / 77.0 - 1e7);
  return values;
}

std::string bytes_of(const fs::path& path) {
  std::ifstream in(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
}

VtuData two_points(const std::vector<double>& positions) {
  return {vtu_array("", 3, positions), {vtu_vertices(2)}, {}, {}};
}

}  // namespace

TEST_CASE("a cloud of points with arrays of every shape and type") {
  const fs::path file = folder() / "cloud.vtu";
  Reference reference(file);
  const std::size_t n = 20001;  // more than two of the writer's pieces
  const auto position = random_values<double>(3 * n, 1);
  auto pressure = random_values<double>(n, 2);
  pressure[0] = std::numeric_limits<double>::denorm_min();
  pressure[1] = -std::numeric_limits<double>::max();
  pressure[2] = std::numeric_limits<double>::infinity();
  const auto stress = random_values<double>(6 * n, 3);
  const auto gradient = random_values<float>(9 * n, 4);
  const auto id = random_values<std::int32_t>(n, 5);
  const auto velocity = random_values<float>(2 * n, 6);
  std::vector<float> padded;
  for (std::size_t i = 0; i < n; ++i) padded.insert(padded.end(), {velocity[2 * i], velocity[2 * i + 1], 0});
  std::vector<std::int64_t> square(n);
  for (std::size_t i = 0; i < n; ++i) square[i] = static_cast<std::int64_t>(i * i) << 8;

  VtuData data;
  data.points = vtu_array("", 3, position);
  data.cells = {vtu_vertices(n)};
  data.point_data = {
      vtu_array("pressure <Pa> & \"more\"", 1, pressure), vtu_array("stress", 6, stress),
      vtu_array("gradient", 9, gradient), vtu_array("id", 1, id),
      // A plane vector, padded to three components as it is written.
      vtu_array("velocity", n,
                [&](std::size_t i) {
                  return std::array{velocity[2 * i], velocity[2 * i + 1], 0.0f};
                }),
      vtu_array("square", n, [](std::size_t i) { return static_cast<std::int64_t>(i * i) << 8; })};
  write_vtu(file, data);
  REQUIRE(fs::exists(file));
  REQUIRE_FALSE(fs::exists(folder() / "cloud.vtu.part"));

  reference.add("points", "double", "points", 3, position);
  reference.add("point", "double", "pressure <Pa> & \"more\"", 1, pressure);
  reference.add("point", "double", "stress", 6, stress);
  reference.add("point", "float", "gradient", 9, gradient);
  reference.add("point", "int32", "id", 1, id);
  reference.add("point", "float", "velocity", 3, padded);
  reference.add("point", "int64", "square", 1, square);
}

TEST_CASE("cells of four kinds in one file, single precision points") {
  const fs::path file = folder() / "cells.vtu";
  Reference reference(file);
  const std::vector<float> position{0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 0.1f, 0.2f, 0.3f};
  const std::vector<std::array<Index, 4>> tetrahedra{{0, 1, 2, 3}, {4, 1, 2, 3}};
  const std::vector<std::array<Index, 3>> triangles{{0, 1, 2}};
  const std::vector<std::array<Index, 2>> lines{{3, 4}, {4, 0}};
  const std::vector<std::array<Index, 1>> vertices{{4}};
  const std::vector<double> volume{0.5, 1.0 / 3, 2, 3, 4, 5};
  const std::vector<std::uint32_t> region{1, 2, 3, 4, 5, 4294967295u};
  write_vtu(file, {vtu_array("", 3, position),
                   {vtu_cells(tetrahedra), vtu_cells(triangles), vtu_cells(lines), vtu_cells(vertices)},
                   {},
                   {vtu_array("volume", 1, volume), vtu_array("region", 1, region)}});
  reference.add("points", "float", "points", 3, position);
  reference.add("cells", "int", "tetra", 4, std::vector<int>{0, 1, 2, 3, 4, 1, 2, 3});
  reference.add("cells", "int", "triangle", 3, std::vector<int>{0, 1, 2});
  reference.add("cells", "int", "line", 2, std::vector<int>{3, 4, 4, 0});
  reference.add("cells", "int", "vertex", 1, std::vector<int>{4});
  reference.add("cell", "double", "volume", 1, volume);
  reference.add("cell", "uint32", "region", 1, region);
}

namespace {

/// A history of which one member has no name.
struct Worn : LinearElastic {
  using LinearElastic::LinearElastic;
  template <class T>
  struct History {
    T wear{0}, hidden{1}, age{2};
    static constexpr std::array names{"wear", "", "age"};
    auto members() { return std::tie(wear, hidden, age); }
    auto members() const { return std::tie(wear, hidden, age); }
  };
  template <class T, int D>
  T update(Sym<T, D>&, const StrainStep<T, D>&, History<T>&) const {
    return T(0);
  }
};

}  // namespace

TEST_CASE("points of a body with the named members of their history") {
  const CartesianGrid<2> grid({.lower = {0, 0}, .upper = {1, 1}, .cell = 0.5});
  const auto half = [](const auto& x) { return x[0] / 2; };
  const auto write = [&](const char* name, const auto& law, const FillOptions& options,
                         const std::vector<std::pair<const char*, std::size_t>>& members) {
    const auto body =
        make_body<PlaneStrain>(grid, fill(Box{{0., 0.}, {1., 1.}}, law, options), {.gravity = {0, -9.81, 0}});
    const fs::path file = folder() / name;
    write_vtu(file, points_vtu(body));
    Reference reference(file);
    const auto& points = body.points;
    std::vector<double> position, velocity, stress, pressure, ratio, strain;
    for (std::size_t p = 0; p < points.size(); ++p) {
      const auto x = points.position[p];
      const auto s = points.stress[p];
      position.insert(position.end(), {x[0], x[1], 0});
      velocity.insert(velocity.end(), {1, 2, 0});
      stress.insert(stress.end(), {s[0], s[1], s[2], s[3], 0, 0});
      pressure.push_back(-trace(s) / 3);
      ratio.push_back(points.volume[p] * law.density() / points.mass[p]);
      strain.push_back(0);
    }
    reference.add("points", "double", "points", 3, position);
    reference.add("point", "double", "velocity", 3, velocity);
    reference.add("point", "double", "stress", 6, stress);
    reference.add("point", "double", "pressure", 1, pressure);
    reference.add("point", "double", "volume_ratio", 1, ratio);
    if (has_deviatoric_strain<std::decay_t<decltype(law)>>)
      reference.add("point", "double", "deviatoric_strain", 1, strain);
    for (const auto& [member, k] : members)
      reference.add("point", "double", member, 1,
                    std::vector<double>(points.history[k].begin(), points.history[k].end()));
  };
  const FillOptions options{.velocity = {1, 2, 0}, .stress = Geostatic{.surface = 1, .k0 = 0.5}};
  auto worn = options;
  worn.history = {{"wear", half}};
  write("worn.vtu", Worn{LinearElasticParameters{.density = 1000, .young = 1e6, .poisson = 0.3}}, worn,
        {{"wear", 0}, {"age", 2}});
  auto open = options;
  open.history = {{"opening", half}};
  const MohrCoulomb sand{{.density = 1500, .young = 1e6, .poisson = 0.3, .friction = 0.6},
                         RemembersOpening{}};
  write("sand.vtu", WithDeviatoricStrain<MohrCoulomb<RemembersOpening>, 2>{sand}, open, {{"opening", 0}});
}

TEST_CASE("points with the numbers that were asked for") {
  const CartesianGrid<2> grid({.lower = {0, 0}, .upper = {1, 1}, .cell = 0.5});
  const Worn law{LinearElasticParameters{.density = 1000, .young = 1e6, .poisson = 0.3}};
  const auto recipe = fill(Box<2>{{0, 0}, {1, 1}}, law);
  const auto names = [](const VtuData& data) {
    std::string all;
    for (const auto& array : data.point_data) all += array.name + " ";
    return all;
  };
  const auto body = make_body<PlaneStrain>(grid, recipe);
  const std::string always = "velocity stress pressure volume_ratio ";
  CHECK(names(points_vtu(body)) == always + "wear age ");
  CHECK(names(points_vtu(body, {.history = {{"age"}}, .mass = true})) == always + "age mass ");
  CHECK(names(points_vtu(body, {.history = {{}}})) == always);
  CHECK_THROWS_WITH(points_vtu(body, {.id = true}), "VtuPoints.id = 1: needs a scene with PointIds{}");
  auto numbered =
      make_body<PlaneStrain, ExtraColumns{.ids = true}>(grid, recipe.type_erased<CartesianGrid<2>>());
  for (std::size_t p = 0; p < numbered.points.size(); ++p) numbered.points.id[p] = 100 + p;
  const fs::path file = folder() / "numbered.vtu";
  write_vtu(file, points_vtu(numbered, {.history = {{}}, .mass = true, .id = true}));
  Reference reference(file);
  std::vector<double> mass(numbered.points.mass.begin(), numbered.points.mass.end()), position;
  for (const auto& x : numbered.points.position) position.insert(position.end(), {x[0], x[1], 0});
  reference.add("points", "double", "points", 3, position);
  reference.add("point", "double", "velocity", 3, std::vector<double>(position.size(), 0));
  reference.add("point", "double", "stress", 6, std::vector<double>(2 * position.size(), 0));
  reference.add("point", "double", "pressure", 1, std::vector<double>(mass.size(), 0));
  reference.add("point", "double", "volume_ratio", 1, std::vector<double>(mass.size(), 1));
  std::vector<std::int64_t> id(numbered.points.id.begin(), numbered.points.id.end());
  reference.add("point", "double", "mass", 1, mass);
  reference.add("point", "int64", "id", 1, id);
}

TEST_CASE("a series is readable after each step") {
  const fs::path list = folder() / "series.pvd";
  const std::vector<double> position{0, 0, 0, 1, 2, 3};
  PvdWriter series(list);
  REQUIRE(bytes_of(list).find("</VTKFile>") != std::string::npos);
  fs::create_directories(folder() / "steps & more");
  for (int step = 0; step < 3; ++step) {
    const fs::path file = folder() / "steps & more" / ("step_" + std::to_string(step) + ".vtu");
    write_vtu(file, two_points(position));
    series.add(0.1 * step, file, 1);
    const std::string text = bytes_of(list);
    REQUIRE(text.find("</VTKFile>") != std::string::npos);
    REQUIRE(text.find("file=\"steps &amp; more/step_" + std::to_string(step) + ".vtu\"") !=
            std::string::npos);
  }
  REQUIRE(bytes_of(list).find("timestep=\"0.30000000000000004\"") == std::string::npos);
  REQUIRE(bytes_of(list).find("timestep=\"0.2\" part=\"1\"") != std::string::npos);
  REQUIRE_THROWS_AS(series.add(std::numeric_limits<double>::quiet_NaN(), "x.vtu"), error);
  REQUIRE(series.entries().size() == 3);
}

TEST_CASE("what does not fit is refused, and the former file stays") {
  const fs::path file = folder() / "refused.vtu";
  const std::vector<double> position{0, 0, 0, 1, 2, 3}, three{1, 2, 3};
  const std::vector<std::array<Index, 2>> line{{0, 2}};
  write_vtu(file, two_points(position));
  const std::string before = bytes_of(file);

  auto data = two_points(position);
  data.point_data = {vtu_array("p", 1, three)};
  REQUIRE_THROWS_WITH(write_vtu(file, data), "items of array p = 3: must be 2, as points are");
  data.point_data = {vtu_array("p", 1, position)};
  data.point_data[0].components = 2;
  REQUIRE_THROWS_AS(write_vtu(file, data), error);
  const std::vector<double> two{1, 2};
  data.point_data = {vtu_array("p", 1, two), vtu_array("p", 1, two)};
  REQUIRE_THROWS_AS(write_vtu(file, data), error);
  data.point_data = {vtu_array("", 1, two)};
  REQUIRE_THROWS_AS(write_vtu(file, data), error);
  data = two_points(position);
  data.cell_data = {vtu_array("c", 1, three)};
  REQUIRE_THROWS_AS(write_vtu(file, data), error);
  data = two_points(position);
  data.cells = {vtu_cells(line)};
  REQUIRE_THROWS_WITH(write_vtu(file, data), "point of cell 0 of block 0 = 2: must be less than 2");
  data.points = vtu_array("", 2, position);
  REQUIRE_THROWS_AS(write_vtu(file, data), error);
  REQUIRE_THROWS_AS(vtu_array("p", 6, three), error);

  // A recipe that throws in the middle of the file.
  data = two_points(position);
  data.point_data = {vtu_array("p", 2, [](std::size_t i) { return i == 0 ? 1.0 : throw error("stop"); })};
  REQUIRE_THROWS_WITH(write_vtu(file, data), "stop");
  REQUIRE(bytes_of(file) == before);
  REQUIRE_FALSE(fs::exists(folder() / "refused.vtu.part"));
}

TEST_CASE("ranks that begin one series at once try its folder each for itself") {
  const fs::path list = folder() / "of_ranks.pvd";
  std::atomic<int> refused = 0;
  std::array<std::thread, 2> ranks;
  for (auto& rank : ranks)
    rank = std::thread([&] {
      for (int n = 0; n < 2000; ++n) {
        std::error_code ignored;
        fs::remove(list, ignored);
        try {
          PvdWriter(list, true);
        } catch (const error&) {
          ++refused;
        }
      }
    });
  for (auto& rank : ranks) rank.join();
  CHECK(refused == 0);
  CHECK_FALSE(fs::exists(list));
}

TEST_CASE("a folder that is not there or is a file is reported") {
  const std::vector<double> position{0, 0, 0, 1, 2, 3};
  std::ofstream(folder() / "plain") << "file";
  for (const char* bad : {"absent/x.vtu", "plain/x.vtu"}) {
    INFO(bad);
    REQUIRE_THROWS_AS(write_vtu(folder() / bad, two_points(position)), error);
    for (const bool keep : {false, true}) REQUIRE_THROWS_AS(PvdWriter(folder() / bad, keep), error);
  }
  fs::create_directories(folder() / "taken.vtu" / "inside");  // a folder of that name: rename must fail
  REQUIRE_THROWS_AS(write_vtu(folder() / "taken.vtu", two_points(position)), error);
  REQUIRE_FALSE(fs::exists(folder() / "taken.vtu.part"));
  fs::remove_all(folder() / "taken.vtu");
}

TEST_CASE("long double is written as double: VTK has no longer number") {
  const VtuArray array = vtu_array("p", 2, [](std::size_t i) {
    return std::array{0.1L, 1.5L, static_cast<long double>(i)};
  });
  REQUIRE(array.type == "Float64");
  std::array<double, 6> written{};
  REQUIRE(array.number_bytes * array.components * array.items == sizeof written);
  array.fetch(0, 2, reinterpret_cast<char*>(written.data()));
  REQUIRE(written == std::array{static_cast<double>(0.1L), 1.5, 0.0, static_cast<double>(0.1L), 1.5, 1.0});
}
