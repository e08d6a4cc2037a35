// Normals of the mass gradient at a plane interface, through the real scatter.
#include "catch.hpp"

#include <arenite/contact/contact.hpp>
#include <arenite/law/linear_elastic.hpp>
#include <arenite/transfer/p2g.hpp>

#include "../mesh/sample_meshes.hpp"

using namespace arenite;
using namespace arenite::test;

namespace {

/// Two blocks of different density that touch in a plane through the middle with normal (cos a, sin a): mean
/// (weighted by the impulse) and worst angle, rad, between the impulses of a frictionless contact and the
/// normal, at nodes away from the hull.
template <class N, class M>
std::pair<double, double> angles(const M& mesh, double a, int per_cell) {
  using Shape = typename N::Shape;
  const Vec<double, 2> normal(std::cos(a), std::sin(a)), middle(0.5, 0.5);
  const auto below = [=](const auto& x) { return (Vec<double, 2>(x) - middle).dot(normal); };
  const auto above = [=](const auto& x) { return -(Vec<double, 2>(x) - middle).dot(normal); };
  const LinearElastic light{{.density = 1000, .young = 1e6, .poisson = 0}},
      heavy{{.density = 3000, .young = 1e6, .poisson = 0}};
  const Blocks blocks(mesh.cell_count(), Shape::node_count(mesh), 4,
                      [&](Index c) { return typename Shape::template Cell<M>(mesh, c).nodes; });
  std::array<NodeField<double, 2, false, true>, 2> fields{
      NodeField<double, 2, false, true>(Shape::node_count(mesh)),
      NodeField<double, 2, false, true>(Shape::node_count(mesh))};
  auto lower = make_body<PlaneStrain>(mesh, fill(Inside{below}, light, {.per_cell = per_cell}));
  auto upper = make_body<PlaneStrain>(mesh, fill(Inside{above}, heavy, {.per_cell = per_cell}));
  p2g<PlaneStrain>(N{}, mesh, blocks, lower, fields[0]);
  p2g<PlaneStrain>(N{}, mesh, blocks, upper, fields[1]);
  for (auto& field : fields) update_grid(field, Vec<double, 2>(0, 0), 0.0, 0.0);
  for (Index i = 0; i < Shape::node_count(mesh); ++i) {
    fields[0].velocity[i] = normal;  // pressed together
    fields[1].velocity[i] = -normal;
  }
  const auto before = fields;
  std::array<Vec<double, 2>, 2> impulses;
  std::vector<ContactPair<double, 2>> pairs;
  const auto tally = apply_contact(Coulomb<>(Friction::frictionless()), MassGradient{}, fields, impulses,
                                   pairs, 1e-9, [](Index) { return 1.0; });
  REQUIRE(tally.nodes > 10);
  double worst = 0, sum = 0, all = 0;
  for (Index i = 0; i < Shape::node_count(mesh); ++i) {
    const auto x = Shape::node_position(mesh, i);
    const Vec<double, 2> j = fields[0].mass[i] * (fields[0].velocity[i] - before[0].velocity[i]);
    if (j.norm() == 0 || (x - middle).template lpNorm<Eigen::Infinity>() > 0.35) continue;
    const double angle = std::acos(std::min(1.0, -j.normalized().dot(normal)));
    worst = std::max(worst, angle);
    sum += j.norm() * angle;
    all += j.norm();
  }
  return {sum / all, worst};
}

}  // namespace

TEST_CASE(
    "at a plane interface the normals are those of the plane: exact along the grid, blurred across it") {
  const CartesianGrid<2> grid({.lower = {0, 0}, .upper = {1, 1}, .cell = 0.05});
  using BSpline = Numerics<QuadraticBSpline, Flip, Usl>;
  REQUIRE(angles<BSpline>(grid, 0, 16).second < 1e-7);
  REQUIRE(angles<BSpline>(grid, pi / 2, 16).second < 1e-7);
  // Askew: a node that sees few points has a poor normal, but little mass to exchange an impulse with.
  REQUIRE(angles<BSpline>(grid, pi / 4, 16).first < 0.05);
  REQUIRE(angles<BSpline>(grid, 0.3, 16).first < 0.05);
  REQUIRE(angles<Numerics<LinearSimplex, Flip, Usl>>(sample_mesh<2>(20, 0.0), 0, 15).first < 0.3);
}
