// must print: part: one that adds forces must not say reads_start_state = false
// Its forces would have no place to go.
#include <arenite/arenite.hpp>

using namespace arenite;

const LinearElastic steel{{.density = 7800, .young = 2e11, .poisson = 0.3}};

struct Wind {
  static constexpr bool reads_start_state = false;
  double pressure;
  template <class Scene>
  void add_force(Scene& scene, double) {
    scene.fields[0].sums[0].add_force({pressure, 0});
  }
};

int main() {
  Scene scene{PlaneStrain{}, CartesianGrid<2>({.lower = {0, 0}, .upper = {1, 1}, .cell = 0.5}),
              Numerics<QuadraticBSpline, Apic, Usl>{}, bodies(fill(Box{{0., 0.}, {1., 1.}}, steel)),
              Wind{.pressure = 10}};
}
