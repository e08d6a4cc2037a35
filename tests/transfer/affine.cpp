// Affine transfers: angular momentum to round-off, and affine fields without loss.
#include "../shape/functions_at.hpp"
#include "catch.hpp"
#include "setup.hpp"

#include <Eigen/Geometry>
#include <arenite/parallel/communicator.hpp>
#include <arenite/transfer/light_nodes.hpp>

using namespace arenite;
using namespace arenite::test;

namespace {

/// Angular momentum about the origin of a mass with velocity v, and of a matrix B = sum w v r^T.
Eigen::Vector3d moment(const Vec<double, 2>& x, const Vec<double, 2>& v) {
  return {0, 0, x[0] * v[1] - x[1] * v[0]};
}
Eigen::Vector3d moment(const Vec<double, 3>& x, const Vec<double, 3>& v) {
  return Eigen::Vector3d(x).cross(Eigen::Vector3d(v));
}
Eigen::Vector3d moment(const Mat<double, 2>& b) { return {0, 0, b(1, 0) - b(0, 1)}; }
Eigen::Vector3d moment(const Mat<double, 3>& b) {
  return {b(2, 1) - b(1, 2), b(0, 2) - b(2, 0), b(1, 0) - b(0, 1)};
}

template <class S>
Eigen::Vector3d of_points(const S& s) {
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  const auto& points = s.body.points;
  for (std::size_t p = 0; p < points.size(); ++p) {
    const FunctionsAt at(typename S::Cell(s.mesh, points.cell[p]), points.position[p]);
    const Eigen::MatrixXd r = at.node.colwise() - at.point;
    const Mat<double, S::D> b =
        points.velocity_gradient[p] * Eigen::MatrixXd(r * at.value.asDiagonal() * r.transpose());
    sum += points.mass[p] * (moment(points.position[p], points.velocity[p]) + moment(b));
  }
  return sum;
}
template <class S>
Eigen::Vector3d of_nodes(const S& s) {
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (Index i = 0; i < s.nodes.size(); ++i) sum += s.nodes.mass[i] * moment(s.node(i), s.nodes.velocity[i]);
  return sum;
}

template <class S>
void check_angular_momentum(S s) {
  const Eigen::Vector3d start = of_points(s);
  REQUIRE(start.norm() > 0.1);
  for (int cycle = 0; cycle < 5; ++cycle) {
    s.p2g();
    s.update_grid();
    REQUIRE((of_nodes(s) - start).norm() < 1e-12);
    s.gather();
    REQUIRE((of_points(s) - start).norm() < 1e-12);
  }
}

template <class S>
void check_affine_field(S s) {
  constexpr int D = S::D;
  Vec<double, D> a;
  Mat<double, D> spin = Mat<double, D>::Zero(), any;
  for (int k = 0; k < D; ++k) {
    a[k] = s.number();
    for (int j = 0; j < D; ++j) any(k, j) = s.number();
  }
  spin(1, 0) = 3;
  spin(0, 1) = -3;
  for (const Mat<double, D>& A : {spin, any}) {
    s.set_affine(a, A);
    const auto motion = s.body.points.velocity_gradient;
    double node_off = 0, point_off = 0, motion_off = 0;
    for (int cycle = 0; cycle < 3; ++cycle) {
      s.p2g();
      s.update_grid();
      for (Index i = 0; i < s.nodes.size(); ++i)
        if (s.nodes.mass[i] > 1e-3)
          node_off = std::max(node_off, (s.nodes.velocity[i] - a - A * s.node(i)).norm());
      s.gather();
      for (std::size_t p = 0; p < s.body.points.size(); ++p) {
        point_off =
            std::max(point_off, (s.body.points.velocity[p] - a - A * s.body.points.position[p]).norm());
        motion_off = std::max(motion_off, (s.body.points.velocity_gradient[p] - motion[p]).norm());
      }
    }
    REQUIRE(node_off < 1e-12);
    REQUIRE(point_off < 1e-12);
    REQUIRE(motion_off < 1e-11);
  }
}

template <class Shape>
using Flat = Setup<PlaneStrain, Numerics<Shape, Apic, Usl>, CartesianGrid<2>>;
template <class Shape>
using InSpace = Setup<ThreeDimensional, Numerics<Shape, Apic, Usl>, CartesianGrid<3>>;

}  // namespace

TEMPLATE_TEST_CASE("APIC keeps angular momentum to round-off, orbital and affine part, in boundary cells too",
                   "", LinearGrid, QuadraticBSpline, CubicBSpline) {
  using ApicFlat = Flat<TestType>;
  check_angular_momentum(ApicFlat(flat_grid()));
  check_angular_momentum(InSpace<TestType>(solid_grid()));
  check_angular_momentum(ApicFlat(CartesianGrid<2>({.lower = {0, 0}, .upper = {2, 1}, .cell = 1})));
  check_angular_momentum(ApicFlat(CartesianGrid<2>({.lower = {-3, 5}, .upper = {-2, 6}, .cell = 1}), 8));
}

TEMPLATE_TEST_CASE("APIC: points on a face and at a corner pass on what they have, finite and conserved", "",
                   LinearGrid, QuadraticBSpline, CubicBSpline) {
  using ApicFlat = Flat<TestType>;
  ApicFlat s(flat_grid());
  for (const Vec<double, 2>& x :
       {Vec<double, 2>(0, 0.3), Vec<double, 2>(0.6, 1), Vec<double, 2>(0, 0), Vec<double, 2>(1.25, 1)})
    s.add(x, s.mesh.walk(x));
  s.index();
  s.p2g();
  s.update_grid();
  s.gather();  // now the affine part of a point on a face has nothing across the face
  check_angular_momentum(s);
}

TEMPLATE_TEST_CASE("APIC: a point that comes close to a face passes on no more energy than it has", "",
                   LinearGrid, QuadraticBSpline, CubicBSpline) {
  using ApicFlat = Flat<TestType>;
  ApicFlat s(CartesianGrid<2>({.lower = {0, 0}, .upper = {3, 3}, .cell = 1}), 0);
  s.add({0.4, 1.5}, s.mesh.walk({0.4, 1.5}));
  s.index();
  s.set_affine({-1, 0}, Mat<double, 2>::Identity());
  s.p2g();
  s.update_grid();
  s.gather();
  const double had = s.body.points.mass[0] * s.body.points.velocity[0].squaredNorm();
  for (const double x : {0.1, 1e-3, 1e-6, 1e-9}) {
    s.body.points.position.set(0, {x, 1.5});
    s.p2g();
    s.update_grid();
    if constexpr (has_light_nodes<TestType>) {
      list_massless(s.nodes, OwnsAll{});
      average_neighbours<TestType>(s.mesh, s.nodes, s.nodes.velocity, InPlace{s.nodes.velocity});
    }
    double has = 0;
    Vec<double, 2> handed = s.node_momentum();
    for (const Index i : s.nodes.massless) handed += s.nodes.sums[i].mass() * s.nodes.velocity[i];
    for (Index i = 0; i < s.nodes.size(); ++i) has += s.nodes.mass[i] * s.nodes.velocity[i].squaredNorm();
    CAPTURE(x, had, has);
    REQUIRE(has <= 2 * had);  // its own, and that of a gradient of 1/s over half a cell
    REQUIRE((handed - s.point_momentum()).norm() <= 1e-14);
  }
}

TEST_CASE("APIC and TPIC keep rotations and all affine fields") {
  const auto on_grids = [](auto shape) {
    using Shape = decltype(shape);
    check_affine_field(Flat<Shape>(flat_grid(), 5));
    check_affine_field(InSpace<Shape>(solid_grid(), 4));
    check_affine_field(Flat<Shape>(CartesianGrid<2>({.lower = {0, 0}, .upper = {1, 2}, .cell = 1}), 5));
  };
  on_grids(LinearGrid{});
  on_grids(QuadraticBSpline{});
  on_grids(CubicBSpline{});
  check_affine_field(
      Setup<PlaneStrain, Numerics<LinearSimplex, Tpic, Usl>, SimplexMesh<2>>(sample_mesh<2>(4)));
  check_affine_field(
      Setup<ThreeDimensional, Numerics<LinearSimplex, Tpic, Usl>, SimplexMesh<3>>(sample_mesh<3>(2)));
}

TEST_CASE("PIC loses angular momentum: the test sees it") {
  Setup<PlaneStrain, Numerics<QuadraticBSpline, Flip, Usl>, CartesianGrid<2>> s(flat_grid());
  s.numerics.transfer.fraction = 0;
  Mat<double, 2> spin;
  spin << 0, -3, 3, 0;
  s.set_affine({0, 0}, spin);
  const auto orbital = [&] {
    double sum = 0;
    for (std::size_t p = 0; p < s.body.points.size(); ++p)
      sum += s.body.points.mass[p] * moment(s.body.points.position[p], s.body.points.velocity[p])[2];
    return sum;
  };
  const double before = orbital();
  s.p2g();
  s.update_grid();
  s.gather();
  REQUIRE(orbital() < 0.99 * before);
}
