// must print: MovingMesh: a simplex mesh or a RectilinearGrid moves, a CartesianGrid rests
// A grid stays where it is.
#include <arenite/arenite.hpp>

using namespace arenite;

const LinearElastic steel{{.density = 7800, .young = 2e11, .poisson = 0.3}};

int main() {
  Scene scene{PlaneStrain{}, CartesianGrid<2>({.lower = {0, 0}, .upper = {1, 1}, .cell = 0.5}),
              Numerics<QuadraticBSpline>{}, bodies(fill(Box{{0., 0.}, {1., 1.}}, steel)),
              MovingMesh<LedByBody<0>>{.fixed_below = 0, .moving_from = 0.5}};
}
