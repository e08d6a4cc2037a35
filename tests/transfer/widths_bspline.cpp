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

// Each width with each shape function, each transfer and each kinematics, but not all of them with each
// other: which formulas belong to which composition is checked in reference_*.cpp, in packs as well.
TEST_CASE("points on a grid computed one by one or two, four, eight at once agree: linear functions") {
  check_widths<On<LinearGrid>::Affine, PlaneStrain>(flat_grid(), 5);
  check_widths<On<LinearGrid>::Mapped, ThreeDimensional>(solid_grid(), 3);
}

TEST_CASE("quadratic B-splines") {
  check_widths<On<QuadraticBSpline>::Affine, ThreeDimensional>(solid_grid(), 9);
  check_widths<On<QuadraticBSpline>::Mapped, Axisymmetric>(flat_grid(), 40);
}

TEST_CASE("cubic B-splines") {
  check_widths<On<CubicBSpline>::Affine, Axisymmetric>(flat_grid(), 5);
  check_widths<On<CubicBSpline>::Mapped, PlaneStrain>(flat_grid(), 40);
}
