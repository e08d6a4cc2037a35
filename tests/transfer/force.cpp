// Internal force: its virtual work, its sums, and the patch of uniform stress.
#include <arenite/parallel/communicator.hpp>
#include <arenite/transfer/light_nodes.hpp>

#include "catch.hpp"
#include "setup.hpp"

using namespace arenite;
using namespace arenite::test;

namespace {

/// sum f . v against -sum V sigma : grad v for random nodal velocities v, with the hoop term v_r / r.
template <class S>
void check_virtual_work(S s) {
  using T = typename S::T;
  constexpr int D = S::D;
  s.p2g();
  for (int trial = 0; trial < 5; ++trial) {
    std::vector<Vec<T, D>> v(s.nodes.size());
    for (auto& value : v)
      for (int k = 0; k < D; ++k) value[k] = s.number();
    double work = 0, inner = 0, size = 0;
    for (std::size_t i = 0; i < v.size(); ++i) work += static_cast<double>(s.nodes.sums[i].force().dot(v[i]));
    const auto& points = s.body.points;
    for (std::size_t p = 0; p < points.size(); ++p) {
      const typename S::Cell cell(s.mesh, points.cell[p]);
      const auto g = cell.gradients(points.position[p]);
      const auto w = cell.weights(points.position[p]);
      double sum = 0;
      for (int k = 0; k < w.size(); ++k) {
        const auto& u = v[cell.nodes[static_cast<std::size_t>(k)]];
        for (int i = 0; i < D; ++i)
          for (int j = 0; j < D; ++j) sum += static_cast<double>(points.stress[p](i, j) * u[i] * g(j, k));
        if constexpr (S::K::hoop)
          sum += static_cast<double>(points.stress[p](2, 2) * w[k] * u[0] / points.position[p][0]);
      }
      inner -= static_cast<double>(points.volume[p]) * sum;
      size += std::abs(static_cast<double>(points.volume[p]) * sum);
    }
    REQUIRE(size > 1);
    REQUIRE(std::abs(work - inner) <= 1000 * static_cast<double>(std::numeric_limits<T>::epsilon()) * size);
  }
}

/// Largest force at the nodes inside and at all nodes, under a uniform stress and an even filling.
template <class K, class N, class M>
std::pair<double, double> patch(const M& mesh, int per_cell, const Sym<double, M::dimension>& stress) {
  constexpr int D = M::dimension;
  using Shape = typename N::Shape;
  std::array<double, D> lower, upper;
  lower.fill(-10);
  upper.fill(10);
  auto body = make_body<K>(mesh, fill(Box<D>{lower, upper}, elastic, {.per_cell = per_cell}));
  body.points.stress.fill(stress);
  const Blocks blocks(mesh.cell_count(), Shape::node_count(mesh), 4,
                      [&](Index c) { return typename Shape::template Cell<M>(mesh, c).nodes; });
  NodeField<double, D, false, false> nodes(Shape::node_count(mesh));
  p2g<K>(N{}, mesh, blocks, body, nodes);
  Vec<double, D> low = Shape::node_position(mesh, 0), high = low;
  for (Index i = 0; i < nodes.size(); ++i) {
    low = low.cwiseMin(Shape::node_position(mesh, i));
    high = high.cwiseMax(Shape::node_position(mesh, i));
  }
  double inside = 0, all = 0;
  for (Index i = 0; i < nodes.size(); ++i) {
    const auto x = Shape::node_position(mesh, i);
    all = std::max(all, nodes.sums[i].force().norm());
    if (((x - low).array() > 1e-9).all() && ((high - x).array() > 1e-9).all())
      inside = std::max(inside, nodes.sums[i].force().norm());
  }
  return {inside, all};
}

using Simplex = Numerics<LinearSimplex, Flip, Usl>;
using BSpline = Numerics<QuadraticBSpline, Flip, Usl>;

}  // namespace

TEST_CASE("the internal force does the virtual work of the stresses") {
  check_virtual_work(Setup<PlaneStrain, Simplex, SimplexMesh<2>>(sample_mesh<2>(4)));
  check_virtual_work(Setup<Axisymmetric, Simplex, SimplexMesh<2>>(sample_mesh<2>(4)));
  check_virtual_work(Setup<ThreeDimensional, Simplex, SimplexMesh<3, float>>(sample_mesh<3, float>(2)));
  check_virtual_work(Setup<PlaneStrain, BSpline, CartesianGrid<2>>(flat_grid()));
  check_virtual_work(Setup<Axisymmetric, BSpline, CartesianGrid<2>>(flat_grid()));
  check_virtual_work(Setup<ThreeDimensional, BSpline, CartesianGrid<3>>(solid_grid()));
}

TEST_CASE("a uniform stress loads no node inside") {
  const auto check = [](std::pair<double, double> force) {
    REQUIRE(force.first < 1e-13);
    REQUIRE(force.second > 0.01);
  };
  const Sym<double, 2> flat{{-1, -2, -1.5, 0.7}},
      round{{-1, -2, -1, 0}};  // equal in the cross plane: no radial force
  const Sym<double, 3> solid{{-1, -2, -3, 0.5, 0.6, 0.7}};
  for (const int n : {1, 3, 4, 10, 16}) {
    check(patch<PlaneStrain, Simplex>(sample_mesh<2>(4), n, flat));
    check(patch<Axisymmetric, Simplex>(sample_mesh<2>(4), n, round));
  }
  for (const int n : {1, 4, 10}) check(patch<ThreeDimensional, Simplex>(sample_mesh<3>(3), n, solid));
  for (const int n : {1, 4, 9}) check(patch<PlaneStrain, BSpline>(flat_grid(), n, flat));
  for (const int n : {1, 8})
    check(patch<ThreeDimensional, BSpline>(
        CartesianGrid<3>({.lower = {0, 0, 0}, .upper = {1, 1, 1}, .cell = 0.25}), n, solid));
}

TEST_CASE("nodes of no mass stay at rest, and those below the floor count as none") {
  Setup<PlaneStrain, Simplex, SimplexMesh<2>> s(sample_mesh<2>(4));
  s.p2g();
  auto& sums = s.nodes.sums;
  sums[0].lane[sums[0].mass_lane] = 1e-200;
  sums[1].lane[sums[1].mass_lane] = 0;
  sums[1].lane[sums[1].force_lane] = 1;
  update_grid(s.nodes, Vec<double, 2>(0, -10), 0.1, 1e-150);
  REQUIRE(s.nodes.mass[0] == 0);
  for (const Index i : {0u, 1u}) REQUIRE((s.nodes.start[i].norm() == 0 && s.nodes.velocity[i].norm() == 0));
  for (const auto& v : s.nodes.velocity) REQUIRE(v.allFinite());
}

namespace {

/// Gradients of mass against the sum of m grad N over all points.
template <class S>
void check_mass_gradient(S s) {
  constexpr int D = S::D;
  s.p2g();
  std::vector<Vec<double, D>> sum(s.nodes.size(), Vec<double, D>::Zero());
  const auto& points = s.body.points;
  for (std::size_t p = 0; p < points.size(); ++p) {
    const typename S::Cell cell(s.mesh, points.cell[p]);
    const auto g = cell.gradients(points.position[p]);
    for (int k = 0; k < g.cols(); ++k)
      sum[cell.nodes[static_cast<std::size_t>(k)]] += points.mass[p] * g.col(k);
  }
  double off = 0, size = 0;
  for (std::size_t i = 0; i < sum.size(); ++i) {
    off = std::max(off, (s.nodes.mass_gradient[i] - sum[i]).norm());
    size = std::max(size, sum[i].norm());
  }
  REQUIRE(size > 1);
  REQUIRE(off <= 1e-13 * size);
}

}  // namespace

TEST_CASE("gradients of mass are the sum of m grad N") {
  check_mass_gradient(Setup<PlaneStrain, Simplex, SimplexMesh<2>>(sample_mesh<2>(6)));
  check_mass_gradient(Setup<ThreeDimensional, Simplex, SimplexMesh<3>>(sample_mesh<3>(3)));
  check_mass_gradient(Setup<PlaneStrain, BSpline, CartesianGrid<2>>(flat_grid()));
  check_mass_gradient(Setup<ThreeDimensional, BSpline, CartesianGrid<3>>(solid_grid()));
  // More points in a cell than the rows have space for.
  check_mass_gradient(Setup<PlaneStrain, BSpline, CartesianGrid<2>>(flat_grid(), 75));
}

TEST_CASE("gradients of mass point out of the body and sum to zero") {
  Setup<PlaneStrain, Simplex, SimplexMesh<2>> s(sample_mesh<2>(6));
  auto& points = s.body.points;
  for (std::size_t p = 0; p < points.size(); ++p) points.mass[p] = points.position[p][1] < 0.5 ? 1 : 1e-30;
  s.p2g();
  Vec<double, 2> sum(0, 0);
  for (const auto& g : s.nodes.mass_gradient) sum += g;
  REQUIRE(sum.norm() < 1e-11);
  for (Index i = 0; i < s.nodes.size(); ++i)
    if (s.node(i)[1] > 0.5 && s.nodes.sums[i].mass() > 0.1) REQUIRE(s.nodes.mass_gradient[i][1] > 0);
}

TEST_CASE("Points on a face: the node outside of it has a force and no mass, and momentum is kept") {
  Setup<PlaneStrain, Numerics<LinearSimplex, Flip, Usl>, SimplexMesh<2>> s(sample_mesh<2>(3), 0);
  for (Index c = 0; c < s.mesh.cell_count(); c += 5) {
    const auto& nodes = s.mesh.nodes(c);
    s.add(0.3 * s.mesh.position(nodes[0]) + 0.7 * s.mesh.position(nodes[1]), c);
  }
  s.index();
  s.p2g();
  const double dt = 0.1;
  arenite::update_grid(s.nodes, Vec<double, 2>(Vec<double, 2>::Zero()), dt, 1e-14);
  double pushed = 0;
  for (Index i = 0; i < s.nodes.size(); ++i)
    if (!(s.nodes.mass[i] > 0)) pushed += dt * s.nodes.sums[i].force().norm();
  REQUIRE(pushed > 0.1);
  list_massless(s.nodes, OwnsAll{});
  redistribute_forces<LinearSimplex>(s.mesh, s.nodes, dt, InPlace{s.nodes.velocity});
  REQUIRE((s.node_momentum() - s.point_momentum()).norm() <= 1e-13);
}
