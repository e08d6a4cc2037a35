// must print: visit_state: call f(name, value) with a member: a number that is computed there cannot be restored
#include <arenite/arenite.hpp>
#include <arenite/scene/state.hpp>

using namespace arenite;

const LinearElastic steel{{.density = 7800, .young = 2e11, .poisson = 0.3}};

struct Clock {
  double seconds = 0;
  template <class Scene>
  void follow_motion(Scene&, double dt) {
    seconds += dt;
  }
  template <class F>
  void visit_state(F&& f) {
    f("minutes", seconds / 60);
  }
};

int main() {
  Scene scene{PlaneStrain{}, CartesianGrid<2>({.lower = {0, 0}, .upper = {1, 1}, .cell = 0.5}),
              Numerics<QuadraticBSpline>{}, bodies(fill(Box{{0., 0.}, {1., 1.}}, steel)), Clock{}};
  state_slots(scene);
}
