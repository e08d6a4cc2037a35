// Principal values against their definition and against Eigen's solver, where the axes are anything and the
// values nearly or exactly equal.
#include <Eigen/Eigenvalues>
#include <arenite/core/principal.hpp>
#include <arenite/simd/pack.hpp>
#include <cmath>
#include <random>

#include "catch.hpp"

using namespace arenite;

namespace {

template <int D>
Eigen::Matrix3d full(const Sym<double, D>& s) {
  Eigen::Matrix3d m;
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) m(i, j) = s(i, j);
  return m;
}

template <int D>
Sym<double, D> symmetric(const Eigen::Matrix3d& m) {
  if constexpr (D == 2)
    return {{m(0, 0), m(1, 1), m(2, 2), m(0, 1)}};
  else
    return {{m(0, 0), m(1, 1), m(2, 2), m(0, 1), m(1, 2), m(2, 0)}};
}

/// A rotation about any axis (D = 3) or about z (D = 2).
template <int D>
Eigen::Matrix3d rotation(std::mt19937& random) {
  std::normal_distribution<double> normal;
  if constexpr (D == 2)
    return Eigen::AngleAxisd(normal(random), Eigen::Vector3d::UnitZ()).toRotationMatrix();
  else
    return Eigen::Quaterniond(normal(random), normal(random), normal(random), normal(random))
        .normalized()
        .toRotationMatrix();
}

/// Values with gaps of all sizes, equal ones included, in any order, around a mean of any size.
Eigen::Vector3d values(std::mt19937& random) {
  std::uniform_real_distribution<double> uniform(-1, 1), exponent(-17, 0);
  const double mean = uniform(random) * std::pow(10, 2 + exponent(random) / 6);
  const auto gap = [&] { return random() % 5 == 0 ? 0.0 : std::pow(10, exponent(random)); };
  Eigen::Vector3d v(mean, mean + gap(), 0);
  v(2) = v(1) + gap();
  std::shuffle(v.data(), v.data() + 3, random);
  return v;
}

template <int D>
void check_values_and_return() {
  std::mt19937 random(11);
  for (int trial = 0; trial < 10000; ++trial) {
    const Eigen::Matrix3d r = rotation<D>(random);
    const Eigen::Vector3d v = values(random);
    const Sym<double, D> s = symmetric<D>(r * v.asDiagonal() * r.transpose());
    const Principal<double, D> p(s);
    const double size = v.cwiseAbs().maxCoeff(), tolerance = 2e-14 * size;

    const Eigen::Vector3d reference = Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(full(s)).eigenvalues();
    for (int i = 0; i < 3; ++i)
      REQUIRE(std::abs(p.value[static_cast<std::size_t>(i)] - reference(2 - i)) <= tolerance);
    REQUIRE((p.value[0] >= p.value[1] && p.value[1] >= p.value[2]));

    // With its own values it is itself, to round-off even where values are nearly equal.
    REQUIRE((full(p.with(p.value)) - full(s)).cwiseAbs().maxCoeff() <= tolerance);

    // An isotropic function: smooth, and not of the tensor's own form.
    const auto f = [&](double x) { return std::sin(x / size) * size; };
    Eigen::Vector3d fv(f(v(0)), f(v(1)), f(v(2)));
    const Eigen::Matrix3d exact = r * fv.asDiagonal() * r.transpose();
    const Sym<double, D> back = p.with({f(p.value[0]), f(p.value[1]), f(p.value[2])});
    REQUIRE((full(back) - exact).cwiseAbs().maxCoeff() <= 4 * tolerance);
  }
}

}  // namespace

TEST_CASE("largest root of 4 h^3 - 3 h = x") {
  for (int i = 0; i <= 1000; ++i) {
    const double x = i / 1000.0, exact = std::cos(std::acos(x) / 3);
    REQUIRE(std::abs(detail::largest_root(x) - exact) <= 5e-16);
    REQUIRE(std::abs(detail::largest_root(float(x)) - exact) <= 2e-7);
  }
}

TEST_CASE("principal values and the way back, plane") { check_values_and_return<2>(); }
TEST_CASE("principal values and the way back, solid") { check_values_and_return<3>(); }

TEST_CASE("a return that makes two values equal is exact where they were nearly so") {
  std::mt19937 random(5);
  for (int trial = 0; trial < 2000; ++trial) {
    const Eigen::Matrix3d r = rotation<3>(random);
    const double gap = std::pow(10, -double(trial % 18));
    for (const bool top : {true, false}) {
      const Eigen::Vector3d v = top ? Eigen::Vector3d(1 + gap, 1, -2) : Eigen::Vector3d(2, -1, -1 - gap);
      const Principal<double, 3> p(symmetric<3>(r * v.asDiagonal() * r.transpose()));
      const std::array<double, 3> y =
          top ? std::array<double, 3>{1, 1, -3} : std::array<double, 3>{1, -2, -2};
      const Eigen::Matrix3d exact = r * Eigen::Vector3d(y[0], y[1], y[2]).asDiagonal() * r.transpose();
      REQUIRE((full(p.with(y)) - exact).cwiseAbs().maxCoeff() <= 1e-14);
    }
  }
}

TEST_CASE("nothing and pure pressure have no axes and make no NaN") {
  for (const double pressure : {0.0, 1.0, -3e7, 1e-200}) {
    const Principal<double, 3> solid(Sym<double, 3>{{pressure, pressure, pressure, 0, 0, 0}});
    const Principal<double, 2> plane(Sym<double, 2>{{pressure, pressure, pressure, 0}});
    for (std::size_t i = 0; i < 3; ++i) {
      REQUIRE(std::abs(solid.value[i] - pressure) <= 1e-15 * std::abs(pressure));
      REQUIRE(plane.value[i] == pressure);
    }
    const auto a = solid.with({2, 2, 2});
    const auto b = plane.with({2, 2, 2});
    for (std::size_t i = 0; i < 6; ++i) REQUIRE(a[i] == (i < 3 ? 2 : 0));
    for (std::size_t i = 0; i < 4; ++i) REQUIRE(b[i] == (i < 3 ? 2 : 0));
  }
}

TEST_CASE("packs and floats find the same principal values") {
  std::mt19937 random(3);
  for (int trial = 0; trial < 500; ++trial) {
    Sym<Pack<double, 4>, 3> many;
    std::array<Sym<double, 3>, 4> single;
    for (int lane = 0; lane < 4; ++lane) {
      const Eigen::Matrix3d r = rotation<3>(random);
      auto& s = single[static_cast<std::size_t>(lane)];
      s = symmetric<3>(r * values(random).asDiagonal() * r.transpose());
      for (std::size_t i = 0; i < 6; ++i) many[i].set(lane, s[i]);
    }
    const Principal<Pack<double, 4>, 3> p(many);
    for (int lane = 0; lane < 4; ++lane) {
      const auto& s = single[static_cast<std::size_t>(lane)];
      const Principal<double, 3> q(s);
      Sym<float, 3> rough;
      for (std::size_t i = 0; i < 6; ++i) rough[i] = static_cast<float>(s[i]);
      const Principal<float, 3> f(rough);
      const double size = std::max(std::abs(q.value[0]), std::abs(q.value[2]));
      for (std::size_t i = 0; i < 3; ++i) {
        REQUIRE(std::abs(p.value[i][lane] - q.value[i]) <= 1e-14 * size);
        REQUIRE(std::abs(double(f.value[i]) - q.value[i]) <= 3e-6 * size);
      }
    }
  }
}
