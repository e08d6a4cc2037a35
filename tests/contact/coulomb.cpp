// Coulomb's law at a node, in closed form.
#include "catch.hpp"

#include <Eigen/Geometry>
#include <arenite/contact/coulomb.hpp>

#include "../mesh/sample_meshes.hpp"

using namespace arenite;
using namespace arenite::test;

namespace {
const Vec<double, 2> up(0, 1);
}

TEST_CASE("bodies that part exchange nothing") {
  const Friction f(0.5);
  REQUIRE(coulomb<double, 2>({3, 0.1}, up, 2, f).impulse.norm() == 0);
  REQUIRE(coulomb<double, 2>({3, 0}, up, 2, f).impulse.norm() == 0);
  REQUIRE(coulomb<double, 2>({3, 0.1}, up, 2, Friction::no_slip()).impulse.norm() == 0);
}

TEST_CASE("below the friction angle they stick, above it they slip") {
  const Friction f(30 * pi / 180);
  const double mu = 1 / std::sqrt(3.0);
  REQUIRE(std::abs(f.coefficient() - mu) < 1e-15);
  // Closing with 2, sliding with 1 < 2 mu: all of the relative velocity goes.
  REQUIRE((coulomb<double, 2>({1, -2}, up, 3, f).impulse - Vec<double, 2>(-3, 6)).norm() < 1e-15);
  // Sliding with 5 > 2 mu: the normal impulse is 6, the tangential one 6 mu.
  REQUIRE((coulomb<double, 2>({5, -2}, up, 3, f).impulse - Vec<double, 2>(-6 * mu, 6)).norm() < 1e-14);
  REQUIRE((coulomb<double, 2>({-5, -2}, up, 3, f).impulse - Vec<double, 2>(6 * mu, 6)).norm() < 1e-14);
  // The change from one to the other has no jump.
  const auto just_below = coulomb<double, 2>({2 * mu - 1e-9, -2}, up, 3, f).impulse,
             just_above = coulomb<double, 2>({2 * mu + 1e-9, -2}, up, 3, f).impulse;
  REQUIRE((just_below - just_above).norm() < 1e-8);
}

TEST_CASE("no friction, and no slip at all") {
  REQUIRE(
      (coulomb<double, 2>({5, -2}, up, 3, Friction::frictionless()).impulse - Vec<double, 2>(0, 6)).norm() <
      1e-15);
  REQUIRE((coulomb<double, 2>({5, -1e-6}, up, 3, Friction::no_slip()).impulse - Vec<double, 2>(-15, 3e-6))
              .norm() < 1e-15);
  REQUIRE(
      (coulomb<double, 2>({0, -2}, up, 3, Friction::frictionless()).impulse - Vec<double, 2>(0, 6)).norm() <
      1e-15);
}

TEST_CASE("in three dimensions slip is stopped against its direction, and energy never grows") {
  std::mt19937 random(1);
  std::normal_distribution<double> normal;
  for (int i = 0; i < 1000; ++i) {
    const Vec<double, 3> v(normal(random), normal(random), normal(random));
    const Vec<double, 3> n = Vec<double, 3>(normal(random), normal(random), normal(random)).normalized();
    const double mu = 0.4, m = 2;
    const Vec<double, 3> j = coulomb<double, 3>(v, n, m, Friction(std::atan(mu))).impulse;
    const Vec<double, 3> after = v + j / m;
    if (v.dot(n) >= 0) {
      REQUIRE(j.norm() == 0);
      continue;
    }
    REQUIRE(std::abs(after.dot(n)) < 1e-15);
    const Vec<double, 3> slip = v - v.dot(n) * n, slip_after = after - after.dot(n) * n,
                         drag = j - j.dot(n) * n;
    REQUIRE(drag.norm() <= mu * j.dot(n) * (1 + 1e-14));
    REQUIRE(slip.cross(slip_after).norm() < 1e-14);
    REQUIRE(slip_after.dot(slip) >= -1e-15);
    REQUIRE(after.norm() <= v.norm() * (1 + 1e-15));
  }
}

TEST_CASE("friction angles outside [0, pi/2) are refused") {
  for (const double angle : {-0.1, pi / 2, 40.0, std::nan("")})
    REQUIRE(throws([&] { Friction f(angle); }, "must lie in [0, pi/2) rad"));
  REQUIRE(Friction::no_slip().is_no_slip());
  REQUIRE_FALSE(Friction(1.5).is_no_slip());
}

TEST_CASE("a limit of shear: the lesser of friction and limit, and the normal impulse whatever it is") {
  const double mu = std::tan(0.4), m = 3;
  for (const auto& friction : {Friction(0.4), Friction::no_slip()})
    for (const double shear : {0.0, 1.0, 5.0, 100.0}) {
      const auto given = coulomb<double, 2>({5, -2}, up, m, friction, shear);
      const double most = std::min({friction.coefficient() * 2 * m, shear, 5 * m});
      CHECK((given.impulse - Vec<double, 2>(-most, 2 * m)).norm() < 1e-14);
      CHECK(given.sticks == (most == 5 * m));
    }
  CHECK(coulomb<double, 2>({5, -2}, up, m, Friction(0.4), 1e3).impulse[0] == Approx(-mu * 2 * m));
  CHECK(coulomb<double, 2>({5, 2}, up, m, Friction::no_slip(), 1).impulse.norm() == 0);
}
