// Velocities taken in the pass of the strains.
#include "compare.hpp"

using namespace arenite;
using namespace arenite::test;

namespace {

template <class S>
void check_one_pass(S s) {
  s = advanced(s);
  S apart = s;
  apart.gather();
  const DeformSums sums = apart.deform(0.01);
  const DeformSums at_once = s.template deform<true>(0.01);
  REQUIRE(difference(apart.body.points, s.body.points) <= 1e-14);
  REQUIRE(std::abs(sums.work - at_once.work) <= 1e-14 * std::abs(sums.work));
  REQUIRE(std::abs(sums.work) > 1e-6);
}

}  // namespace

TEST_CASE("velocities taken with the strains are those of a pass of their own") {
  using FlipSimplex = Numerics<LinearSimplex, Flip, Usl>;
  using TpicSimplex = Numerics<LinearSimplex, Tpic, Usl>;
  using FlipSpline = Numerics<QuadraticBSpline, Flip, Usl>;
  using ApicSpline = Numerics<QuadraticBSpline, Apic, Usl>;
  check_one_pass(Setup<PlaneStrain, FlipSimplex, SimplexMesh<2>>(sample_mesh<2>(4)));
  check_one_pass(Setup<Axisymmetric, TpicSimplex, SimplexMesh<2>>(sample_mesh<2>(4)));
  check_one_pass(Setup<Solid, TpicSimplex, SimplexMesh<3>>(sample_mesh<3>(3), 11));
  check_one_pass(Setup<PlaneStrain, FlipSpline, CartesianGrid<2>>(flat_grid(), 5));
  check_one_pass(Setup<Axisymmetric, ApicSpline, CartesianGrid<2>>(flat_grid()));
  check_one_pass(Setup<Solid, ApicSpline, CartesianGrid<3>>(solid_grid(), 9));
}
