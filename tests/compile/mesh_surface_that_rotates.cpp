// must print: Rigid: the body rotates, and its surface does not: visit must take a Pose
// The nodes of a mesh's region as the surface of a body that turns.
#include <arenite/arenite.hpp>
#include <arenite/mesh/box_mesh.hpp>

using namespace arenite;

const LinearElastic steel{{.density = 7800, .young = 2e11, .poisson = 0.3}};

int main() {
  Scene scene{
      PlaneStrain{}, SimplexMesh<2>(box_mesh<2>({{0, 0}, {1, 1}, {2, 2}})), Numerics<LinearSimplex>{},
      bodies(fill(Box{{0., 0.}, {1., 1.}}, steel)),
      rigid(MeshSurface{"device"}, Free{.mass = 1, .inertia = 1, .centre = {0, 0, 0}}, Friction(0.1))};
}
