// Kernels of linear simplices against the reference.
#include "check_reference.hpp"

using namespace arenite;
using namespace arenite::test;

namespace {

template <class Transfer, class Order, std::size_t Bytes = 64>
using Simplex = Numerics<LinearSimplex, Transfer, Order, NoAntiLocking, Bytes>;

template <class N>
void check_all(N numerics = {}) {
  const auto check = [&](auto s) {
    s.numerics = numerics;
    check_reference(std::move(s));
  };
  check(Setup<PlaneStrain, N, SimplexMesh<2>>(sample_mesh<2>(4), 11));
  check(Setup<Axisymmetric, N, SimplexMesh<2>>(sample_mesh<2>(4), 5));
  check(Setup<ThreeDimensional, N, SimplexMesh<3>>(sample_mesh<3>(3), 11));
}

}  // namespace

TEST_CASE("linear simplices: P2G, MUSL mapping and G2P are the formulas of one point") {
  check_all<Simplex<Flip, Usl>>({.transfer = {0.9}});
  check_all<Simplex<Flip, Musl>>({.transfer = {0.9}});
  check_all<Simplex<Tpic, Usl, 32>>();
}
