// Packs of any width on B-splines.
#include "compare.hpp"

using namespace arenite;
using namespace arenite::test;

namespace {

template <std::size_t Bytes>
using Spline = Numerics<QuadraticBSpline, Apic, Usl, NoAntiLocking, Bytes>;
template <std::size_t Bytes>
using MappedSpline = Numerics<QuadraticBSpline, Flip, Musl, NoAntiLocking, Bytes>;

}  // namespace

TEST_CASE("points on B-splines computed one by one or two, four, eight at once agree") {
  check_widths<Spline, PlaneStrain>(flat_grid(), 5);
  check_widths<Spline, Axisymmetric>(flat_grid(), 5);
  check_widths<MappedSpline, PlaneStrain>(flat_grid(), 40);
}

TEST_CASE("and those of B-splines in space") {
  check_widths<Spline, ThreeDimensional>(solid_grid(), 9);
  check_widths<MappedSpline, ThreeDimensional>(solid_grid(), 3);
}
