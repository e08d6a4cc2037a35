// must print: Scene: the third value must be the numerics
// errors: 1
// Kinematics and mesh are no scene.
#include <arenite/arenite.hpp>

using namespace arenite;

int main() {
  Scene scene{PlaneStrain{}, CartesianGrid<2>({.lower = {0, 0}, .upper = {1, 1}, .cell = 0.5})};
  run(scene, {.end = 1});
}
