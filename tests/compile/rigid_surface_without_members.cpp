// must print: Rigid: the surface lacks a member; see arenite/rigid/body/surface.hpp
// errors: 1
// A surface of a user's own that is none.
#include <arenite/arenite.hpp>

using namespace arenite;

const LinearElastic steel{{.density = 7800, .young = 2e11, .poisson = 0.3}};

struct Plane {
  double height;
};

int main() {
  Scene scene{PlaneStrain{}, CartesianGrid<2>({.lower = {0, 0}, .upper = {1, 1}, .cell = 0.5}),
              Numerics<QuadraticBSpline>{}, bodies(fill(Box{{0., 0.}, {1., 1.}}, steel)),
              rigid(Plane{0.5}, Guided{.mass = 1}, Friction(0.1))};
  run(scene, {.end = 1});
}
