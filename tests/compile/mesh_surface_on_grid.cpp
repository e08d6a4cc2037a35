// must print: Rigid: a MeshSurface needs a simplex mesh; on a grid use a DistanceSurface
// A grid has no regions.
#include <arenite/arenite.hpp>

using namespace arenite;

const LinearElastic steel{{.density = 7800, .young = 2e11, .poisson = 0.3}};

int main() {
  Scene scene{PlaneStrain{}, CartesianGrid<2>({.lower = {0, 0}, .upper = {1, 1}, .cell = 0.5}),
              Numerics<QuadraticBSpline>{}, bodies(fill(Box{{0., 0.}, {1., 1.}}, steel)),
              rigids(rigid(MeshSurface{"device"}, Guided{.mass = 1}, Friction(0.1)))};
}
