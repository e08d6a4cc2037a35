// Doubts: a new scene warns of what is allowed but hardly meant, once each, through the hook; and of nothing
// else.
#include <arenite/arenite.hpp>
#include <limits>
#include <thread>

#include "catch.hpp"
#include "meshes.hpp"
#include "warnings.hpp"

using namespace arenite;

namespace {

const LinearElastic rubber{{.density = 1000, .young = 1e6, .poisson = 0.3}};
constexpr double inf = std::numeric_limits<double>::infinity();

/// The warnings that `make()` gives.
template <class F>
std::vector<std::string> said(F&& make) {
  const std::size_t before = warning_count();
  const auto texts = test::warnings_of(make);
  CHECK(warning_count() - before == texts.size());
  return texts;
}

/// On a grid of the unit square.
template <class... Parts>
std::vector<std::string> on_grid(Parts... parts) {
  return said([&] {
    return Scene{PlaneStrain{}, CartesianGrid<2>{{.lower = {0, 0}, .upper = {1, 1}, .cell = 0.1}},
                 Numerics<QuadraticBSpline, Apic>{}, parts...};
  });
}
template <class... Parts>
std::vector<std::string> on_triangles(Parts... parts) {
  return said([&] {
    auto data = test::triangles({0, 0}, {1, 1}, 10, 10);
    return Scene{PlaneStrain{}, SimplexMesh<2>(data), Numerics<LinearSimplex, Flip>{}, parts...};
  });
}

bool has(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

}  // namespace

TEST_CASE(
    "A box that reaches beyond the mesh is reported with its share outside; one that ends with it is not") {
  const auto box = [&](std::array<double, 2> lower, std::array<double, 2> upper) {
    return bodies(fill(Box<2>{lower, upper}, rubber, {.per_cell = 9}));
  };
  auto texts = on_grid(box({0.5, 0.2}, {1.5, 0.4}));
  REQUIRE(texts.size() == 1);
  CHECK(has(texts[0], "body 0: 50 % of its region lies outside of the mesh"));
  texts = on_triangles(bodies(fill(Box{{-0.25, 0.}, {0.75, 1.}}, rubber, {.per_cell = 3})));
  REQUIRE(texts.size() == 1);
  CHECK(has(texts[0], "body 0: 25 %"));

  CHECK(on_grid(box({0, 0}, {1, 1})).empty());
  CHECK(on_grid(box({0, 0}, {1 + 1e-9, 0.5})).empty());
  CHECK(on_grid(box({-inf, -inf}, {inf, 0.5})).empty());
  CHECK(on_grid(bodies(fill(Inside{[](const Vec<double, 2>& x) { return x[1] - 0.5; }}, rubber))).empty());
  CHECK(on_triangles(bodies(fill(Cells("all"), rubber, {.per_cell = 3}))).empty());
}

TEST_CASE("Bodies in one place are reported once a pair; bodies that touch are not") {
  auto texts =
      on_grid(bodies(fill<"sand">(Box{{0., 0.}, {0.5, 0.5}}, rubber),
                     fill(Box{{0.4, 0.}, {0.8, 0.5}}, rubber), fill(Box{{0.8, 0.}, {1., 0.5}}, rubber)));
  REQUIRE(texts.size() == 1);
  CHECK(has(texts[0], "body sand and body 1 lie in one place: 20 of the 100 points of body sand"));
  const auto disc = [](double x) {
    return Inside{[x](const Vec<double, 2>& at) { return std::hypot(at[0] - x, at[1] - 0.5) - 0.2; }};
  };
  const FillOptions exact{.exact_volume = true};
  CHECK(on_grid(bodies(fill(disc(0.3), rubber, exact), fill(disc(0.5), rubber, exact))).size() == 1);
  CHECK(on_grid(bodies(fill(disc(0.3), rubber, exact), fill(disc(0.7), rubber, exact))).empty());
  // Boundaries within a cell, points of other numbers.
  CHECK(on_grid(bodies(fill(Box{{0., 0.}, {0.53, 1.}}, rubber, {.per_cell = 4, .exact_volume = true}),
                       fill(Box{{0.53, 0.}, {1., 1.}}, rubber, {.per_cell = 9, .exact_volume = true})))
            .empty());
  texts = on_triangles(bodies(fill(Cells("all"), rubber, {.per_cell = 3}),
                              fill(Box{{0.2, 0.2}, {0.4, 0.4}}, rubber, {.per_cell = 3})));
  REQUIRE(texts.size() == 1);
}

TEST_CASE("Points with another mass than their region's are reported with both") {
  const auto layer = [](double top, FillOptions o = {}) {
    return on_grid(bodies(fill<"base">(Box{{0., 0.}, {1., top}}, rubber, o)));
  };
  auto texts = layer(0.026);
  REQUIRE(texts.size() == 1);
  CHECK(has(texts[0],
            "body base: its points have 50 kg, its region 26 kg: a point stands for all of its sub-cell"));
  CHECK(has(texts[0], "FillOptions.exact_volume"));
  texts = layer(0.12, {.per_cell = 1});
  REQUIRE(texts.size() == 1);
  CHECK(has(texts[0], "its points have 100 kg, its region 120 kg"));
  CHECK(layer(0.026, {.exact_volume = true}).empty());
  CHECK(layer(0.05).empty());
  CHECK(layer(0.99).empty());  // 1 %
  CHECK(on_grid(bodies(fill(Box{{-inf, -inf}, {inf, 0.026}}, rubber))).size() == 1);
  texts = on_grid(bodies(fill(Ball({0.5, 0.5}, 0.08), rubber)));
  REQUIRE(texts.size() == 1);
  CHECK(has(texts[0], "its points have 30 kg, its region 20."));
  CHECK(on_triangles(bodies(fill(Box{{0., 0.}, {1., 0.07}}, rubber, {.per_cell = 1}))).size() == 1);
  CHECK(said([] {
          Scene scene{PlaneStrain{}, CartesianGrid<2>{{.lower = {0, 0}, .upper = {1, 1}, .cell = 0.1}},
                      Numerics<QuadraticBSpline, Apic>{},
                      bodies(fill<"base">(Box{{0., 0.}, {1., 0.5}}, rubber))};
          insert_points(scene, Box{{0., 0.5}, {1., 0.526}});
          return scene;
        }).size() == 1);
}

TEST_CASE("Gravity without a support along it is reported") {
  const auto block = bodies(fill(Box{{0.2, 0.2}, {0.5, 0.5}}, rubber));
  const Gravity down = gravity({0, -9.81});
  auto texts = on_grid(block, down);
  REQUIRE(texts.size() == 1);
  CHECK(has(texts[0], "gravity (0, -9.81) m/s2 acts, but no wall and no rigid body holds along it"));
  CHECK(on_grid(block, down, walls(left(roller), right(roller))).size() == 1);
  CHECK(on_grid(block, down, walls(left(free_along(1)))).size() == 1);
  const auto half_plane = DistanceSurface{[](const Vec<double, 2>& x) { return x[1] - 0.1; }};
  CHECK(on_grid(block, down, rigids(rigid(half_plane, Guided{.mass = 1}, Friction(0)))).size() == 1);

  CHECK(on_grid(block).empty());
  CHECK(on_grid(block, down, walls(bottom(roller))).empty());
  CHECK(on_grid(block, down, walls(left(symmetry({1, 1, 0})))).empty());
  CHECK(on_grid(block, down,
                rigids(rigid(half_plane, Prescribed{[](double) {
                               return std::array{0.0, 0.0, 0.0};
                             }},
                             Friction(0))))
            .empty());
}

TEST_CASE("A rigid body's distance is tried: NaN is refused, another unit and a wrong sign are reported") {
  using P = Vec<double, 2>;
  const auto still = Prescribed{[](double) { return std::array{0.0, 0.0, 0.0}; }};
  const auto block = bodies(fill(Box{{0.2, 0.2}, {0.5, 0.5}}, rubber));
  const auto tool = [&](auto distance) {
    return rigids(rigid(DistanceSurface{std::move(distance)}, still, Friction(0)));
  };
  const auto told = [&](auto distance) { return on_grid(block, gravity({0, -9.81}), tool(distance)); };
  const Ball ball({0.35, 0.7}, 0.2);
  CHECK(told(ball).empty());
  CHECK(told(Box{{0.3, 0.52}, {0.4, 0.54}}).size() == 1);  // thinner than a cell: reported
  CHECK(told([=](const P& x) { return std::max(ball(x), x[0] - 0.4); }).empty());
  for (const double unit : {1000.0, 0.001, 2.0}) {
    const auto texts = told([=](const P& x) { return unit * ball(x); });
    REQUIRE(texts.size() == 1);
    CHECK(has(texts[0], joined_text({"rigid body 0: the gradient of its distance is ", unit})));
  }
  for (const auto& texts :
       {told([=](const P& x) { return -ball(x); }), told([](const P& x) { return 0.1 - x[1]; })}) {
    REQUIRE(texts.size() == 1);
    CHECK(has(texts[0], "rigid body 0: 100 % of the matter lies inside of it"));
  }
  // A cavity that contains the matter is no mistake.
  CHECK(told([](const P& x) { return 0.5 - (x - P(0.35, 0.35)).norm(); }).empty());

  const CartesianGrid<2> fine{{.lower = {0, 0}, .upper = {1, 1}, .cell = 0.01}};
  bool broken = true;
  std::atomic<int> asked = 0;
  const auto make = [&] {
    return Scene{PlaneStrain{},
                 fine,
                 Numerics<QuadraticBSpline, Apic>{},
                 block,
                 gravity({0, -9.81}),
                 tool([&](const P& x) {
                   ++asked;
                   return broken ? std::nan("") : 0.6 - x[1];
                 })};
  };
  CHECK_THROWS_WITH(make(), Catch::Contains("DistanceSurface.distance at (") &&
                                Catch::Contains(" m of the body's frame = nan: must be a number"));
  broken = false;
  asked = 0;
  auto scene = make();
  const int elsewhere = asked - static_cast<int>(scene.point_count());  // each point is asked for
  CHECK(elsewhere < 20000);
  CHECK(elsewhere > 1000);
  step(scene, 1e-5);
  broken = true;
  CHECK_THROWS_WITH(step(scene, 1e-5), Catch::StartsWith("DistanceSurface.distance at ("));
  CHECK_THROWS_WITH(
      on_grid(bodies(fill(Inside{[](const P& x) { return x[0] < 0.3 ? std::nan("") : -1; }}, rubber))),
      Catch::Contains("Inside.distance at (") && Catch::Contains(" m = nan: must be a number"));
}

TEST_CASE("The hook of the warnings: replaced, silenced, thrown from, counted on any thread") {
  std::vector<std::string> texts;
  const WarningHook first = on_warning([&](const std::string& text) { texts.push_back(text); });
  REQUIRE(first);  // writes to standard error
  const std::size_t before = warning_count();
  warn("one");
  CHECK(texts == std::vector<std::string>{"one"});
  const WarningHook second = on_warning({});
  warn("two");
  CHECK(texts.size() == 1);
  second("three");
  CHECK(texts.size() == 2);
  on_warning([](const std::string& text) { throw error(text); });
  CHECK_THROWS_WITH(warn("four"), "four");
  CHECK(warning_count() == before + 3);
  std::atomic<int> heard = 0;
  on_warning([&](const std::string&) { ++heard; });
  std::vector<std::thread> threads;
  for (int t = 0; t < 4; ++t)
    threads.emplace_back([] {
      for (int k = 0; k < 100; ++k) warn("");
    });
  for (auto& t : threads) t.join();
  CHECK(heard == 400);
  CHECK(warning_count() == before + 403);
  on_warning(first);
}
