// must print: part: driven_velocity must be Vec<T, D> driven_velocity(const Vec<T, D>& position, double time)
// A velocity along directions that nobody blocks.
#include <arenite/arenite.hpp>

using namespace arenite;

const LinearElastic steel{{.density = 7800, .young = 2e11, .poisson = 0.3}};

struct Piston {
  Vec<double, 2> acceleration(double) const { return {0, 0}; }
  Vec<double, 2> driven_velocity(const Vec<double, 2>&, double) const { return {1, 0}; }
};

int main() {
  Scene scene{PlaneStrain{}, CartesianGrid<2>({.lower = {0, 0}, .upper = {1, 1}, .cell = 0.5}),
              Numerics<QuadraticBSpline>{}, bodies(fill(Box{{0., 0.}, {1., 1.}}, steel)), Piston{}};
}
