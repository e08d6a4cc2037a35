// Cures of locking against hand values on two triangles.
#include <arenite/law/mohr_coulomb.hpp>

#include "catch.hpp"
#include "setup.hpp"

using namespace arenite;
using namespace arenite::test;

namespace {

/// Unit square cut from corner 0 to corner 2: cells (0, 1, 2) and (0, 2, 3).
SimplexMesh<2> square_of_two() {
  return SimplexMesh<2>({{{0, 0}, {1, 0}, {1, 1}, {0, 1}}, {{{0, 1, 2}}, {{0, 2, 3}}}, {}, {}, {}});
}

/// The setup with two points in each cell, of given volumes.
template <class A>
auto two_cells(double first, double second) {
  Setup<PlaneStrain, Numerics<LinearSimplex, Flip, Usl, A>, SimplexMesh<2>> s(square_of_two(), 2);
  for (std::size_t p = 0; p < 4; ++p)
    s.body.points.volume[p] = (s.body.points.cell[p] == 0 ? first : second) / 2;
  return s;
}

template <class Points>
Sym<double, 2> mean_stress(const Points& points, Index cell) {
  Sym<double, 2> sum{};
  double volume = 0;
  for (std::size_t p = 0; p < points.size(); ++p)
    if (points.cell[p] == cell) {
      sum += points.volume[p] * points.stress[p];
      volume += points.volume[p];
    }
  return sum * (1 / volume);
}

}  // namespace

TEST_CASE("nodal averaging: a node takes the mean of its cells by volume, a cell that of its nodes") {
  const double v0 = 0.3, v1 = 0.5, dt = 0.01;
  auto s = two_cells<NodalAveraging>(v0, v1);
  s.body.points.stress.fill({});
  s.p2g();
  // Node 1 moves with (2, 0), node 3 with (0, 3): tr = 2 in cell 0 and 3 in cell 1.
  s.nodes.velocity[1] = {2, 0};
  s.nodes.velocity[3] = {0, 3};
  s.g2p(dt);
  const double shared = (v0 * 2 + v1 * 3) / (v0 + v1);
  const std::array<double, 2> rate{(2 * shared + 2) / 3, (2 * shared + 3) / 3};
  for (std::size_t p = 0; p < 4; ++p) {
    const Index c = s.body.points.cell[p];
    REQUIRE(std::abs(trace(s.body.points.stress[p]) / 3 - s.body.law.elasticity().bulk() * rate[c] * dt) <
            1e-9);
    // The deviator is the cell's own: 2 G (e_xx - e_yy) and no mixing of shear.
    const double difference = s.body.points.stress[p][0] - s.body.points.stress[p][1];
    REQUIRE(std::abs(difference - 2 * s.body.law.elasticity().shear() * (c == 0 ? 2 : -3) * dt) < 1e-9);
  }
}

TEST_CASE("nodal averaging: the dilation of the last step stays in its cell, by volume of its points") {
  const MohrCoulomb dense{{.density = 1000, .young = 1e6, .poisson = 0.3, .friction = 0.7, .dilatancy = 0.2}};
  using N = Numerics<LinearSimplex, Flip, Usl, NodalAveraging>;
  const auto mesh = square_of_two();
  auto body =
      make_body<PlaneStrain, N::extra_columns>(mesh, fill(Box{{0., 0.}, {1., 1.}}, dense, {.per_cell = 3}));
  const Blocks blocks(2, 4, 1, [&](Index c) { return mesh.nodes(c); });
  NodeField<double, 2, false, false> nodes(4);
  const double v0 = 0.3, v1 = 0.5, dt = 0.01;
  std::array<double, 2> mean{};
  for (std::size_t p = 0; p < 6; ++p) {
    const Index c = body.points.cell[p];
    body.points.volume[p] = (c == 0 ? v0 : v1) * (p % 3 == 0 ? 0.5 : 0.25);
    body.points.dilation[p] = 1e-3 * static_cast<double>(p);
    mean[c] += body.points.dilation[p] * (p % 3 == 0 ? 0.5 : 0.25);
  }
  p2g<PlaneStrain>(N{}, mesh, blocks, body, nodes);
  nodes.velocity[1] = {2, 0};
  nodes.velocity[3] = {0, 3};
  VolumetricAverage<double> average;
  average.sum<PlaneStrain, N>(mesh, blocks, body, nodes, dt);
  average.finish(mesh, blocks, body);
  const double e0 = 2 * dt - mean[0], e1 = 3 * dt - mean[1], shared = (v0 * e0 + v1 * e1) / (v0 + v1);
  CHECK(std::abs(average.cell_strain[0] - ((2 * shared + e0) / 3 + mean[0])) <= 1e-16);
  CHECK(std::abs(average.cell_strain[1] - ((2 * shared + e1) / 3 + mean[1])) <= 1e-16);
}

TEST_CASE("element average: a filled cell carries the mean stress over its whole volume") {
  auto s = two_cells<ElementAverage>(0.26, 0.24);  // 52 % and 48 % of half a square metre
  const auto mean = mean_stress(s.body.points, 0), partly = mean_stress(s.body.points, 1);
  const auto before = s.body.points.stress;
  s.p2g();
  // Gradients: node 1 belongs only to cell 0, (1, -1); node 3 only to cell 1, (-1, 1).
  const Vec<double, 2> at_1(-0.5 * (mean[0] - mean[3]), -0.5 * (mean[3] - mean[1]));
  const Vec<double, 2> at_3(-0.24 * (-partly[0] + partly[3]), -0.24 * (-partly[3] + partly[1]));
  REQUIRE((s.nodes.sums[1].force() - at_1).norm() < 1e-15);
  REQUIRE((s.nodes.sums[3].force() - at_3).norm() < 1e-15);

  for (std::size_t p = 0; p < 4; ++p)
    for (std::size_t k = 0; k < 4; ++k)
      REQUIRE(std::abs(s.body.points.stress[p][k] - (s.body.points.cell[p] == 0 ? mean[k] : before[p][k])) <
              1e-15);
}

TEST_CASE("element average: the work of the stress is that of the force, over the volume that carries it") {
  auto s = two_cells<ElementAverage>(0.26, 0.24);
  s.p2g();
  const double dt = 1e-9;  // the stress hardly changes
  s.nodes.velocity[1] = {2, 1};
  s.nodes.velocity[3] = {-1, 3};
  double power = 0;  // of the internal force, W
  for (std::size_t i = 0; i < 4; ++i) power -= s.nodes.sums[i].force().dot(s.nodes.velocity[i]);
  CHECK(std::abs(s.g2p(dt).work / dt - power) <= 1e-2 * std::abs(power));
}

TEST_CASE("element average in axisymmetry: the whole volume is the full circle's") {
  // A ring of one triangle, evenly filled: full, and forces those of the plain integration.
  const SimplexMesh<2> ring({{{1, 0}, {2, 0}, {1, 1}}, {{{0, 1, 2}}}, {}, {}, {}});
  auto body = make_body<Axisymmetric>(ring, fill(Box{{0., 0.}, {9., 9.}}, elastic, {.per_cell = 3}));
  for (auto& v : body.points.volume) v *= 0.95;
  body.points.stress.fill({{1, 2, 3, 4}});
  const Blocks blocks(1, 3, 1, [&](Index c) { return ring.nodes(c); });
  NodeField<double, 2, false, false> plain(3), average(3);
  p2g<Axisymmetric>(Numerics<LinearSimplex, Flip, Usl>{}, ring, blocks, body, plain);
  p2g<Axisymmetric>(Numerics<LinearSimplex, Flip, Usl, ElementAverage>{}, ring, blocks, body, average);
  for (std::size_t i = 0; i < 3; ++i)
    REQUIRE((average.sums[i].force() - plain.sums[i].force() / 0.95).norm() < 1e-13);
  // Unlike stresses: the hoop stress of each point is the mean one too.
  auto alike = body;
  for (std::size_t p = 0; p < body.points.size(); ++p) {
    const double s = static_cast<double>(p);
    body.points.stress.set(p, {{1 + s, 2 - s, 3 + 4 * s, s * s}});
  }
  alike.points.stress.fill(mean_stress(body.points, 0));
  NodeField<double, 2, false, false> unlike(3), same(3);
  p2g<Axisymmetric>(Numerics<LinearSimplex, Flip, Usl, ElementAverage>{}, ring, blocks, body, unlike);
  p2g<Axisymmetric>(Numerics<LinearSimplex, Flip, Usl, ElementAverage>{}, ring, blocks, alike, same);
  for (std::size_t i = 0; i < 3; ++i) REQUIRE((unlike.sums[i].force() - same.sums[i].force()).norm() < 1e-13);
}
