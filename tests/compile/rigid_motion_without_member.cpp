// must print: Rigid: the motion lacks a member; see arenite/rigid/motion/motion.hpp
// A motion of a user's own that says nothing but where it begins.
#include <arenite/arenite.hpp>

using namespace arenite;

const LinearElastic steel{{.density = 7800, .young = 2e11, .poisson = 0.3}};

struct Falling {
  Vec<double, 2> start() const { return {0, -1}; }
};

int main() {
  const ConeCylinder cone({.radius = 0.1, .apex = 1, .length = 1});
  Scene scene{PlaneStrain{}, CartesianGrid<2>({.lower = {0, 0}, .upper = {1, 1}, .cell = 0.5}),
              Numerics<QuadraticBSpline>{}, bodies(fill(Box{{0., 0.}, {1., 1.}}, steel)),
              rigid(DistanceSurface{cone}, Falling{}, Friction(0.1))};
}
