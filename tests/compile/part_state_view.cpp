// must print: visit_state: an array whose count changes must own its numbers
#include <arenite/arenite.hpp>
#include <arenite/scene/state.hpp>
#include <cstddef>
#include <vector>

using namespace arenite;

const LinearElastic steel{{.density = 7800, .young = 2e11, .poisson = 0.3}};

struct Counts {  // of what a counter keeps
  std::vector<int>& all;
  int* data() { return all.data(); }
  std::size_t size() const { return all.size(); }
  void resize(std::size_t n) { all.resize(n); }
};

struct Counter {
  std::vector<int> all{};
  template <class Scene>
  void follow_motion(Scene&, double) {}
  template <class F>
  void visit_state(F&& f) {
    Counts counts{all};
    f("counts", counts);
  }
};

int main() {
  Scene scene{PlaneStrain{}, CartesianGrid<2>({.lower = {0, 0}, .upper = {1, 1}, .cell = 0.5}),
              Numerics<QuadraticBSpline>{}, bodies(fill(Box{{0., 0.}, {1., 1.}}, steel)), Counter{}};
  state_slots(scene);
}
