// Warnings of a scene in tiles: those of the whole, each once, with its numbers.
#include <arenite/arenite.hpp>
#include <arenite/tiles.hpp>

#include <algorithm>
#include <string>
#include <vector>

#include "catch.hpp"

using namespace arenite;

namespace {

/// What is warned of while it lives.
class Told {
 public:
  Told() : before_{on_warning([this](const std::string& text) { texts.push_back(text); })} {}
  Told(const Told&) = delete;
  Told& operator=(const Told&) = delete;
  ~Told() { on_warning(before_); }
  std::vector<std::string> texts{};

 private:
  WarningHook before_;
};

const CartesianGrid<2> grid({.lower = {0, 0}, .upper = {1, 0.5}, .cell = 0.05});

struct Case {
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
                        fill<"high">(Box{{0.5, 0.3}, {0.8, 0.4}}, rubber, {.per_cell = 4, .velocity = of.velocity})),
                 LocalDamping(0.7),
                 gravity({0, of.gravity}),
                 portion...};
  };
}

/// What an ordinary scene and four tiles warn of while `f(scene)` runs, the refusal that ends it, too.
template <class F>
std::vector<std::string> told_of_all(const Case& of, F&& f) {
  const auto told = [&](auto&& make) {
    Told all;
    auto scene = make();
    try {
      f(scene);
    } catch (const error& e) {
      all.texts.emplace_back(e.what());
    }
    return all.texts;
  };
  OneRank here;
  const auto whole = told([&] { return maker(of)(grid); });
  const auto tiles = told([&] { return distribute(here, grid, {.tiles = 4}, maker(of)); });
  CHECK(tiles == whole);
  return whole;
}

bool any_has(const std::vector<std::string>& texts, const std::string& word) {
  return std::ranges::any_of(texts, [&](const auto& text) { return text.find(word) != std::string::npos; });
}

/// A step of a scene, or of all of its tiles.
template <class S>
void take_step(S& scene, double dt) {
  if constexpr (requires { scene.tiles(); })
    scene.together([dt](auto& tile) { step(tile, dt); });
  else
    step(scene, dt);
}

}  // namespace

TEST_CASE("A body that leaves the mesh, and then the last one") {
  const auto told = told_of_all({.velocity = {5, 0, 0}}, [](auto& scene) {
    run(scene, {.end = 0.2, .max_step = 1e-3}, Watch({.lost = 2, .every = 5}));
  });
  CHECK(any_has(told, "lost = "));
  CHECK(any_has(told, "all points of body high have left the mesh"));
  const auto all = told_of_all({.velocity = {0, 3, 0}, .gravity = -100},
                               [](auto& scene) { run(scene, {.end = 1, .max_step = 1e-3}); });
  CHECK(any_has(all, "points of the scene have left the mesh"));
}

TEST_CASE("What a watch sees in tiles is of the whole") {
  for (const double limit : {1., 0.1}) {
    const auto told = told_of_all({.velocity = {20, 3, 0}}, [&](auto& scene) {
      run(scene, {.end = 0.02, .max_step = 1e-3},
          Watch({.volume = limit / 100, .speed = limit, .strength = 1e-3, .lost = limit, .every = 3}));
    });
    CHECK(any_has(told, "speed = "));
  }
  const auto stretched = told_of_all({.velocity = {0, 1, 0}, .gravity = -9.81}, [](auto& scene) {
    run(scene, {.end = 0.15, .max_step = 1e-3}, Watch({.every = 10}));
  });
  CHECK(any_has(stretched, "local damping took"));
}

TEST_CASE("A step above the stable one of all tiles") {
  const auto told = told_of_all({.velocity = {1, 0, 0}}, [](auto& scene) {
    take_step(scene, 1e-4);
    take_step(scene, 8e-3);
    take_step(scene, 8e-3);
  });
  CHECK(std::ranges::count_if(told, [](const auto& text) {
          return text.find("times the stable step") != std::string::npos;
        }) == 1);
}
