// Uniform GIMP on a grid: means of hats, at the faces too, and in the kernels.
#include "../transfer/check_grid.hpp"
#include "grids.hpp"

using namespace arenite;
using namespace arenite::test;

TEMPLATE_TEST_CASE("uGIMP: unity, linear fields and gradients", "", double, float) {
  check_completeness<UGimp<>, TestType, false>();
  check_completeness<UGimp<3>, TestType, false>();
}

TEST_CASE("uGIMP: the mean of hats over half a cell; no jumps from cell to cell") {
  CHECK(greatest_jump<UGimp<>>(false) < 1e-14);
  CHECK(greatest_jump<UGimp<>>(true) < 1e-14);
  CHECK(steepest<UGimp<>>() <= UGimp<>::steepness);
  CHECK(steepest<UGimp<>>() >= 0.99 * UGimp<>::steepness);
  CHECK(steepest<UGimp<1>>() <= UGimp<1>::steepness);
  CHECK(steepest<UGimp<4>>() <= UGimp<4>::steepness);
  CHECK(steepest<UGimp<4>>() >= 0.98 * UGimp<4>::steepness);
  // Of one point: the quadratic splines.
  const UGimpOf<1>::Line<double> one(4, 9);
  const QuadraticBSplineLine<double> spline(4, 9);
  for (const double s : {0.1, 0.3, 0.5}) {
    CHECK(std::abs(one.values(s)[0] - spline.values(s + 0.5)[0]) < 1e-15);
    CHECK(std::abs(one.values(s)[1] - spline.values(s + 0.5)[1]) < 1e-15);
  }
  const auto integral = [](double u) {  // of a hat from its middle
    u = std::clamp(u, -1.0, 1.0);
    return u - u * std::abs(u) / 2;
  };
  const UGimpOf<2>::Line<double> inner(4, 9), first(0, 9);
  for (const double s : {0.0, 0.1, 0.25, 0.4, 0.8, 1.0}) {
    const auto w = inner.values(s);
    for (std::size_t i = 0; i < 4; ++i) {
      const double u = s - (static_cast<double>(i) - 1);
      CHECK(std::abs(w[i] - 2 * (integral(u + 0.25) - integral(u - 0.25))) < 1e-15);
    }
  }
  for (const double s : {0.1, 0.2, 0.4, 0.7, 0.9}) {  // quadratic on either side of 1/4 and 3/4
    const double step = 1e-3;
    const auto slope = inner.slopes(s, 3.0), low = inner.values(s - step), high = inner.values(s + step);
    for (std::size_t i = 0; i < 4; ++i)
      CHECK(std::abs(slope[i] - 3 * (high[i] - low[i]) / (2 * step)) < 1e-11);
  }
  CHECK(first.values(0.0) == std::array<double, 4>{0, 1, 0, 0});  // only the node on the face
  CHECK(UGimp<>::face_node(9) == 1);
}

TEST_CASE("uGIMP: kernels keep to the reference, mass and momentum are conserved") {
  check_reference_on_grids<Numerics<UGimp<>, Flip, Musl>>({.transfer = {0.9}});
  check_reference_on_grids<Numerics<UGimp<>, Apic, Usl>>();
  check_conservation(Setup<PlaneStrain, Numerics<UGimp<>, Apic, Usl>, CartesianGrid<2>>(flat_grid()));
}

static_assert(shape_function<UGimp<>, CartesianGrid<2>> && !shape_function<UGimp<>, SimplexMesh<2>>);
