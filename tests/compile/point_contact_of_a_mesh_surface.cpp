// must print: Rigid: PointContact needs a DistanceSurface, which tells the distance of a point
#include <arenite/arenite.hpp>
#include <arenite/mesh/box_mesh.hpp>

using namespace arenite;

const LinearElastic steel{{.density = 7800, .young = 2e11, .poisson = 0.3}};

int main() {
  Scene scene{PlaneStrain{}, SimplexMesh<2>(box_mesh<2>({{0, 0}, {1, 1}, {2, 2}})),
              Numerics<LinearSimplex, Flip, Usl>{}, bodies(fill(Box{{0., 0.}, {1., 1.}}, steel)),
              rigid(MeshSurface{"device"}, Guided{.mass = 1}, Friction(0.1), PointContact{})};
}
