// A user's program: everything comes from the installed package.
#include <cmath>
#include <cstdio>

#include "other.hpp"

int main() {
  auto scene = falling_block();
  std::size_t shown = 0;
  arenite::run(scene, {.end = 0.1}, [&shown](const auto&) { ++shown; });
  const double here = mean_velocity(scene), there = fall_elsewhere();
  std::printf("after %zu steps: %.12g m/s here, %.12g m/s in the other unit, on %d threads\n", scene.steps,
              here, there, arenite::threads());
  const double exact = -9.81 * 0.1;
  return std::abs(here - exact) < 1e-12 && here == there && shown == scene.steps + 1 &&
                 scene.lost_points() == 0
             ? 0
             : 1;
}
