// must compile
// No concept takes the word for a mesh, a region, kinematics or a real number out of a user's namespace.
#include <arenite/arenite.hpp>

using namespace arenite;

using real = double;
namespace mesh {
inline int count = 1;
}
auto region = Box{{0., 0.}, {1., 1.}};
int kinematics() { return 2; }

const LinearElastic steel{{.density = 7800, .young = 2e11, .poisson = 0.3}};

int grid() {
  auto mesh = CartesianGrid<2>({.lower = {0, 0}, .upper = {1, 1}, .cell = 0.5});
  Scene scene{PlaneStrain{}, mesh, Numerics<QuadraticBSpline>{}, bodies(fill(region, steel))};
  return static_cast<int>(real(scene.mesh.cell_count()));
}

int main() { return mesh::count + kinematics() + grid(); }
