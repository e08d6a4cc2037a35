// must print: Scene: Coulomb contact with SurfaceOf is between two bodies
// Which of three bodies the surface parts from which other is not said.
#include <arenite/arenite.hpp>

using namespace arenite;

const LinearElastic steel{{.density = 7800, .young = 2e11, .poisson = 0.3}};

int main() {
  const auto block = fill(Cells("block"), steel);
  Scene scene{PlaneStrain{}, SimplexMesh<2>({}), Numerics<LinearSimplex>{}, bodies(block, block, block),
              Coulomb(Friction(0.1), SurfaceOf{"block"})};
}
