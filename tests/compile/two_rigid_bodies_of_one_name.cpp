// must print: Scene: two rigid bodies have one name
// The second of them could not be reached by its name.
#include <arenite/arenite.hpp>

using namespace arenite;

const LinearElastic rubber{{.density = 1, .young = 1, .poisson = 0}};

int main() {
  const auto floor = [](const Vec<double, 2>& x) { return x[1]; };
  Scene scene{PlaneStrain{}, CartesianGrid<2>({.lower = {0, 0}, .upper = {1, 1}, .cell = 0.5}),
              Numerics<QuadraticBSpline>{}, bodies(fill(Box{{0., 0.}, {1., 0.5}}, rubber)),
              rigids(rigid<"tool">(DistanceSurface{floor}, Guided{.mass = 1}, Friction(0)),
                     rigid<"tool">(DistanceSurface{floor}, Guided{.mass = 1}, Friction(0)))};
}
