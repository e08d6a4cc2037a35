// must print: part: exchange_impulses is now called apply_impulses
// compile with: -DNDEBUG
// Under its old name alone, the role would be left out in silence.
#include <arenite/arenite.hpp>

using namespace arenite;

const LinearElastic steel{{.density = 7800, .young = 2e11, .poisson = 0.3}};

struct Wind {
  double pressure;
  template <class Scene>
  void add_force(Scene& scene, double) {
    scene.fields[0].sums[0].add_force({pressure, 0});
  }
  template <class Scene>
  ContactTally exchange_impulses(Scene&, double) {
    return {};
  }
};

int main() {
  Scene scene{PlaneStrain{}, CartesianGrid<2>({.lower = {0, 0}, .upper = {1, 1}, .cell = 0.5}),
              Numerics<QuadraticBSpline>{}, bodies(fill(Box{{0., 0.}, {1., 1.}}, steel)), Wind{10}};
}
