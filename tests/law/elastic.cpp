// Linear elasticity and the Jaumann rate against closed forms.
#include <arenite/core/units.hpp>
#include <arenite/law/linear_elastic.hpp>
#include <string>

#include "catch.hpp"
#include "states.hpp"

using namespace arenite;
using namespace arenite::test;

namespace {
const LinearElastic steel{{.density = 7850, .young = 200e9, .poisson = 0.3}};

std::string message(const LinearElasticParameters& p) {
  try {
    LinearElastic law(p);
  } catch (const error& e) {
    return e.what();
  }
  return "";
}
}  // namespace

TEST_CASE("uniaxial stress: Young's modulus and Poisson's ratio") {
  Sym<double, 3> stress;
  StrainStep<double, 3> pull;
  pull.strain = {{1e-3, -0.3e-3, -0.3e-3, 0, 0, 0}};
  NoHistory<double> history;
  REQUIRE(steel.update(stress, pull, history) == 0);
  REQUIRE(std::abs(stress[0] - 200e6) <= 1e-6);
  for (std::size_t i = 1; i < 6; ++i) REQUIRE(std::abs(stress[i]) <= 1e-6);
  REQUIRE(std::abs(steel.elastic_energy(stress) - 0.5 * 200e6 * 1e-3) <= 1e-8);
  REQUIRE(std::abs(steel.wave_modulus() - 200e9 * 0.7 / (1.3 * 0.4)) <= 1e-3);
}

TEST_CASE("the energy is the work done on a path") {
  std::mt19937 random(1);
  std::normal_distribution<double> normal(0, 1e-4);
  Sym<double, 3> stress;
  NoHistory<double> history;
  double work = 0;
  for (int i = 0; i < 100; ++i) {
    StrainStep<double, 3> strain_step;
    for (double& c : strain_step.strain.c) c = normal(random);
    const auto before = stress;
    steel.update(stress, strain_step, history);
    work += 0.5 * contract(before + stress, strain_step.strain);
  }
  REQUIRE(std::abs(work - steel.elastic_energy(stress)) <= 1e-12 * work);
}

TEST_CASE("simple shear with the Jaumann rate: tau = G sin(gamma), sigma = G (1 - cos(gamma))") {
  const double shear = steel.elasticity().shear();
  double last = 0;
  for (const int steps : {1000, 2000}) {
    Sym<double, 2> plane;
    Sym<double, 3> solid;
    NoHistory<double> history;
    const double d = 4.0 / steps;  // to gamma = 4, far beyond the maximum at pi/2
    for (int i = 0; i < steps; ++i) {
      StrainStep<double, 2> a;
      a.strain[3] = d / 2;
      a.spin = {d / 2};
      steel.update(plane, a, history);
      StrainStep<double, 3> b;
      b.strain[4] = d / 2;  // the same in the plane of y and z
      b.spin = {0, d / 2, 0};
      steel.update(solid, b, history);
    }
    const double error = std::hypot(plane[3] / shear - std::sin(4.0), plane[0] / shear - (1 - std::cos(4.0)));
    REQUIRE(error <= 3 * d);
    if (last > 0) REQUIRE(std::abs(error / last - 0.5) <= 0.02);  // of first order
    last = error;
    REQUIRE(std::abs(plane[0] + plane[1]) <= 1e-9 * shear);
    REQUIRE(std::abs(solid[4] - plane[3]) <= 1e-9 * shear);
    REQUIRE(std::abs(solid[1] - plane[0]) <= 1e-9 * shear);
    REQUIRE(std::abs(solid[2] - plane[1]) <= 1e-9 * shear);
    REQUIRE(std::abs(solid[0]) <= 1e-9 * shear);
  }
}

TEST_CASE("a turn of any size is a rotation: it follows a rigid one and keeps the invariants") {
  std::mt19937 random(2);
  std::normal_distribution<double> normal;
  for (int trial = 0; trial < 500; ++trial) {
    const auto s = trial_state<3>(random, 0);
    const Eigen::Vector3d axial =
        Eigen::Vector3d(normal(random), normal(random), normal(random)) * std::pow(10, normal(random));
    // The midpoint form turns by 2 atan(w/2) about the axial vector of W, W_ij = -e_ijk w_k.
    const Eigen::Matrix3d r =
        Eigen::AngleAxisd(2 * std::atan(axial.norm() / 2), axial.normalized()).toRotationMatrix();
    const auto b = turned(s, std::array<double, 3>{-axial.z(), -axial.x(), -axial.y()});
    const double size = full(s).norm();
    REQUIRE((full(b) - r * full(s) * r.transpose()).norm() <= 1e-14 * size);

    const auto plane = trial_state<2>(random, 0);
    const auto c = turned(plane, std::array<double, 1>{-axial.z()});
    const Eigen::Matrix3d rz =
        Eigen::AngleAxisd(2 * std::atan(axial.z() / 2), Eigen::Vector3d::UnitZ()).toRotationMatrix();
    REQUIRE((full(c) - rz * full(plane) * rz.transpose()).norm() <= 1e-14 * full(plane).norm());
  }
}

TEST_CASE("objectivity: stretched in a turning frame, the stress turns with it") {
  // The frame turns by w a step about an axis; the same strains are applied in it. Order one in w, so that w
  // is small.
  std::mt19937 random(3);
  std::normal_distribution<double> normal(0, 1e-5);
  const double w = 1e-6;
  const Eigen::Vector3d axis = Eigen::Vector3d(1, 2, -0.5).normalized();
  const double angle = 2 * std::atan(w / 2);  // of one midpoint step
  Sym<double, 3> still, turning;
  NoHistory<double> history;
  for (int i = 1; i <= 2000; ++i) {
    StrainStep<double, 3> a, b;
    for (double& c : a.strain.c) c = normal(random);
    const Eigen::Matrix3d r = Eigen::AngleAxisd(i * angle, axis).toRotationMatrix();
    b.strain = symmetric<3>(r * full(a.strain) * r.transpose());
    b.spin = {-w * axis.z(), -w * axis.x(), -w * axis.y()};
    steel.update(still, a, history);
    steel.update(turning, b, history);
  }
  const Eigen::Matrix3d r = Eigen::AngleAxisd(2000 * angle, axis).toRotationMatrix();
  REQUIRE((full(turning) - r * full(still) * r.transpose()).norm() <= 1e-12 * full(still).norm());
}

TEST_CASE("bad constants of elastic laws are named with their rule") {
  REQUIRE(message({.density = 1, .young = 1, .poisson = 0.6}) ==
          "LinearElastic.poisson = 0.6: must lie in (-1, 0.5)");
  REQUIRE(message({.density = 1, .young = 1, .poisson = -1}) ==
          "LinearElastic.poisson = -1: must lie in (-1, 0.5)");
  REQUIRE(message({.density = 1, .young = 1}) == "LinearElastic.poisson = nan: must be given");
  REQUIRE(message({.young = 1, .poisson = 0}) == "LinearElastic.density = nan: must be given");
  REQUIRE(message({.density = 1, .young = -5, .poisson = 0}) ==
          "LinearElastic.young = -5: must be positive (Pa)");
  REQUIRE(message({.density = 1, .young = 1, .poisson = 0.49}).empty());
}
