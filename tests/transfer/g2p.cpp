// Strains, volumes, work and positions of a step with a uniform velocity gradient, and the same stresses on trial.
#include "catch.hpp"
#include "setup.hpp"

using namespace arenite;
using namespace arenite::test;

namespace {

/// The increment of v = a + A x, written out; `hoop`: v_r / r for v_r = A_rr r.
template <int D>
StrainStep<double, D> exact(const Mat<double, D>& A, double dt, bool hoop) {
  StrainStep<double, D> inc;
  inc.strain[0] = A(0, 0) * dt;
  inc.strain[1] = A(1, 1) * dt;
  inc.strain[3] = (A(0, 1) + A(1, 0)) / 2 * dt;
  inc.spin[0] = (A(0, 1) - A(1, 0)) / 2 * dt;
  if (hoop) inc.strain[2] = A(0, 0) * dt;
  if constexpr (D == 3) {
    inc.strain[2] = A(2, 2) * dt;
    inc.strain[4] = (A(1, 2) + A(2, 1)) / 2 * dt;
    inc.strain[5] = (A(2, 0) + A(0, 2)) / 2 * dt;
    inc.spin[1] = (A(1, 2) - A(2, 1)) / 2 * dt;
    inc.spin[2] = (A(2, 0) - A(0, 2)) / 2 * dt;
  }
  return inc;
}

template <class S>
void check_deform(S s) {
  constexpr int D = S::D;
  const double dt = 0.01;
  s.p2g();
  Vec<double, D> a;
  Mat<double, D> A;
  for (int k = 0; k < D; ++k) {
    a[k] = s.number();
    for (int j = 0; j < D; ++j) A(k, j) = s.number();
  }
  if constexpr (S::K::hoop) {
    a[0] = 0;
    A(0, 1) = 0;  // v_r = A_rr r
  }
  for (Index i = 0; i < s.nodes.size(); ++i) {
    s.nodes.velocity[i] = a + A * s.node(i);
    if constexpr (S::N::maps_back) s.nodes.mapped[i] = s.nodes.velocity[i];
  }
  const auto before = s.body.points;
  const G2pSums tried = s.update_stress(dt);
  const auto trial = s.body.points;
  REQUIRE(trial.position == before.position);
  s.body.points = before;
  const auto inc = exact<D>(A, dt, S::K::hoop);
  const G2pSums sums = s.g2p(dt);
  double stress_off = 0, volume_off = 0, position_off = 0, work = 0;
  for (std::size_t p = 0; p < before.size(); ++p) {
    auto stress = before.stress[p];
    NoHistory<double> h;
    s.body.law.update(stress, inc, h);
    const double volume = before.volume[p] * std::exp(trace(inc.strain));
    for (std::size_t k = 0; k < stress.size; ++k)
      stress_off = std::max(stress_off, std::abs(stress[k] - s.body.points.stress[p][k]));
    volume_off = std::max(volume_off, std::abs(s.body.points.volume[p] - volume));
    position_off =
        std::max(position_off,
                 (s.body.points.position[p] - before.position[p] - dt * (a + A * before.position[p])).norm());
    work += (before.volume[p] + volume) / 2 * contract(before.stress[p] + stress, inc.strain) / 2;
  }
  REQUIRE(stress_off < 1e-9);  // of 1e4 Pa
  REQUIRE(volume_off < 1e-14);
  REQUIRE(position_off < 1e-15);
  REQUIRE(std::abs(sums.work - work) < 1e-9 * std::abs(work));
  REQUIRE(sums.opened_volume == 0);
  REQUIRE(trial.stress == s.body.points.stress);
  REQUIRE(trial.volume == s.body.points.volume);
  REQUIRE(tried.work == sums.work);
}

template <class A>
using Simplex = Numerics<LinearSimplex, Flip, Usl, A>;
using BSpline = Numerics<QuadraticBSpline, Flip, Musl>;
template <class Transfer>
using UslSpline = Numerics<QuadraticBSpline, Transfer, Usl>;

}  // namespace

TEST_CASE("a uniform velocity gradient gives its strain, spin and hoop strain exactly") {
  check_deform(Setup<PlaneStrain, Simplex<NoAntiLocking>, SimplexMesh<2>>(sample_mesh<2>(4)));
  check_deform(Setup<Axisymmetric, Simplex<NoAntiLocking>, SimplexMesh<2>>(sample_mesh<2>(4)));
  check_deform(Setup<ThreeDimensional, Simplex<NoAntiLocking>, SimplexMesh<3>>(sample_mesh<3>(2)));
  check_deform(Setup<PlaneStrain, BSpline, CartesianGrid<2>>(flat_grid()));
  check_deform(Setup<Axisymmetric, BSpline, CartesianGrid<2>>(flat_grid()));
  check_deform(Setup<ThreeDimensional, BSpline, CartesianGrid<3>>(solid_grid()));
  check_deform(Setup<Axisymmetric, UslSpline<Flip>, CartesianGrid<2>>(flat_grid()));
  check_deform(Setup<Axisymmetric, UslSpline<Apic>, CartesianGrid<2>>(flat_grid()));
  check_deform(Setup<ThreeDimensional, UslSpline<Flip>, CartesianGrid<3>>(solid_grid()));
  check_deform(Setup<ThreeDimensional, UslSpline<Apic>, CartesianGrid<3>>(solid_grid()));
}

TEST_CASE("averaging over the nodes changes nothing where the strain is uniform") {
  check_deform(Setup<PlaneStrain, Simplex<NodalAveraging>, SimplexMesh<2>>(sample_mesh<2>(4)));
  check_deform(Setup<Axisymmetric, Simplex<NodalAveraging>, SimplexMesh<2>>(sample_mesh<2>(4)));
  check_deform(Setup<ThreeDimensional, Simplex<NodalAveraging>, SimplexMesh<3>>(sample_mesh<3>(2)));
}
