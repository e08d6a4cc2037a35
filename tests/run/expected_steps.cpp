// Expected steps: those that a run takes whose stable step stays what it is.
#include <limits>

#include <arenite/matter.hpp>
#include "catch.hpp"

using namespace arenite;

namespace {
auto still() {  // a block without a load: nothing changes its stable step
  const LinearElastic steel{{.density = 7800, .young = 2e11, .poisson = 0.3}};
  return Scene{PlaneStrain{}, CartesianGrid<2>({.lower = {0, 0}, .upper = {1, 1}, .cell = 0.25}),
               Numerics<QuadraticBSpline>{}, bodies(fill(Box{{0., 0.}, {1., 0.5}}, steel)),
               walls(bottom(fixed))};
}
}  // namespace

TEST_CASE("Expected steps: those that the run takes") {
  const auto options =
      GENERATE(RunOptions{.end = 1e-3}, RunOptions{.end = 1e-3, .courant = 0.9},
               RunOptions{.end = 1e-3, .max_step = 1e-5}, RunOptions{.end = 1e-9}, RunOptions{.end = 0});
  auto scene = still();
  const ExpectedSteps expected = expected_steps(scene, options);
  run(scene, options);
  CHECK(expected.count == static_cast<double>(scene.steps));
  if (scene.steps > 2)
    CHECK(expected.length * expected.count == Approx(options.end).epsilon(1 / expected.count));
  CHECK(expected_steps(scene, options).count == 0);  // it is there
}

TEST_CASE("Expected steps: of options that no run takes there are none") {
  const auto scene = still();
  REQUIRE_THROWS_AS(expected_steps(scene, {}), error);
  REQUIRE_THROWS_AS(expected_steps(scene, {.end = std::numeric_limits<double>::infinity()}), error);
  REQUIRE_THROWS_AS(expected_steps(scene, {.end = 1, .courant = 2}), error);
}
