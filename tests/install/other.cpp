// The second translation unit: includes what the first includes, and runs its own scene.
#include "other.hpp"

double fall_elsewhere() {
  auto scene = falling_block();
  arenite::run(scene, {.end = 0.1});
  return mean_velocity(scene);
}
