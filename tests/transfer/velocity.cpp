// PIC, FLIP, their blend, and the order of the stress update.
#include "compare.hpp"

using namespace arenite;
using namespace arenite::test;

namespace {

using Simplex = Setup<PlaneStrain, Numerics<LinearSimplex, Flip, Musl>, SimplexMesh<2>>;

}  // namespace

TEST_CASE("a blend is the share of FLIP and the rest of PIC") {
  Simplex start(sample_mesh<2>(3));
  start.p2g();
  start.update_grid(0.01, {1, -2});
  const auto velocities = [&](double share) {
    auto s = start;
    s.numerics.transfer.fraction = share;
    s.gather();
    return s.body.points.velocity;
  };
  const auto pic = velocities(0), flip = velocities(1), blend = velocities(0.25);
  double off = 0;
  for (std::size_t p = 0; p < pic.size(); ++p) {
    const Simplex::Cell cell(start.mesh, start.body.points.cell[p]);
    const auto w = cell.weights(start.body.points.position[p]);
    Vec<double, 2> end(0, 0), change(0, 0);
    for (int k = 0; k < 3; ++k) {
      const Index i = cell.nodes[static_cast<std::size_t>(k)];
      end += w[k] * start.nodes.velocity[i];
      change += w[k] * (start.nodes.velocity[i] - start.nodes.start[i]);
    }
    off = std::max({off, (pic[p] - end).norm(), (flip[p] - start.body.points.velocity[p] - change).norm(),
                    (blend[p] - 0.25 * flip[p] - 0.75 * pic[p]).norm()});
  }
  REQUIRE(off < 1e-14);
}

TEST_CASE("FLIP without forces changes no velocity") {
  Simplex s(sample_mesh<2>(3));
  const auto before = s.body.points.velocity;
  s.p2g();
  s.update_grid();
  s.gather();
  for (std::size_t p = 0; p < before.size(); ++p)
    REQUIRE((s.body.points.velocity[p] - before[p]).norm() < 1e-15);
}

TEST_CASE("points take the same velocities however long the step: with the weights of its begin") {
  const auto check = [](auto s) {
    s = advanced(std::move(s));
    auto still = s;
    still.gather();
    s.map_back();
    s.g2p(0.01);
    REQUIRE(s.body.points.position != still.body.points.position);
    REQUIRE(s.body.points.velocity == still.body.points.velocity);
    REQUIRE(s.body.points.velocity_gradient == still.body.points.velocity_gradient);
  };
  check(Setup<PlaneStrain, Numerics<LinearSimplex, Flip, Musl>, SimplexMesh<2>>(sample_mesh<2>(4)));
  check(Setup<ThreeDimensional, Numerics<LinearSimplex, Tpic, Usl>, SimplexMesh<3>>(sample_mesh<3>(3), 11));
  check(Setup<PlaneStrain, Numerics<QuadraticBSpline, Flip, Usl>, CartesianGrid<2>>(flat_grid(), 5));
  check(Setup<Axisymmetric, Numerics<QuadraticBSpline, Apic, Usl>, CartesianGrid<2>>(flat_grid()));
  check(Setup<ThreeDimensional, Numerics<QuadraticBSpline, Apic, Usl>, CartesianGrid<3>>(solid_grid(), 9));
}

TEST_CASE("shares outside 0 to 1 are refused") {
  for (const double share : {-0.1, 1.1, std::nan("")})
    REQUIRE(throws([&] { static_cast<void>(Flip{share}); }, "must lie in [0, 1]"));
  REQUIRE_NOTHROW(Flip{0});
  REQUIRE(throws([] { Flip{}.fraction = 2; }, "Flip.fraction = 2: must lie in [0, 1]"));
  REQUIRE(
      throws([] { static_cast<void>(ElementAverage{-1}); }, "ElementAverage.fill = -1: must be positive"));
  REQUIRE(throws([] { static_cast<void>(NodalAndElementAverage{0}); },
                 "NodalAndElementAverage.fill = 0: must be positive"));
}

TEST_CASE("strains come from the nodal velocities (USL) or from those mapped back (MUSL)") {
  NodeField<double, 2, false, false> usl(3);
  NodeField<double, 2, true, false> musl(3);
  REQUIRE(usl.mapped.empty());
  REQUIRE(usl.mass_gradient.empty());
  REQUIRE(&usl.strain_velocity() == &usl.velocity);
  REQUIRE(&musl.strain_velocity() == &musl.mapped);
  REQUIRE(usl.bytes() == 3 * (8 + 1 + 2 * 2) * sizeof(double));
  REQUIRE(musl.bytes() == 3 * (8 + 1 + 3 * 2) * sizeof(double));
}

TEST_CASE("the same bits for any number of threads") {
  const auto cycle = [](int count) {
    const int before = threads();
    set_threads(count);
    Simplex s(sample_mesh<2>(8));
    s.p2g();
    s.update_grid(0.01, {0, -9.81});
    s.map_back();
    const double work = s.g2p(0.01).work;
    set_threads(before);
    return std::make_tuple(work, s.nodes.mass, s.nodes.sums, s.nodes.mapped, s.body.points.position);
  };
  const auto one = cycle(1);
  for (const int n : {2, 3, 7}) REQUIRE(cycle(n) == one);
}
