// Conservation of mass and momentum on B-splines.
#include "check_conservation.hpp"

using namespace arenite;
using namespace arenite::test;

TEST_CASE("B-splines conserve mass and momentum: PIC, FLIP and blends") {
  for (const double share : {0.0, 0.3, 1.0}) {
    Setup<PlaneStrain, Numerics<QuadraticBSpline, Flip, Musl>, CartesianGrid<2, float>> flat(
        flat_grid<float>());
    flat.numerics.transfer.fraction = share;
    check_conservation(flat);
    Setup<Axisymmetric, Numerics<QuadraticBSpline, Flip, Usl>, CartesianGrid<2>> round(flat_grid());
    round.numerics.transfer.fraction = share;
    check_conservation(round);
  }
}

TEST_CASE("B-splines conserve mass and momentum: APIC") {
  check_conservation(
      Setup<PlaneStrain, Numerics<QuadraticBSpline, Apic, Usl>, CartesianGrid<2>>(flat_grid()));
  check_conservation(
      Setup<Axisymmetric, Numerics<QuadraticBSpline, Apic, Musl>, CartesianGrid<2>>(flat_grid()));
  check_conservation(
      Setup<ThreeDimensional, Numerics<QuadraticBSpline, Apic, Musl>, CartesianGrid<3>>(solid_grid()));
}
