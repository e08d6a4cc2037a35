// must print: part: add_force must be void add_force(Scene& scene, double dt)
// compile with: -DNDEBUG
// Searched only by signature, this part would be left out silently; the message is the first error.
#include <arenite/arenite.hpp>

using namespace arenite;

const LinearElastic steel{{.density = 7800, .young = 2e11, .poisson = 0.3}};

struct Wind {
  double pressure;
  template <class Scene>
  void add_force(Scene& scene) {
    scene.fields[0].sums[0].add_force({pressure, 0});
  }
};

int main() {
  Scene scene{PlaneStrain{}, CartesianGrid<2>({.lower = {0, 0}, .upper = {1, 1}, .cell = 0.5}),
              Numerics<QuadraticBSpline>{}, bodies(fill(Box{{0., 0.}, {1., 1.}}, steel)), Wind{10}};
}
