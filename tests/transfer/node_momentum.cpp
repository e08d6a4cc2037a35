// P2G where nodes collect only mass and the momentum of the end of the step: the momentum of the reference
// and the impulse of its forces.
#include <arenite/transfer/reference.hpp>

#include "catch.hpp"
#include "setup.hpp"

using namespace arenite;
using namespace arenite::test;

namespace {

/// Greatest difference of any node, over the greatest sum, in steps of which the impulses are small beside
/// the momenta, as large, and larger.
template <class K, class N, class M>
double off(const M& mesh, int per_cell) {
  Setup<K, N, M> s(mesh, per_cell);
  using T = typename M::scalar;
  constexpr int D = M::dimension;
  const auto expected = reference::p2g<K>(s.numerics, s.mesh, s.body);
  double worst = 0;
  for (const double dt : {0.01, 1.0, 100.0}) {
    NodeField<T, D, false, false, false, false> nodes(N::Shape::node_count(mesh));
    nodes.clear();
    p2g<K>(s.numerics, s.mesh, s.blocks, s.body, nodes, static_cast<T>(dt));
    double difference = 0, size = 0, mass_difference = 0, mass = 0;
    for (std::size_t i = 0; i < expected.size(); ++i) {
      const Vec<T, D> momentum = expected[i].momentum + static_cast<T>(dt) * expected[i].force;
      difference = std::max(difference, static_cast<double>((nodes.sums[i].momentum() - momentum).norm()));
      size = std::max(size, static_cast<double>(momentum.norm()));
      mass_difference =
          std::max(mass_difference, static_cast<double>(std::abs(nodes.sums[i].mass() - expected[i].mass)));
      mass = std::max(mass, static_cast<double>(expected[i].mass));
    }
    worst = std::max({worst, difference / size, mass_difference / mass});
  }
  return worst;
}

template <class Shape, std::size_t Bytes>
void check_widths() {
  using Affine = Numerics<Shape, Apic, Usl, NoAntiLocking, Bytes>;
  CHECK(off<PlaneStrain, Affine>(flat_grid(), 11) < 1e-14);
  CHECK(off<Axisymmetric, Affine>(flat_grid(), 5) < 1e-14);
  CHECK(off<ThreeDimensional, Affine>(solid_grid(), 11) < 1e-14);
}

}  // namespace

TEST_CASE("Nodes that collect one momentum get that of the points and the impulse of their stresses") {
  check_widths<QuadraticBSpline, 8>();
  check_widths<QuadraticBSpline, 16>();
  check_widths<QuadraticBSpline, 32>();
  check_widths<QuadraticBSpline, 64>();
  check_widths<CubicBSpline, 64>();
  check_widths<MlsGradient<QuadraticBSpline>, 8>();
  check_widths<MlsGradient<QuadraticBSpline>, 64>();
}

TEST_CASE("The same of a velocity without a gradient, and in float") {
  CHECK(off<ThreeDimensional, Numerics<QuadraticBSpline, Flip, Usl>>(solid_grid(), 70) < 1e-14);
  using Affine = Numerics<QuadraticBSpline, Apic, Usl>;
  CHECK(off<PlaneStrain, Affine>(flat_grid<float>(), 40) < 5e-6);
  CHECK(off<ThreeDimensional, Affine>(solid_grid<float>(), 40) < 5e-6);
}
