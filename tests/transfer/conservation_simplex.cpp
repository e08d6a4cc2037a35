// Conservation of mass and momentum on simplices.
#include "check_conservation.hpp"

using namespace arenite;
using namespace arenite::test;

TEST_CASE("simplices conserve mass and momentum: PIC, FLIP and blends") {
  for (const double share : {0.0, 0.3, 1.0}) {
    Setup<PlaneStrain, Numerics<LinearSimplex, Flip, Usl>, SimplexMesh<2>> flat(sample_mesh<2>(4));
    flat.numerics.transfer.fraction = share;
    check_conservation(flat);
    Setup<Axisymmetric, Numerics<LinearSimplex, Flip, Musl>, SimplexMesh<2>> round(sample_mesh<2>(4));
    round.numerics.transfer.fraction = share;
    check_conservation(round);
    Setup<ThreeDimensional, Numerics<LinearSimplex, Flip, Musl>, SimplexMesh<3, float>> solid(
        sample_mesh<3, float>(2));
    solid.numerics.transfer.fraction = share;
    check_conservation(solid);
  }
}

TEST_CASE("simplices conserve mass and momentum: TPIC") {
  check_conservation(Setup<PlaneStrain, Numerics<LinearSimplex, Tpic, Musl>, SimplexMesh<2, float>>(
      sample_mesh<2, float>(4)));
  check_conservation(
      Setup<Axisymmetric, Numerics<LinearSimplex, Tpic, Usl>, SimplexMesh<2>>(sample_mesh<2>(4)));
  check_conservation(
      Setup<ThreeDimensional, Numerics<LinearSimplex, Tpic, Musl>, SimplexMesh<3>>(sample_mesh<3>(2)));
}
