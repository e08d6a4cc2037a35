// Transfers of a user's own: each is one class, and no kernel knows of it.
#include "check_reference.hpp"

using namespace arenite;
using namespace arenite::test;

namespace {

/// PIC: points take the velocity of the nodes and hand it back.
struct Pic {
  static constexpr bool affine = false;
  template <class Shape>
  static constexpr bool fits = true;

  template <class Point>
  auto particle_field(const Point& p) const {
    return VelocityField{p.velocity()};
  }
  struct Gathered {
    static constexpr bool needs_moments = false;
    Nothing velocity{};  // what points take are the new velocities of the nodes
    template <class Cell, class Point, class X, class Sums>
    auto operator()(const Cell&, const Point& p, const X&, const Sums& sums) const {
      p.set_velocity(sums.value);
      return VelocityField{sums.value};
    }
  };
  template <class Cell, class Nodes>
  auto gather(const Cell&, const Nodes&) const {
    return Gathered{};
  }
};

/// APIC whose points keep a fraction of their affine motion.
struct DampedApic : Apic {
  double fraction = 1;

  struct Gathered : Apic::Gathered {
    double fraction = 1;
    template <class Cell, class Point, class X, class Sums>
    auto operator()(const Cell& cell, const Point& p, const X& x, const Sums& sums) const {
      using P = typename Point::P;
      auto field = Apic::Gathered::operator()(cell, p, x, sums);
      for (P& component : field.gradient) component = component * P(static_cast<typename Point::T>(fraction));
      p.set_velocity_gradient(field.gradient);
      return field;
    }
  };
  template <class Cell, class Nodes>
  auto gather(const Cell&, const Nodes&) const {
    return Gathered{{}, fraction};
  }
};

/// Points after a cycle of a transfer, for any N and mesh.
template <class K, class N, class M>
auto cycle(const M& mesh, N numerics = {}) {
  Setup<K, N, M> s(mesh, 5);
  s.numerics = numerics;
  s = advanced(std::move(s));
  s.map_back();
  s.g2p(0.01);
  return s.body.points;
}

template <class Transfer, class Order>
using Simplex = Numerics<LinearSimplex, Transfer, Order>;
template <class Transfer, class Order>
using BSpline = Numerics<QuadraticBSpline, Transfer, Order>;

}  // namespace

TEST_CASE("a PIC of a user's own is FLIP with a fraction of 0") {
  const Flip flip{0};
  const auto flat = sample_mesh<2>(4);
  REQUIRE(difference(cycle<PlaneStrain, Simplex<Pic, Usl>>(flat),
                     cycle<PlaneStrain, Simplex<Flip, Usl>>(flat, {.transfer = flip})) < 1e-13);
  REQUIRE(difference(cycle<PlaneStrain, Simplex<Pic, Musl>>(flat),
                     cycle<PlaneStrain, Simplex<Flip, Musl>>(flat, {.transfer = flip})) < 1e-13);
  REQUIRE(difference(cycle<PlaneStrain, BSpline<Pic, Usl>>(flat_grid()),
                     cycle<PlaneStrain, BSpline<Flip, Usl>>(flat_grid(), {.transfer = flip})) < 1e-13);
  REQUIRE(difference(cycle<ThreeDimensional, BSpline<Pic, Musl>>(solid_grid()),
                     cycle<ThreeDimensional, BSpline<Flip, Musl>>(solid_grid(), {.transfer = flip})) < 1e-13);
}

TEST_CASE("a damped APIC of a user's own: undamped it is APIC, and it keeps to the reference") {
  REQUIRE(difference(cycle<ThreeDimensional, BSpline<DampedApic, Musl>>(solid_grid()),
                     cycle<ThreeDimensional, BSpline<Apic, Musl>>(solid_grid())) < 1e-13);
  Setup<PlaneStrain, BSpline<DampedApic, Usl>, CartesianGrid<2>> s(flat_grid(), 9);
  s.numerics.transfer.fraction = 0.5;
  check_reference(s, 1e-12);
}
