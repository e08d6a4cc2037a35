// must print: visit_state: call f(name, value) with a number, or with numbers side by side
#include <arenite/arenite.hpp>
#include <arenite/scene/state.hpp>
#include <map>

using namespace arenite;

const LinearElastic steel{{.density = 7800, .young = 2e11, .poisson = 0.3}};

struct Counter {
  std::map<int, double> counts{};
  template <class Scene>
  void follow_motion(Scene&, double) {}
  template <class F>
  void visit_state(F&& f) {
    f("counts", counts);
  }
};

int main() {
  Scene scene{PlaneStrain{}, CartesianGrid<2>({.lower = {0, 0}, .upper = {1, 1}, .cell = 0.5}),
              Numerics<QuadraticBSpline>{}, bodies(fill(Box{{0., 0.}, {1., 1.}}, steel)), Counter{}};
  for_each_state(scene, [](auto, auto&) {});
}
