// must compile
// The control of the refused scenes: what they have in common is right.
#include <arenite/arenite.hpp>

using namespace arenite;

const LinearElastic steel{{.density = 7800, .young = 2e11, .poisson = 0.3}};

int main() {
  Scene grid{PlaneStrain{},
             CartesianGrid<2>({.lower = {0, 0}, .upper = {1, 1}, .cell = 0.5}),
             Numerics<QuadraticBSpline>{},
             bodies(fill(Box{{0., 0.}, {1., 1.}}, steel)),
             walls(left(fixed), right(fixed)),
             gravity({0, -9.81}),
             rigids(rigid(DistanceSurface{ConeCylinder({.radius = 0.1, .apex = 1, .length = 1})},
                          Guided{.mass = 1}, Friction(0.1)))};
  const auto block = fill(Cells("block"), steel);
  Scene mesh{PlaneStrain{},
             SimplexMesh<2>({}),
             Numerics<LinearSimplex, Tpic, Musl, NodalAveraging>{},
             bodies(block, block),
             Coulomb(Friction(0.1), SurfaceOf{"block"}),
             rigids(rigid(MeshSurface{"device"}, Guided{.mass = 1}, Friction(0.1), CentreOfMass{})),
             MovingMesh<>{.fixed_below = 0, .moving_from = 0.5}};
  // The type of a scene can be written down: it names neither regions nor distances nor functions.
  static_assert(std::same_as<decltype(grid), Scene<PlaneStrain, CartesianGrid<2>, Numerics<QuadraticBSpline>,
                                                   Bodies<Fill<LinearElastic>>, Walls, Gravity,
                                                   PartGroup<Rigid<DistanceSurface<>, Guided>>>>);
  const auto push = [](double t) { return std::array{0.0, -t, 0.0}; };
  Scene<PlaneStrain, CartesianGrid<2>, Numerics<QuadraticBSpline>, Bodies<Fill<LinearElastic, "low">>,
        Rigid<DistanceSurface<>, Prescribed, NodalGap, "ram">>
      named{PlaneStrain{}, CartesianGrid<2>({.lower = {0, 0}, .upper = {1, 1}, .cell = 0.5}),
            Numerics<QuadraticBSpline>{},
            bodies(fill<"low">(Inside{[](const auto& x) { return x[1] - 0.5; }}, steel)),
            rigid<"ram">(DistanceSurface{[](const auto& x) { return 0.5 - x[1]; }}, Prescribed{push},
                         Friction(0.1))};
  auto copy = named;
  copy = named;
  step(named, 1e-6);
  step(grid, 1e-6);
  step(mesh, 1e-6);
}
