// Requested output of a run: tables of named columns, probes, section forces.
#include <arenite/arenite.hpp>
#include <arenite/mesh/box_mesh.hpp>
#include <arenite/observe/csv.hpp>
#include <arenite/observe/probe.hpp>
#include <arenite/observe/section.hpp>
#include <fstream>
#include <sstream>

#include "../mesh/sample_meshes.hpp"
#include "catch.hpp"

using namespace arenite;
using namespace arenite::test;

namespace {

const LinearElastic law{{.density = 2000, .young = 1e7, .poisson = 0.25}};
const FillOptions level{.per_cell = 4, .velocity = {1, -2, 0}, .stress = Geostatic{.surface = 2, .k0 = 0.5}};

/// Level ground 2 m high, 1 m wide, in a grid that is higher.
auto ground() {
  return Scene{PlaneStrain{},
               CartesianGrid<2>({.lower = {0, 0}, .upper = {1, 3}, .cell = 0.25}),
               Numerics<QuadraticBSpline>{},
               bodies(fill<"soil">(Box<2>{{0, 0}, {1, 2}}, law, level)),
               walls(left(roller), right(roller), bottom(roller)),
               gravity({0, -10})};
}

std::string text_of(const std::string& path) {
  std::ifstream in(path);
  std::ostringstream all;
  all << in.rdbuf();
  return all.str();
}

}  // namespace

TEST_CASE("Probe: constant fields as they are, linear ones in between") {
  const auto scene = ground();
  const auto found = probe<"soil">(scene, {0.4, 0.9, 0});
  REQUIRE(found);
  CHECK(found->velocity[0] == Approx(1));
  CHECK(found->velocity[1] == Approx(-2));
  CHECK(found->stress[1] == Approx(-2000 * 10 * 1.1).epsilon(1e-12));  // linear, away from faces
  CHECK(found->stress[0] == Approx(0.5 * found->stress[1]));
  CHECK(probe(scene, {0.5, 2.9, 0}) == std::nullopt);  // nothing there
  CHECK(probe(scene, {1.5, 0.5, 0}) == std::nullopt);  // no mesh
  CHECK_THROWS_WITH(probe(scene, {0.5, 0.5, 1}), Catch::Matchers::Contains("probe: place = 1"));

  SampleMesh<2> o{};
  o.cells = {6, 6};
  const Scene simplices{PlaneStrain{}, SimplexMesh<2>(sample_data(o)), Numerics<LinearSimplex>{},
                        bodies(fill(Box<2>{{0, 0}, {1, 1}}, law,
                                    {.per_cell = 3, .velocity = {3, 4, 0}, .stress = [](const auto&) {
                                       return std::array<double, 6>{-1, -2, -3, 4, 0, 0};
                                     }}))};
  for (const double x : {0.01, 0.3, 0.77}) {
    const auto there = probe(simplices, {x, 1 - x, 0});
    REQUIRE(there);
    CHECK((there->velocity - Vec<double, 2>(3, 4)).norm() < 1e-14);
    for (std::size_t k = 0; k < 4; ++k) CHECK(there->stress[k] == Approx(std::array{-1., -2., -3., 4.}[k]));
  }
}

TEST_CASE("Section force: the weight above, the pressure beside, a part of the cut") {
  const auto scene = ground();
  for (const double y : {0.5, 1.03, 1.6}) {
    const auto force =
        section_force<"soil">(scene, {.through = {0, y, 0}, .normal = {0, 3, 0}, .thickness = 0.5});
    CHECK(force[1] == Approx(-2000 * 10 * (2 - y)).epsilon(1e-12));
    CHECK(force[0] == Approx(0).margin(1e-9));
  }
  const Section upright{.through = {0.5, 0, 0}, .normal = {-1, 0, 0}, .thickness = 0.5};
  CHECK(section_force(scene, upright)[0] == Approx(0.5 * 2000 * 10 * 2));  // half of g h^2 / 2, times k0
  CHECK(section_force(scene, upright, Box<2>{{0, 1}, {1, 3}})[0] == Approx(0.5 * 2000 * 10 * 0.5));
  CHECK_THROWS_WITH(section_force(scene, {.normal = {1, 0, 0}}),
                    Catch::Matchers::Contains("Section.thickness = nan: must be given"));
  CHECK_THROWS_WITH(section_force(scene, {.normal = {0, 0, 1}, .thickness = 1}),
                    Catch::Matchers::Contains("Section.normal"));
}

TEST_CASE(
    "Nodal section force: a cantilever on coarse triangles, in balance with the weight beyond the cut") {
  Scene beam{PlaneStrain{},
             SimplexMesh<2>(box_mesh<2>({{0, 0}, {1.2, 0.6}, {12, 6}})),
             Numerics<LinearSimplex>{},
             bodies(fill(Box{{0., 0.2}, {1., 0.4}},
                         LinearElastic{{.density = 1000, .young = 1e7, .poisson = 0.3}}, {.per_cell = 3})),
             walls(left(fixed)),
             gravity({0, -1}),
             LocalDamping{}};
  settle(beam, {.ratio = 1e-5, .end = 60});
  for (const double x : {0.25, 0.5, 0.525}) {
    CAPTURE(x);
    const double weight = 0.2 * (1 - x) * 1000;
    const auto force =
        nodal_section_force(beam, {.through = {x, 0, 0}, .normal = {1, 0, 0}, .thickness = 0.2});
    CHECK(std::abs(-force[1] / weight - 1) <= 5e-4);
    const auto back =
        nodal_section_force(beam, {.through = {x, 0, 0}, .normal = {-2, 0, 0}, .thickness = 0.2});
    CHECK((force + back).norm() <= 1e-9 * weight);
  }
  CHECK_THROWS_WITH(nodal_section_force(beam, {.normal = {1, 0, 0}}),
                    Catch::Matchers::Contains("Section.thickness = nan"));
}

TEST_CASE("Table: named columns at intervals, numbers that read back, a run that continues") {
  const auto table = [](const std::string& path) {
    return csv(path, CsvColumn{"steps", [](const auto& scene) { return scene.steps; }},
               CsvColumn{"momentum", [](const auto& scene) { return momentum(scene.body()); }},
               CsvColumn{"there", [](const auto& scene) {
                           const auto at = probe(scene, {0.5, 2.9, 0});
                           return at ? std::optional(at->stress[1]) : std::nullopt;
                         }});
  };
  auto scene = ground();
  auto every_other = every(0.02, table("tables/new/run.csv"));
  run(scene, {.end = 0.05, .max_step = 0.005}, every_other);
  std::istringstream in(text_of("tables/new/run.csv"));
  std::string line;
  std::getline(in, line);
  CHECK(line == "time,steps,momentum_x,momentum_y,there");
  int rows = 0;
  while (std::getline(in, line)) {
    std::istringstream row(line);
    double time = -1, steps = -1;
    char comma = 0;
    row >> time >> comma >> steps;
    CHECK(time >= 0.02 * rows);
    CHECK(time < 0.02 * rows + 0.0051);
    CHECK(line.back() == ',');  // an empty field
    if (rows == 0) CHECK(line == "0,0,4000,-8000,");
    ++rows;
  }
  CHECK(rows == 3);

  auto before = table("tables/goes_on.csv");
  before(scene);
  const std::string one = text_of("tables/goes_on.csv");
  std::uintmax_t bytes = 0;
  before.visit_state([&](std::string_view, auto& value) { bytes = value; });
  CHECK(bytes == one.size());
  before(scene);  // a row that the saved state does not know
  auto after = table("tables/goes_on.csv");
  after.visit_state([&](std::string_view, auto& value) { value = bytes; });
  after.follow_state(scene);
  after(scene);
  CHECK(text_of("tables/goes_on.csv") == one + one.substr(one.find('\n') + 1));
  auto other = csv("tables/goes_on.csv", CsvColumn{"x", [](const auto&) { return 1; }});
  other.visit_state([&](std::string_view, auto& value) { value = bytes; });
  CHECK_THROWS_WITH(other(scene), Catch::Matchers::Contains("must be there, with the columns time,x"));
}
