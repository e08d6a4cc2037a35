// Warnings of a new scene about its rigid bodies: matter inside of them, and walls too thin to retain it.
#include <arenite/arenite.hpp>
#include <arenite/geometry/triangle_surface.hpp>

#include "catch.hpp"
#include "meshes.hpp"
#include "warnings.hpp"

using namespace arenite;

namespace {

const LinearElastic soft{{.density = 1000, .young = 1e6, .poisson = 0.3}};
const Prescribed still{[](double) { return std::array{0.0, 0.0, 0.0}; }};

/// Of a rigid body in the unit square, cells of 0.05 m, and a region of sand with 4 points a cell.
template <class Region, class Shape>
std::vector<std::string> told(Region region, Shape shape, double reach = 0.5) {
  return test::warnings_of([&] {
    return Scene{PlaneStrain{}, CartesianGrid<2>{{.lower = {0, 0}, .upper = {1, 1}, .cell = 0.05}},
                 Numerics<QuadraticBSpline, Apic>{}, bodies(fill<"sand">(std::move(region), soft)),
                 rigids(rigid<"f">(DistanceSurface{std::move(shape), reach}, still, Friction(0)))};
  });
}
/// The same in the unit cube, cells of 0.1 m, 8 points a cell.
template <class Region, class Shape>
std::vector<std::string> told_in_space(Region region, Shape shape) {
  return test::warnings_of([&] {
    return Scene{ThreeDimensional{}, CartesianGrid<3>{{.lower = {0, 0, 0}, .upper = {1, 1, 1}, .cell = 0.1}},
                 Numerics<QuadraticBSpline, Apic>{}, bodies(fill(std::move(region), soft, {.per_cell = 8})),
                 rigids(rigid(DistanceSurface{std::move(shape)}, still, Friction(0)))};
  });
}

const Box<2> sand{{0., 0.}, {1., 0.6}};

TriangleData cube(const std::array<double, 3>& lower, double edge) {
  TriangleData data;
  for (int k = 0; k < 8; ++k)
    data.vertices.push_back(
        {lower[0] + edge * (k & 1), lower[1] + edge * (k >> 1 & 1), lower[2] + edge * (k >> 2)});
  data.triangles = {{0, 2, 1}, {1, 2, 3}, {4, 5, 6}, {5, 7, 6}, {0, 1, 4}, {1, 5, 4},
                    {2, 6, 3}, {3, 6, 7}, {0, 4, 2}, {2, 4, 6}, {1, 3, 5}, {3, 7, 5}};
  return data;
}

}  // namespace

TEST_CASE("Material inside of a rigid body is reported, with the cure, from the first point") {
  auto texts = told(sand, Box<2>{{0.3, 0.3}, {0.7, 0.9}});
  REQUIRE(texts.size() == 1);
  CHECK_THAT(texts[0], Catch::StartsWith(
                           "rigid body f: 192 of the 960 points of body sand lie inside of it: fill what it "
                           "leaves of the region, fill(region - shape, ..)"));
  // One point: of a ball of one and a half cells in a cell's corner, and of a plate's first row of points.
  CHECK(told(sand, Box<2>{{0.3, 0.575}, {0.325, 0.9}}).size() == 2);  // and it is half a cell thin
  texts = told(sand, Ball({0.3375, 0.5125}, 0.016));
  REQUIRE_FALSE(texts.empty());
  CHECK_THAT(texts[0], Catch::Contains("1 of the 960 points"));
}

TEST_CASE("Material that a rigid body touches, or that ends within half a point's size inside, is no fault") {
  CHECK(told(sand, Box<2>{{0.3, 0.6}, {0.7, 0.9}}).empty());               // rests on it
  CHECK(told(sand, Box<2>{{0.3, 0.6 - 0.0249 / 2}, {0.7, 0.9}}).empty());  // points of 0.025 m
  CHECK(told(sand, Box<2>{{0.3, 0.5875}, {0.7, 0.9}}).empty());            // points on its face
  CHECK(told(Box<2>{{0.3, 0.3}, {0.7, 0.7}}, Box<2>{{0., 0.}, {1., 1.}} - Box<2>{{0.2, 0.2}, {0.8, 0.8}})
            .empty());  // a drum that contains it
  CHECK(told(sand, [](const Vec<double, 2>& x) { return 0.7 - x[1]; }).empty());
}

TEST_CASE("region - shape leaves out what any surface of a rigid body takes") {
  const auto cured = [](auto shape) { return told(sand - shape, shape); };
  CHECK(cured(Box<2>{{0.31, 0.33}, {0.72, 0.9}}).empty());
  CHECK(cured(Ball({0.5, 0.5}, 0.21)).empty());
  CHECK(cured(RoundedBox<2>(Box<2>{{0.31, 0.33}, {0.72, 0.9}}, 0.1)).empty());
  CHECK(cured(Capsule({0.3, 0.3}, {0.6, 0.5}, 0.11)).empty());
  CHECK(cured(Polygon({{0.2, 0.2}, {0.7, 0.3}, {0.5, 0.8}})).empty());
  CHECK(cured(ConeCylinder({.radius = 0.2, .apex = 60_deg, .length = 0.6, .tip = 0.3})).empty());
  CHECK(
      cured(placed(Box<2>{{-0.2, -0.2}, {0.2, 0.3}}, {.at = {0.5, 0.5, 0}, .turned = {0, 0, 0.3}})).empty());
  CHECK(cured(Box<2>{{0.31, 0.33}, {0.72, 0.9}} | Ball({0.5, 0.3}, 0.2)).empty());
  CHECK(cured(Inside{[](const Vec<double, 2>& x) {
          return std::hypot(x[0] - 0.5, x[1] - 0.5) - 0.2;
        }}).empty());
  const Box<3> all{{0., 0., 0.}, {1., 1., 0.6}};
  const auto in_space = [&](auto shape) {
    const auto without = told_in_space(all, shape);
    REQUIRE(without.size() == 1);
    CHECK_THAT(without[0], Catch::Contains("of the 4800 points of body 0 lie inside of it"));
    CHECK(told_in_space(all - shape, shape).empty());
  };
  in_space(Ball({0.5, 0.5, 0.5}, 0.21));
  in_space(Cylinder({0.5, 0.5, 0.3}, {0.5, 0.5, 0.9}, 0.21));
  in_space(TriangleSurface(cube({0.3, 0.3, 0.3}, 0.4)));
}

TEST_CASE("Material in the region of a rigid body's surface in the mesh is reported") {
  const auto told_on = [](auto region) {
    return test::warnings_of([&] {
      auto data = test::triangles({0, 0}, {1, 1}, 10, 10);
      test::name_region(data, "tool", [](const auto& x) {
        return Box<2>{{0.3, 0.5}, {0.7, 1.}}.contains(x);
      });
      return Scene{PlaneStrain{}, SimplexMesh<2>(data), Numerics<LinearSimplex, Flip>{},
                   bodies(fill<"sand">(std::move(region), soft, {.per_cell = 3})),
                   rigids(rigid<"f">(MeshSurface{"tool"}, still, Friction(0)))};
    });
  };
  CHECK(told_on(Cells("all")).empty());
  const auto texts = told_on(sand);
  REQUIRE(texts.size() == 1);
  CHECK_THAT(texts[0],
             Catch::StartsWith("rigid body f: 24 of the 360 points of body sand lie inside of it") &&
                 Catch::Contains("Cells(..)"));
}

TEST_CASE("A wall that is thinner than a cell is reported, with its thickness") {
  const Box<2> fill_here{{0.4, 0.4}, {0.6, 0.6}};
  const auto cup = [](double thick, double at, double turned = 0.) {
    const double t = thick * 0.05;
    return placed(
        Box<2>{{-t, -t}, {0.4 + t, 0}} | Box<2>{{-t, -t}, {0, 0.4}} | Box<2>{{0.4, -t}, {0.4 + t, 0.4}},
        {.at = {at, 0.3, 0}, .turned = {0, 0, turned}});
  };
  for (const double at : {0.3, 0.31, 0.325, 0.337})
    for (const double turned : {0., 0.1}) {
      CAPTURE(at, turned);
      for (const double thick : {0.1, 0.5, 0.9}) {
        const auto texts = told(fill_here, cup(thick, at, turned));
        REQUIRE(texts.size() == 1);
        CHECK_THAT(texts[0],
                   Catch::StartsWith(joined_text({"rigid body f: a wall is ", thick, " cells thick at ("})) &&
                       Catch::Contains("PointContact"));
      }
      CHECK(told(fill_here, cup(1.02, at, turned)).empty());
      CHECK(told(fill_here, cup(2, at, turned)).empty());
      // Half of the wall with the reach must span the next row of nodes.
      CHECK(told(fill_here, cup(0.3, at, turned), 0.86).empty());
      CHECK(told(fill_here, cup(0.3, at, turned), 0.8).size() == 1);
      CHECK(told(fill_here, cup(1.9, at, turned), 0).size() == 1);
      CHECK(told(fill_here, cup(2.02, at, turned), 0).empty());
    }
  const Box<2> low{{0., 0.}, {1., 0.2}};
  const auto wall = Polygon({{0.2, 0.4}, {0.8, 0.4}, {0.8, 0.43}, {0.2, 0.43}});
  CHECK_THAT(told(low, wall).at(0), Catch::StartsWith("rigid body f: a wall is 0.6 cells thick"));
  // A shell: thin where a disc is taken out of another.
  CHECK_THAT(told(low, Ball({0.5, 0.6}, 0.3) - Ball({0.5, 0.6}, 0.28)).at(0),
             Catch::StartsWith("rigid body f: a wall is 0.4 cells thick"));
  const auto plate = [](double thick) {
    return placed(Box<3>{{-0.3, -0.3, 0}, {0.3, 0.3, thick}},
                  {.at = {0.5, 0.5, 0.5}, .turned = {0.3, 0.2, 0}});
  };
  const Box<3> bed{{0., 0., 0.}, {1., 1., 0.2}};
  CHECK_THAT(told_in_space(bed, plate(0.06)).at(0),
             Catch::StartsWith("rigid body 0: a wall is 0.6 cells thick"));
  CHECK(told_in_space(bed, plate(0.11)).empty());
}

TEST_CASE("How thick a wall must be follows from how far nodes are apart across it") {
  const auto told_on = [&](auto mesh, auto numerics, const Box<2>& wall) {
    return test::warnings_of([&] {
      return Scene{PlaneStrain{}, std::move(mesh), numerics, bodies(fill(Box<2>{{0., 0.}, {1., 0.2}}, soft)),
                   rigids(rigid(DistanceSurface{wall}, still, Friction(0)))};
    });
  };
  RectilinearGrid<2>::Parameters lines;
  for (int k = 0; k <= 20; ++k) lines.x.push_back(0.05 * k);
  for (int k = 0; k <= 10; ++k) lines.y.push_back(0.1 * k);
  const auto on_grid = [&](const Box<2>& wall) {
    return told_on(RectilinearGrid<2>(lines), Numerics<QuadraticBSpline, Apic>{}, wall);
  };
  CHECK(on_grid({{0.2, 0.4}, {0.8, 0.54}}).size() == 1);
  CHECK(on_grid({{0.2, 0.4}, {0.8, 0.56}}).empty());
  CHECK(on_grid({{0.2, 0.3}, {0.26, 0.9}}).empty());
  CHECK(on_grid({{0.2, 0.3}, {0.24, 0.9}}).size() == 1);
  // Triangles of halved squares: their altitude, the size, is 1 / sqrt(2) of what rows of nodes are apart.
  const auto on_triangles = [&](double thick) {
    const auto data = test::triangles({0, 0}, {1, 1}, 20, 20);
    return told_on(SimplexMesh<2>(data), Numerics<LinearSimplex, Flip>{},
                   Box<2>{{0.2, 0.4}, {0.8, 0.4 + thick}});
  };
  CHECK(on_triangles(0.06).size() == 1);
  CHECK(on_triangles(0.066).empty());
}

TEST_CASE("Tips, edges and bodies that are thick across are no walls") {
  const Box<2> low{{0., 0.}, {1., 0.2}};
  for (const double at : {0.5, 0.51, 0.525}) {
    CAPTURE(at);
    const auto cone = [&](double apex) {
      return placed(ConeCylinder({.radius = 0.1, .apex = apex, .length = 0.5}), {.at = {at, 0.31, 0}});
    };
    CHECK(told(low, cone(60_deg)).empty());
    CHECK(told(low, cone(30_deg)).empty());
    CHECK(told(low, Polygon({{at, 0.3}, {at + 0.2, 0.7}, {at - 0.2, 0.7}})).empty());
    CHECK(told(low, RoundedBox<2>(Box<2>{{at - 0.1, 0.3}, {at + 0.1, 0.6}}, 0.02)).empty());
    CHECK(told(low, Box<2>{{at - 0.03, 0.3}, {at + 0.03, 0.9}}).empty());
    CHECK(told(low, Box<2>{{-1., 0.25}, {2., 0.3 + at / 2}}).empty());
  }
  // A floor of which the mesh has only the upper face, and a half-plane.
  CHECK(told(Box<2>{{0., 0.1}, {1., 0.2}}, Box<2>{{-1., -0.02}, {2., 0.01}}).empty());
  CHECK(told(Box<2>{{0., 0.3}, {1., 0.4}}, [](const Vec<double, 2>& x) { return x[1] - 0.2; }).empty());
  const Box<3> bed{{0., 0., 0.}, {1., 1., 0.2}};
  CHECK(told_in_space(bed, Ball({0.5, 0.5, 0.5}, 0.13)).empty());
  CHECK(told_in_space(bed, Cylinder({0.5, 0.5, 0.4}, {0.5, 0.5, 0.9}, 0.2)).empty());
  CHECK(told_in_space(bed, placed(ConeCylinder({.radius = 0.15, .apex = 60_deg, .length = 0.5}),
                                  {.at = {0.5, 0.3, 0.5}}))
            .empty());
  CHECK(told_in_space(bed, TriangleSurface(cube({0.3, 0.3, 0.3}, 0.4))).empty());
}

TEST_CASE("Contact at points works at any thickness: no warning") {
  const auto texts = test::warnings_of([&] {
    return Scene{
        PlaneStrain{}, CartesianGrid<2>{{.lower = {0, 0}, .upper = {1, 1}, .cell = 0.05}},
        Numerics<QuadraticBSpline, Apic, Usl>{}, bodies(fill(Box<2>{{0.4, 0.4}, {0.6, 0.6}}, soft)),
        rigids(rigid(DistanceSurface{Box<2>{{0.2, 0.3}, {0.8, 0.31}}}, still, Friction(0), PointContact{}))};
  });
  CHECK(texts.empty());
}
