// Requirements of the kernels of products along the axes, with any shape function on a grid.
#pragma once

#include "check_conservation.hpp"
#include "check_reference.hpp"

namespace arenite::test {

/// P2G, MUSL mapping and G2P are the formulas of one point, in packs of `Bytes`, in boundary cells too (the
/// grids have hardly any others).
template <class N>
void check_reference_on_grids(N numerics = {}) {
  const auto check = [&](auto s) {
    s.numerics = numerics;
    check_reference(std::move(s), 1e-12);
  };
  check(Setup<PlaneStrain, N, CartesianGrid<2>>(flat_grid(), 11));
  check(Setup<Axisymmetric, N, CartesianGrid<2>>(flat_grid(), 5));
  check(Setup<ThreeDimensional, N, CartesianGrid<3>>(solid_grid(), 11));
}

template <class Shape>
void check_all_references() {
  check_reference_on_grids<Numerics<Shape, Flip, Usl, NoAntiLocking, 64>>({.transfer = {0.9}});
  check_reference_on_grids<Numerics<Shape, Flip, Musl, NoAntiLocking, 32>>({.transfer = {0.9}});
  check_reference_on_grids<Numerics<Shape, Apic, Usl, NoAntiLocking, 16>>();
  check_reference_on_grids<Numerics<Shape, Apic, Musl, NoAntiLocking, 64>>();
}

/// Mass and momentum through a cycle, for PIC, FLIP and APIC.
template <class Shape>
void check_all_conservation() {
  for (const double share : {0.0, 0.3, 1.0}) {
    Setup<PlaneStrain, Numerics<Shape, Flip, Musl>, CartesianGrid<2, float>> flat(flat_grid<float>());
    flat.numerics.transfer.fraction = share;
    check_conservation(flat);
    Setup<Axisymmetric, Numerics<Shape, Flip, Usl>, CartesianGrid<2>> round(flat_grid());
    round.numerics.transfer.fraction = share;
    check_conservation(round);
  }
  check_conservation(Setup<PlaneStrain, Numerics<Shape, Apic, Usl>, CartesianGrid<2>>(flat_grid()));
  check_conservation(Setup<Axisymmetric, Numerics<Shape, Apic, Musl>, CartesianGrid<2>>(flat_grid()));
  check_conservation(Setup<ThreeDimensional, Numerics<Shape, Apic, Musl>, CartesianGrid<3>>(solid_grid()));
}

}  // namespace arenite::test
