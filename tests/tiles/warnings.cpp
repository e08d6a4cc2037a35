// Warnings of a scene in tiles: those of the whole, each once, with its numbers.
#include <arenite/arenite.hpp>
#include <arenite/tiles.hpp>

#include <algorithm>
#include <string>
#include <vector>

#include "catch.hpp"
#include "warnings.hpp"

using namespace arenite;

namespace {

const CartesianGrid<2> grid({.lower = {0, 0}, .upper = {1, 0.5}, .cell = 0.05});

struct Case {
  Box<2> high{{0.5, 0.3}, {0.8, 0.4}};
  std::array<double, 3> velocity{};
  double gravity = 0;
};

auto maker(const Case& of) {
  return [=](auto mesh, auto... portion) {
    const LinearElastic rubber{{.density = 1000, .young = 1e5, .poisson = 0.3}};
    return Scene{PlaneStrain{},
                 mesh,
                 Numerics<LinearGrid, Flip, Usl>{},
                 bodies(fill<"low">(Box{{0., 0.}, {0.3, 0.2}}, rubber, {.per_cell = 4}),
                        fill<"high">(of.high, rubber, {.per_cell = 4, .velocity = of.velocity})),
                 LocalDamping{.factor = 0.7},
                 gravity({0, of.gravity}),
                 portion...};
  };
}

/// Ground up to 0.3 m with the stress of one up to `surface`, and a rigid body.
template <class Shape>
auto ground(double surface, const Shape& shape) {
  return [=](auto mesh, auto... portion) {
    const LinearElastic soil{{.density = 1600, .young = 1e6, .poisson = 0.3}};
    const Prescribed still{[](double) { return std::array{0., 0., 0.}; }};
    return Scene{PlaneStrain{},
                 mesh,
                 Numerics<QuadraticBSpline, Flip>{},
                 bodies(fill<"soil">(Box{{0., 0.}, {1., 0.3}}, soil,
                                     {.per_cell = 4, .stress = Geostatic{.surface = surface, .k0 = 0.5}})),
                 walls(left(roller), right(roller), bottom(fixed)),
                 gravity({0, -9.81}),
                 rigids(rigid<"tool">(DistanceSurface{shape}, still, Friction(0))),
                 portion...};
  };
}

/// Warnings of a scene while `f(scene)` runs, and the refusal that ends it; checks that tiles give the same.
template <class Make, class F>
std::vector<std::string> told_of_all(const Make& make, F&& f) {
  const auto told = [&](auto&& scene_of) {
    std::string refused;
    auto texts = test::warnings_of([&] {
      auto scene = scene_of();
      try {
        f(scene);
      } catch (const error& e) {
        refused = e.what();
      }
    });
    texts.push_back(refused);
    return texts;
  };
  OneRank here;
  const auto whole = told([&] { return make(grid); });
  for (const int tiles : {1, 4, 7}) {
    CAPTURE(tiles);
    CHECK(told([&] { return distribute(here, grid, {.tiles = tiles}, make); }) == whole);
  }
  return whole;
}
template <class F>
std::vector<std::string> told_of_all(const Case& of, F&& f) {
  return told_of_all(maker(of), f);
}

bool any_has(const std::vector<std::string>& texts, const std::string& word) {
  return std::ranges::any_of(texts, [&](const auto& text) { return text.find(word) != std::string::npos; });
}

/// Calls `f` of a scene, or of all of its tiles.
template <class S, class F>
void with_all(S& scene, F&& f) {
  if constexpr (requires { scene.tiles(); })
    scene.together(f);
  else
    f(scene);
}
template <class S>
void take_step(S& scene, double dt) {
  with_all(scene, [dt](auto& tile) { step(tile, dt); });
}

}  // namespace

TEST_CASE("A body that leaves the mesh, and then the last one") {
  const auto told = told_of_all(Case{.velocity = {5, 0, 0}}, [](auto& scene) {
    run(scene, {.end = 0.2, .max_step = 1e-3}, Watch({.lost = 2, .every = 5}));
  });
  CHECK(any_has(told, "lost = "));
  CHECK(any_has(told, "all points of body high have left the mesh"));
  const auto all = told_of_all(Case{.velocity = {0, 3, 0}, .gravity = -100},
                               [](auto& scene) { run(scene, {.end = 1, .max_step = 1e-3}); });
  CHECK(any_has(all, "local damping took"));
  CHECK(any_has(all, "points of the scene have left the mesh"));
}

TEST_CASE("A watch sees the whole of all tiles") {
  for (const double limit : {10., 1.}) {
    const auto told = told_of_all(Case{.velocity = {20, 3, 0}}, [&](auto& scene) {
      run(scene, {.end = 0.02, .max_step = 1e-3},
          Watch({.volume = limit / 100, .speed = limit, .strength = 1e-3, .lost = limit, .every = 3}));
    });
    CHECK(any_has(told, "speed = "));
  }
}

TEST_CASE("A new scene in tiles is reported as a whole") {
  const auto told = told_of_all(Case{.high = {{0.21, 0.1}, {1.3, 0.42}}, .gravity = -1}, [](auto&) {});
  for (const auto* word : {"of its region lies outside of the mesh",
                           "body low and body high lie in one place", "its points have", "everything falls"})
    CHECK(any_has(told, word));
  CHECK(
      any_has(told_of_all(Case{.high = {{0.5, 0.3}, {0.53, 0.32}}}, [](auto&) {}), "body high has 1 point"));
  const auto filled = told_of_all(Case{}, [](auto& scene) {
    with_all(scene, [](auto& tile) { insert_points<"low">(tile, Box{{0.3, 0.}, {0.72, 0.06}}); });
  });
  CHECK(any_has(filled, "body low: its points have"));
}

TEST_CASE("Rigid bodies of a new scene in tiles are reported as of a whole") {
  const auto told = [](const auto& shape) { return told_of_all(ground(0.3, shape), [](auto&) {}); };
  CHECK(any_has(told(Box<2>{{0.2, 0.1}, {0.7, 0.4}}), " of the 480 points of body soil lie inside of it"));
  CHECK(any_has(told(Box<2>{{0.2, 0.32}, {0.8, 0.33}}), "a wall is"));
  CHECK(any_has(told([](const Vec<double, 2>& x) { return x[1] - 0.5; }), "of the matter lies inside"));
  CHECK(any_has(told([](const Vec<double, 2>& x) { return 1000 * (0.05 - x[1]); }), "the gradient of its"));
}

TEST_CASE("Ground in tiles is at rest, or is reported not to be, as in one") {
  const auto told = [](double surface, double bottom) {
    return told_of_all(ground(surface, Box<2>{{0.4, bottom}, {0.6, 0.49}}),
                       [](auto& scene) { take_step(scene, 1e-5); });
  };
  CHECK(told(0.3, 0.4) == std::vector<std::string>{""});
  CHECK(told(0.3, 0.3) == std::vector<std::string>{""});
  CHECK(any_has(told(0.35, 0.4), "the ground is not at rest"));
  CHECK(any_has(told(0.2, 0.3), "the ground is not at rest"));
}

TEST_CASE("A step above the stable one of all tiles") {
  const auto told = told_of_all(Case{.velocity = {1, 0, 0}}, [](auto& scene) {
    take_step(scene, 1e-4);
    take_step(scene, 8e-3);
    take_step(scene, 8e-3);
  });
  CHECK(std::ranges::count_if(told, [](const auto& text) {
          return text.find("times the stable step") != std::string::npos;
        }) == 1);
}
