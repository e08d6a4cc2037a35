// Loads on faces of the mesh without matter: reported once, in the first step with a load, with the share
// that acts.
#include <arenite/arenite.hpp>

#include "catch.hpp"
#include "meshes.hpp"
#include "warnings.hpp"

using namespace arenite;

namespace {

const LinearElastic soft{{.density = 1000, .young = 1e6, .poisson = 0.3}};
const Box<2> low{{0., 0.}, {0.4, 1.}};  ///< in a mesh of 0.4 x 1.1 m it leaves a row of cells empty

/// The warnings of some steps of a scene.
template <class Scene>
std::vector<std::string> told(Scene scene, int steps = 3) {
  return test::warnings_of([&] {
    for (int k = 0; k < steps; ++k) step(scene, 1e-5);
  });
}
template <class... Parts>
auto on_grid(double top_of_mesh, const Box<2>& region, Parts... parts) {
  return Scene{PlaneStrain{}, CartesianGrid<2>{{.lower = {0, 0}, .upper = {0.4, top_of_mesh}, .cell = 0.1}},
               Numerics<QuadraticBSpline, Apic>{}, bodies(fill(region, soft)), parts...};
}
template <class... Parts>
auto on_triangles(double top_of_mesh, const Box<2>& region, Parts... parts) {
  const auto data =
      test::triangles({0, 0}, {0.4, top_of_mesh}, 4, static_cast<Index>(std::lround(10 * top_of_mesh)));
  return Scene{PlaneStrain{}, SimplexMesh<2>(data), Numerics<LinearSimplex, Flip>{},
               bodies(fill(region, soft, {.per_cell = 3})), parts...};
}

}  // namespace

TEST_CASE(
    "A load on faces without material at them is reported once, with the share that acts and the cure") {
  for (const auto& texts :
       {told(on_grid(1.1, low, pressure(top(), 1e4))), told(on_triangles(1.1, low, pressure(top(), 1e4)))}) {
    REQUIRE(texts.size() == 1);
    CHECK(texts[0] ==
          "pressure on top: 0 % of it acts on matter; the rest is lost on faces without any behind them; end "
          "the mesh "
          "where the body ends, or load its points, pressure(surface(..), ..)");
  }
  const Box<2> half{{0., 0.}, {0.2, 1.}};
  auto texts = told(on_grid(1, half, traction(top(), {1e3, 0})));
  REQUIRE(texts.size() == 1);
  CHECK_THAT(texts[0], Catch::StartsWith("traction on top: 50 % of it acts on matter") &&
                           Catch::EndsWith("traction(surface(..), ..)"));
  CHECK(told(on_triangles(1, half, traction(top(), {1e3, 0}))).size() == 1);
}

TEST_CASE("A load that material takes, and one that is zero, are not reported") {
  CHECK(told(on_grid(1, low, pressure(top(), 1e4))).empty());
  CHECK(told(on_triangles(1, low, pressure(top(), 1e4))).empty());
  CHECK(told(on_grid(1.1, low, pressure(top(), 0))).empty());
  // There is matter below the loaded strip.
  const ScalarFunction strip([](const Triple& x, double) { return x[0] < 0.2 ? 1e4 : 0; });
  CHECK(told(on_grid(1, Box<2>{{0., 0.}, {0.2, 1.}}, pressure(top(), strip))).empty());
  // The load need not have a value where there is no matter.
  const ScalarFunction there([](const Triple& x, double) { return x[0] < 0.2 ? 1e4 : std::nan(""); });
  CHECK(told(on_grid(1, Box<2>{{0., 0.}, {0.2, 1.}}, pressure(top(), there))).empty());
  // The matter ends within the cells at the faces.
  CHECK(told(on_grid(1, Box<2>{{0., 0.}, {0.4, 0.95}}, pressure(top(), 1e4))).empty());
}

TEST_CASE("A load that grows from zero is checked when it acts, when material may have come") {
  const Ramp later{.to = 1e4, .over = 1, .start = 2.5e-5};
  auto scene = on_grid(1.1, low, pressure(top(), later));
  CHECK(told(scene, 3).empty());
  CHECK(told(scene, 10).size() == 1);
  auto filled = on_grid(1.1, low, pressure(top(), later));
  insert_points(filled, Box<2>{{0., 1.}, {0.4, 1.1}});
  CHECK(told(filled, 10).empty());
}

TEST_CASE("Absorbing faces without any material at them are reported") {
  const Box<2> raised{{0., 0.1}, {0.4, 1.}}, half{{0., 0.}, {0.2, 1.}};
  for (const auto& texts :
       {told(on_grid(1, raised, absorbing(bottom()))), told(on_triangles(1, raised, absorbing(bottom())))}) {
    REQUIRE(texts.size() == 1);
    CHECK(texts[0] ==
          "absorbing(bottom): 0 % of the faces have matter behind them: they absorb nothing; end the mesh "
          "where the "
          "body ends");
  }
  CHECK(told(on_grid(1, half, absorbing(bottom()))).empty());
  CHECK(told(on_triangles(1, half, absorbing(bottom()))).empty());
}
