// Packs of any width on grids.
#include "compare.hpp"

using namespace arenite;
using namespace arenite::test;

namespace {

template <class Shape>
struct On {
  template <std::size_t Bytes>
  using Affine = Numerics<Shape, Apic, Usl, NoAntiLocking, Bytes>;
  template <std::size_t Bytes>
  using Mapped = Numerics<Shape, Flip, Musl, NoAntiLocking, Bytes>;
};

}  // namespace

TEMPLATE_TEST_CASE("points on a grid computed one by one or two, four, eight at once agree", "", LinearGrid,
                   QuadraticBSpline, CubicBSpline) {
  check_widths<On<TestType>::template Affine, PlaneStrain>(flat_grid(), 5);
  check_widths<On<TestType>::template Affine, Axisymmetric>(flat_grid(), 5);
  check_widths<On<TestType>::template Mapped, PlaneStrain>(flat_grid(), 40);
}

TEMPLATE_TEST_CASE("and those in space", "", LinearGrid, QuadraticBSpline, CubicBSpline) {
  check_widths<On<TestType>::template Affine, ThreeDimensional>(solid_grid(), 9);
  check_widths<On<TestType>::template Mapped, ThreeDimensional>(solid_grid(), 3);
}
