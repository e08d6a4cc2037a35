// Ground at rest: geostatic stresses are those of the scene's gravity, of layers and of what lies on them,
// and a first step that finds the ground out of balance reports it.
#include <arenite/arenite.hpp>
#include <arenite/mesh/box_mesh.hpp>

#include "catch.hpp"
#include "meshes.hpp"
#include "warnings.hpp"

using namespace arenite;

namespace {

LinearElastic soil(double density) {
  return LinearElastic{{.density = density, .young = 1e7, .poisson = 0.3}};
}
FillOptions at_rest(Geostatic ground, int per_cell = 4) { return {.per_cell = per_cell, .stress = ground}; }
const auto held = walls(left(roller), right(roller), bottom(roller));
using Splines = Numerics<QuadraticBSpline, Apic>;

/// On a grid of 1 m x 1.2 m, cells of 5 cm.
template <class N = Splines, class K = PlaneStrain, class... Parts>
auto on_grid(Parts... parts) {
  return Scene{K{}, CartesianGrid<2>{{.lower = {0, 0}, .upper = {1, 1.2}, .cell = 0.05}}, N{}, parts...};
}
template <class N = Splines, class K = PlaneStrain>
auto ground(FillOptions options, double top = 1, Walls around = held) {
  return on_grid<N, K>(bodies(fill(Box{{0., 0.}, {1., top}}, soil(1600), options)), around,
                       gravity({0, -1.62}));
}

/// Two bodies that touch at a vertical face, the second with its own `k0`.
auto side_by_side(double k0, auto contact) {
  return on_grid(
      bodies(fill<"left">(Box{{0., 0.}, {0.5, 1.}}, soil(2000), at_rest({.surface = 1, .k0 = 0.5})),
             fill<"right">(Box{{0.5, 0.}, {1., 1.}}, soil(2000), at_rest({.surface = 1, .k0 = k0}))),
      contact, held, gravity({0, -10}));
}

/// Warnings of the first step of a scene.
template <class Scene>
std::vector<std::string> said(Scene scene) {
  return test::warnings_of([&] {
    const double dt = 0.1 * stable_step(scene);
    step(scene, dt);
    step(scene, dt);
  });
}
template <class Scene>
void is_told(Scene scene, const std::string& part) {
  const auto texts = said(std::move(scene));
  REQUIRE(texts.size() == 1);
  CHECK_THAT(texts[0],
             Catch::StartsWith("the ground is not at rest: in the first step ") && Catch::Contains(part));
}

/// Vertical stress of the point of a body nearest to a place, Pa.
template <class B>
double stress_at(const B& body, const Vec<double, 2>& x, std::size_t component = 1) {
  std::size_t nearest = 0;
  for (std::size_t p = 0; p < body.points.size(); ++p)
    if ((body.points.position[p] - x).norm() < (body.points.position[nearest] - x).norm()) nearest = p;
  return body.points.stress[nearest][component];
}

}  // namespace

TEST_CASE("Geostatic stress is that of the scene's gravity, whatever gives it") {
  const auto filled = [](auto... pulls) {
    return on_grid(bodies(fill(Box{{0., 0.}, {1., 1.}}, soil(1600), at_rest({.surface = 1, .k0 = 0.5}))),
                   held, pulls...);
  };
  const Vec<double, 2> x(0.5125, 0.2125);
  const double depth = 1 - x[1];
  CHECK(stress_at(filled(gravity({0, -1.62})).body(), x) == Approx(-1600 * 1.62 * depth));
  CHECK(stress_at(filled(gravity({0, -1.62}, Ramp{.over = 1, .from = 0.5})).body(), x) ==
        Approx(-1600 * 0.81 * depth));
  const auto pull = [](const Triple&, double) { return Triple{0, -3, 0}; };
  CHECK(stress_at(filled(body_force(pull)).body(), x) == Approx(-1600 * 3 * depth));
  CHECK(stress_at(filled(body_force(pull), gravity({0, -1})).body(), x, 0) ==
        Approx(-0.5 * 1600 * 4 * depth));
  CHECK_THROWS_WITH(filled(),
                    "Geostatic: gravity at t = 0 s = (0, 0, 0): must act when the ground is filled; a "
                    "stress without gravity is a function of the position");
  CHECK_THROWS_WITH(filled(gravity({0, -9.81}, Ramp{.over = 1})),
                    Catch::Contains("must act when the ground is"));
  CHECK_THROWS_WITH(filled(gravity({5, -8})),
                    Catch::StartsWith("Geostatic: gravity = (5, -8, 0): must act along"));
  const auto spun = [](const Triple& at, double) { return Triple{0, -at[1], 0}; };
  CHECK_THROWS_WITH(filled(body_force(spun)), Catch::Contains("must be the same everywhere"));

  // Upwards and sideways: matter farther along gravity carries more.
  CHECK(stress_at(
            on_grid(bodies(fill(Box{{0., 0.2}, {1., 1.2}}, soil(1600), at_rest({.surface = 0.2, .k0 = 0.5}))),
                    walls(top(roller)), gravity({0, 2}))
                .body(),
            x) == Approx(-1600 * 2 * (x[1] - 0.2)));
  CHECK(
      stress_at(on_grid(bodies(fill(Box{{0., 0.}, {1., 1.}}, soil(1600), at_rest({.surface = 1, .k0 = 0.5}))),
                        walls(left(roller)), gravity({-2, 0}))
                    .body(),
                x, 0) == Approx(-1600 * 2 * (1 - x[0])));

  auto running = filled(gravity({0, -1.62}));
  insert_points(running, Box{{0., 1.}, {1., 1.2}}, at_rest({.surface = 1.2, .k0 = 0.5}));
  CHECK(stress_at(running.body(), {0.5125, 1.0125}) == Approx(-1600 * 1.62 * 0.1875));
}

TEST_CASE("Layers: the stress below is the weight of all that lies above") {
  const Geostatic one{.surface = 1, .k0 = 0.5};
  const auto layers = [&](const Geostatic& low, auto... more) {
    return on_grid(bodies(fill<"low">(Box{{0., 0.}, {1., 0.525}}, soil(2000), at_rest(low)),
                          fill<"high">(Box{{0., 0.525}, {0.5, 1.}}, soil(1000), at_rest(one)),
                          fill<"beside">(Box{{0.5, 0.525}, {1., 1.}}, soil(1000), at_rest(one))),
                   held, gravity({0, -10}), more...);
  };
  const auto scene = layers(one);
  CHECK(stress_at(scene.body<"high">(), {0.2125, 0.6125}) == Approx(-1000 * 10 * 0.3875));
  CHECK(stress_at(scene.body<"low">(), {0.2125, 0.0125}) == Approx(-10 * (475 + 2000 * 0.5125)));
  // The mean stress of a layer of points carries the points above, and half of the layer.
  double above = 0, stress = 0, area = 0;
  scene.for_each_body([&](const auto& body, const auto&) {
    for (std::size_t p = 0; p < body.points.size(); ++p) {
      const double y = body.points.position[p][1];
      if (std::abs(y - 0.2125) < 1e-6) {
        stress += body.points.stress[p][1] * 0.025;
        area += 0.025;
        above += body.points.mass[p] * 10 / 2;
      } else if (y > 0.2125) {
        above += body.points.mass[p] * 10;
      }
    }
  });
  CHECK(area == Approx(1));
  CHECK(-stress == Approx(above));
  CHECK(said(scene).empty());
  // The same said in other words: a surface where the body ends, and what lies on it.
  const auto said_so = layers({.surface = 0.525, .k0 = 0.5, .surcharge = 4750});
  CHECK(stress_at(said_so.body<"low">(), {0.2125, 0.0125}) == Approx(-10 * (475 + 2000 * 0.5125)));
  CHECK(stress_at(said_so.body<"low">(), {0.2125, 0.0125}, 0) == Approx(-5 * (475 + 2000 * 0.5125)));
  is_told(layers({.surface = 0.525, .k0 = 0.5}), ", 0.525) m");

  auto data = test::triangles({0, 0}, {1, 1}, 10, 10);
  for (std::size_t c = 0; c < data.cells.size(); ++c)
    data.region[c] = data.nodes[data.cells[c][0]][1] < 0.45 ? 0 : 1;
  data.region_names = {{"low", 0}, {"high", 1}};
  const Scene cells{PlaneStrain{},
                    SimplexMesh<2>(data),
                    Numerics<LinearSimplex, Flip>{},
                    bodies(fill<"low">(Box{{0., 0.}, {1., 0.5}}, soil(2000), at_rest(one, 3)),
                           fill<"high">(Box{{0., 0.5}, {1., 1.}}, soil(1000), at_rest(one, 3))),
                    held,
                    gravity({0, -10})};
  CHECK(said(cells).empty());
}

TEST_CASE("Ground that is at rest says nothing, whatever its points and functions") {
  const Geostatic one{.surface = 1, .k0 = 0.5};
  for (const int per_cell : {1, 4, 9}) {
    CAPTURE(per_cell);
    CHECK(said(ground(at_rest(one, per_cell))).empty());
    CHECK(said(ground<Splines, Axisymmetric>(at_rest(one, per_cell))).empty());
    CHECK(said(ground<Numerics<CubicBSpline, Flip>>(at_rest(one, per_cell))).empty());
  }
  CHECK(said(ground(at_rest({.surface = 1.025, .k0 = 0.5}), 1.025)).empty());
  for (const double top : {0.96, 0.97, 0.981, 0.99, 1.002, 1.01}) {
    FillOptions cut = at_rest({.surface = top, .k0 = 0.5});
    cut.exact_volume = true;
    CAPTURE(top);
    CHECK(said(ground(cut, top)).empty());
  }
  const auto mesh = test::triangles({0, 0}, {1, 1}, 10, 10);
  for (const int per_cell : {1, 3, 4})
    CHECK(said(Scene{Axisymmetric{}, SimplexMesh<2>(mesh), Numerics<LinearSimplex, Flip>{},
                     bodies(fill(Box{{0., 0.}, {1., 1.}}, soil(1600), at_rest(one, per_cell))), held,
                     gravity({0, -1.62})})
              .empty());
  CHECK(
      said(Scene{ThreeDimensional{},
                 CartesianGrid<3>{{.lower = {0, 0, 0}, .upper = {1, 1, 1.5}, .cell = 0.25}}, Splines{},
                 bodies(fill(Box{{0., 0., 0.}, {1., 1., 1.}}, soil(1600), at_rest(one, 8))),
                 walls(left(roller), right(roller), bottom(roller), top(roller), back(roller), front(roller)),
                 gravity({0, 0, -1.62})})
          .empty());
  // A frictional wall supports the bottom, contact a second body, and one flies above.
  CHECK(said(on_grid(bodies(fill<"low">(Box{{0., 0.}, {1., 0.5}}, soil(2000),
                                        at_rest({.surface = 0.8, .k0 = 0.5})),
                            fill<"high">(Box{{0., 0.5}, {1., 0.8}}, soil(1000),
                                         at_rest({.surface = 0.8, .k0 = 0.5})),
                            fill<"stone">(Ball({0.5, 0.95}, 0.1), soil(2000),
                                          {.velocity = {0, -3, 0}, .exact_volume = true})),
                     Coulomb(Friction(0.5)), walls(left(roller), right(roller)),
                     frictional(bottom(), Friction(0.5)), gravity({0, -10})))
            .empty());
  // Two bodies side by side, each with its own field.
  for (const double friction : {0., 0.5}) CHECK(said(side_by_side(0.5, Coulomb(Friction(friction)))).empty());
  // A rigid body that strikes, and loads that lie on it.
  const auto with = [&](const Geostatic& g, auto... more) {
    return on_grid(bodies(fill(Box{{0., 0.}, {1., 1.}}, soil(1600), at_rest(g))), held, gravity({0, -10}),
                   more...);
  };
  const Guided falls{.mass = 10, .velocity = -5};
  CHECK(
      said(with(one, rigids(rigid(DistanceSurface{Ball({0.5, 1.05}, 0.1)}, falls, Friction(0.3))))).empty());
}

TEST_CASE("Ground that is not at rest is reported once, with its share and its place") {
  const Geostatic one{.surface = 1, .k0 = 0.5};
  is_told(ground(at_rest({.surface = 1.05, .k0 = 0.5})), ", 1.025) m. Stress is Geostatic");
  is_told(ground(at_rest({.surface = 0.9, .k0 = 0.5})), " % of its weight is out of balance");
  is_told(ground(at_rest(one), 1, walls(left(roller), bottom(roller))), " % of its weight");
  for (const double jitter : {0.05, 1.0}) {
    FillOptions random = at_rest(one);
    random.jitter = jitter;
    is_told(ground(random), joined_text({"Its points have a jitter of ", jitter, ", and sums over random"}));
  }
  is_told(ground(at_rest({.surface = 1, .k0 = 0.5, .surcharge = 100})), " % of its weight");
  CHECK(said(ground(at_rest({.surface = 1, .k0 = 0.5, .may_move = true}), 1, walls(bottom(roller)))).empty());
  is_told(
      on_grid(bodies(fill<"low">(Box{{0., 0.}, {1., 0.5}}, soil(2000), at_rest({.surface = 0.5, .k0 = 0.5})),
                     fill<"block">(Box{{0.3, 0.5}, {0.7, 0.8}}, soil(2000))),
              held, gravity({0, -10})),
      " % of its weight");
  is_told(side_by_side(1, Coulomb(Friction(0.5))), "24.9 % of its weight");
  auto dug = ground(at_rest(one));
  remove_points(dug, Box{{0.5, 0.5}, {1., 1.}});
  CHECK(said(dug).empty());
  const auto slope = [](const auto& x) { return x[1] - 1 + 0.3 * x[0]; };
  is_told(on_grid(bodies(fill(Inside{slope}, soil(1600), at_rest(one))), held, gravity({0, -10})),
          " % of its");
}
