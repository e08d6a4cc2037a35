// must print: Scene: the shape function does not fit the mesh
// Linear simplices on a grid.
#include <arenite/arenite.hpp>

using namespace arenite;

const LinearElastic steel{{.density = 7800, .young = 2e11, .poisson = 0.3}};

int main() {
  Scene scene{PlaneStrain{}, CartesianGrid<2>({.lower = {0, 0}, .upper = {1, 1}, .cell = 0.5}),
              Numerics<LinearSimplex>{}, bodies(fill(Box{{0., 0.}, {1., 1.}}, steel))};
}
