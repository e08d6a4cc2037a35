// Impulses between rigid bodies: the mobilities that they are found with, and contacts that have no solution.
#include <Eigen/Eigenvalues>
#include <arenite/arenite.hpp>
#include <random>

#include "catch.hpp"

using namespace arenite;
using V2 = Vec<double, 2>;

TEST_CASE("However material resists a body, no impulse on it gains energy") {
  const Friction smooth(0.0);
  const LinearElastic rubber{{.density = 1000, .young = 1e5, .poisson = 0.2}};
  Scene scene{PlaneStrain{}, CartesianGrid<2>{{.lower = {-20, -20}, .upper = {-19, -19}, .cell = 0.5}},
              Numerics<QuadraticBSpline, Flip, Usl>{},
              bodies(fill(Box{{-20., -20.}, {-19., -19.5}}, rubber, {.per_cell = 4})),
              rigid(DistanceSurface{Ball({0., 0.}, 0.5)},
                    Free{.mass = 1, .inertia = 0.1, .centre = {0, 0, 0}}, smooth)};
  step(scene, 1e-3);
  auto& body = scene.rigid();
  std::mt19937 random(7);
  std::uniform_real_distribution<double> any(-1, 1);
  const auto vector = [&] { return V2(any(random), any(random)); };
  int coupled = 0, gaining = 0;
  for (int k = 0; k < 2000; ++k) {
    body.friction = Friction(0.75 + 0.75 * any(random));
    body.touched_nodes.clear();
    for (Index n = 0; n < 4; ++n) {
      const double mass = std::pow(10, 3 * any(random));
      body.touched_nodes.push_back({0, n, false, mass, 1, vector(), vector().normalized()});
      body.touched_nodes.back().arm = vector();
    }
    const Vec<double, 3> met(any(random), any(random), any(random));
    const Mat<double, 3> exact = mobility_of(body, detail::resistance_of_matter(body, met, true, serial));
    const Mat<double, 3> mobility = detail::mobility_in_matter(body, met, serial);
    const auto least = [](const Mat<double, 3>& of) {
      return Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(of + of.transpose()).eigenvalues()[0];
    };
    REQUIRE(least(mobility) >= -1e-12 * mobility.norm());
    coupled += least(exact) > 0 && mobility == exact;
    gaining += least(exact) < -1e-6 * exact.norm();
  }
  // Both kinds occur.
  CHECK(coupled >= 200);
  CHECK(gaining >= 200);
}

TEST_CASE("Contacts that no velocities satisfy get impulses of the bodies' size") {
  ContactSolver<2> solver;
  ContactSolver<2>::Rows rows(2);
  // One body between two faces of another that both push it away from themselves.
  for (const int side : {0, 1}) {
    auto& row = rows[static_cast<std::size_t>(side)];
    row.body[0] = 0;
    row.body[1] = 1;
    row.friction = 0.5;
    row.least = 1;
    row.response.setZero();
    const double sign = side == 0 ? 1 : -1;
    for (const int body : {0, 1}) {
      row.to[body].setZero();
      row.to[body](0, 0) = row.to[body](1, 1) = body == 0 ? sign : -sign;
      row.by[body] = row.to[body].transpose();  // unit masses
      row.response += row.to[body] * row.by[body];
    }
  }
  ContactSolver<2>::Twists twists(2, Vec<double, 3>::Zero());
  CHECK(solver.solve(rows, twists, 1) > 0.1);
  Vec<double, 3> given = Vec<double, 3>::Zero();
  for (const auto& row : rows) {
    CHECK(row.impulse.norm() <= 1e4);
    given += row.by[0] * row.impulse;
  }
  CHECK((twists[0] - given).norm() <= 1e-10);
}
