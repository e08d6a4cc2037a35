// Kernels with the gradients of moving least squares against the reference, and what they conserve. All else is as with the splines of
// the same weights.
#include "check_grid.hpp"

using namespace arenite;
using namespace arenite::test;

TEST_CASE("MLS gradients: P2G, MUSL mapping and G2P are the formulas of one point") {
  using Quadratic = MlsGradient<QuadraticBSpline>;
  check_reference_on_grids<Numerics<Quadratic, Flip, Musl, NoAntiLocking, 32>>({.transfer = {0.9}});
  check_reference_on_grids<Numerics<Quadratic, Apic, Usl, NoAntiLocking, 64>>();
  check_reference_on_grids<Numerics<MlsGradient<CubicBSpline>, Apic, Musl, NoAntiLocking, 16>>();
}

TEST_CASE("MLS gradients conserve mass and momentum") {
  check_all_conservation<MlsGradient<QuadraticBSpline>>();
}
