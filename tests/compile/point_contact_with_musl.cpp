// must print: Rigid: PointContact needs Usl: it does not hold the velocities that MUSL maps back
#include <arenite/arenite.hpp>

using namespace arenite;

const LinearElastic steel{{.density = 7800, .young = 2e11, .poisson = 0.3}};

int main() {
  const ConeCylinder cone({.radius = 0.1, .apex = 1, .length = 1});
  Scene scene{PlaneStrain{}, CartesianGrid<2>({.lower = {0, 0}, .upper = {1, 1}, .cell = 0.5}),
              Numerics<QuadraticBSpline>{}, bodies(fill(Box{{0., 0.}, {1., 1.}}, steel)),
              rigids(rigid(DistanceSurface{cone}, Guided{.mass = 1}, Friction(0.1), PointContact{}))};
}
