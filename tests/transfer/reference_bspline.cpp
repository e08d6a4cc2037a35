// Kernels of products along the axes against the reference.
#include "check_reference.hpp"

using namespace arenite;
using namespace arenite::test;

namespace {

template <class Transfer, class Order, std::size_t Bytes = 64>
using BSpline = Numerics<QuadraticBSpline, Transfer, Order, NoAntiLocking, Bytes>;

template <class N>
void check_all(N numerics = {}) {
  const auto check = [&](auto s) {
    s.numerics = numerics;
    check_reference(std::move(s), 1e-12);
  };
  check(Setup<PlaneStrain, N, CartesianGrid<2>>(flat_grid(), 11));
  check(Setup<Axisymmetric, N, CartesianGrid<2>>(flat_grid(), 5));
  check(Setup<ThreeDimensional, N, CartesianGrid<3>>(solid_grid(), 11));
}

}  // namespace

TEST_CASE("B-splines: P2G, MUSL mapping and G2P are the formulas of one point") {
  check_all<BSpline<Flip, Usl>>({.transfer = {0.9}});
  check_all<BSpline<Flip, Musl, 32>>({.transfer = {0.9}});
  check_all<BSpline<Apic, Usl>>();
  check_all<BSpline<Apic, Musl>>();
}
