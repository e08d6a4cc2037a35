// Returns of Mohr-Coulomb against an independent solution by trying all sets of active planes, and their
// error over a step.
#include <Eigen/LU>
#include <bit>
#include <vector>

#include "catch.hpp"
#include "mohr_coulomb_sets.hpp"
#include "states.hpp"

using namespace arenite;
using namespace arenite::test;

namespace {

/// `parameter_sets` with a tension cut-off where one can act.
std::vector<MohrCoulombParameters> cut_sets() {
  std::vector<MohrCoulombParameters> sets;
  for (auto p : parameter_sets()) {
    if (p.cohesion == 0) continue;
    for (const double tension : {0.0, 0.5e3}) {
      p.tension = tension;
      sets.push_back(p);
    }
  }
  return sets;
}

double apex_of(const MohrCoulombParameters& p) { return detail::apex(p.friction, p.cohesion); }

/// Greatest violation, Pa, over the six planes and the cut-off, of principal values in any order.
double violation(const MohrCoulombParameters& p, const Eigen::Vector3d& s) {
  double worst = s.maxCoeff() - p.tension;
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j)
      if (i != j)
        worst = std::max(worst, (s(i) - s(j)) / 2 + (s(i) + s(j)) / 2 * std::sin(p.friction) -
                                    p.cohesion * std::cos(p.friction));
  return worst;
}

/// Return of principal values by Koiter's rule over the six planes and the three of the cut-off: the set of
/// active planes whose multipliers are all positive and whose result is admissible. `opening`: the volumetric
/// strain of the cut-off's flow. `found` is false where there is no such set: then no flow leads to the
/// surface (apex).
Eigen::Vector3d koiter_return(const MohrCoulombParameters& p, const Eigen::Vector3d& s, double& opening,
                              bool& found) {
  struct Plane {
    Eigen::Vector3d normal, flow;
    double strength;
  };
  std::vector<Plane> planes;
  const double sin = std::sin(p.friction), sin_flow = std::sin(p.dilatancy);
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j)
      if (i != j) {
        Plane plane{Eigen::Vector3d::Zero(), Eigen::Vector3d::Zero(), 2 * p.cohesion * std::cos(p.friction)};
        plane.normal(i) = 1 + sin;
        plane.normal(j) = -(1 - sin);
        plane.flow(i) = 1 + sin_flow;
        plane.flow(j) = -(1 - sin_flow);
        planes.push_back(plane);
      }
  if (p.tension < apex_of(p))
    for (int i = 0; i < 3; ++i)
      planes.push_back({Eigen::Vector3d::Unit(i), Eigen::Vector3d::Unit(i), p.tension});
  const int all = static_cast<int>(planes.size());
  const Elasticity e("test", p.density, p.young, p.poisson);
  const Eigen::Matrix3d stiffness =
      Eigen::Matrix3d::Constant(e.lame()) + 2 * e.shear() * Eigen::Matrix3d::Identity();
  const double size = s.cwiseAbs().maxCoeff() + p.cohesion, tolerance = 1e-11 * size;
  for (int count = 0; count <= 3; ++count) {
    for (int set = 0; set < 1 << all; ++set) {
      if (std::popcount(static_cast<unsigned>(set)) != count) continue;
      // Rows of planes that are not active stay empty; their multipliers are 0.
      Eigen::Matrix3d a = Eigen::Matrix3d::Zero(), b = Eigen::Matrix3d::Zero();
      Eigen::Vector3d limit = Eigen::Vector3d::Zero(), opens = Eigen::Vector3d::Zero();
      for (int i = 0, row = 0; i < all; ++i)
        if ((set >> i) & 1) {
          const auto& plane = planes[static_cast<std::size_t>(i)];
          a.row(row) = plane.normal.transpose();
          b.col(row) = plane.flow;
          opens(row) = i < 6 ? 0 : 1;
          limit(row++) = plane.strength;
        }
      Eigen::Matrix3d matrix = a * stiffness * b / e.shear();
      const Eigen::Vector3d excess = a * s - limit;
      for (int i = count; i < 3; ++i) matrix(i, i) = 1;
      const Eigen::FullPivLU<Eigen::Matrix3d> lu(matrix);
      if (!lu.isInvertible()) continue;
      const Eigen::Vector3d multiplier = lu.solve(excess) / e.shear();
      if (multiplier.minCoeff() * e.shear() < -tolerance) continue;
      const Eigen::Vector3d y = s - stiffness * b * multiplier;
      if (violation(p, y) <= tolerance) {
        found = true;
        opening = opens.dot(multiplier);
        return y;
      }
    }
  }
  found = false;
  return s;
}

template <int D>
void check_returns(const MohrCoulombParameters& p, int states) {
  const MohrCoulomb law{p};
  std::mt19937 random(17);
  for (int trial = 0; trial < states; ++trial) {
    const auto before = trial_state<D>(random, apex_of(p));
    auto after = before;
    NoHistory<double> history;
    const double opened = law.update(after, StrainStep<double, D>{}, history).opening;
    const Eigen::Vector3d y = principal_values(after);
    const double size = y.cwiseAbs().maxCoeff() + p.cohesion, trial_size = full(before).norm();

    REQUIRE(violation(p, y) <= 1e-10 * size + 1e-15 * trial_size);
    REQUIRE(law.yield(after) <= 1e-10 + 1e-15 * trial_size / (size + 1e-300));
    REQUIRE(opened >= -1e-15 * trial_size / p.young);
    if (violation(p, principal_values(before)) < 0) {
      REQUIRE(after.c == before.c);
      REQUIRE(opened == 0);
      REQUIRE(law.yield(before) < 0);
    } else {
      REQUIRE(law.yield(before) >= -1e-13);
    }
    const Eigen::Matrix3d plastic = strain_of(law.elasticity(), full(before) - full(after));
    const double dissipation = (full(after) * plastic).trace();
    REQUIRE(dissipation >= -1e-13 * trial_size * trial_size / p.young);
    REQUIRE(opened <=
            plastic.trace() + 1e-13 * trial_size / p.young);  // the rest is dilatancy: never negative
    // The axes are those of the trial state.
    REQUIRE((full(before) * full(after) - full(after) * full(before)).norm() <=
            1e-12 * trial_size * trial_size);
    // A second return changes nothing.
    auto again = after;
    REQUIRE(std::abs(law.surface().return_to_yield(again).opening) <= 1e-14 * trial_size / p.young);
    REQUIRE((full(again) - full(after)).norm() <= 1e-13 * size + 1e-15 * trial_size);
  }
}

}  // namespace

TEST_CASE("random states come back to the yield surface, and dissipate") {
  for (const auto& p : parameter_sets()) {
    check_returns<2>(p, 10000);
    check_returns<3>(p, 10000);
  }
  for (const auto& p : cut_sets()) {
    check_returns<2>(p, 3000);
    check_returns<3>(p, 3000);
  }
}

TEST_CASE("returns are those of Koiter's rule over all sets of planes") {
  int apex = 0, edge = 0, plane = 0;
  for (const auto& p : parameter_sets()) {
    const MohrCoulomb law{p};
    std::mt19937 random(23);
    for (int trial = 0; trial < 1500; ++trial) {
      const auto before = trial_state<3>(random, apex_of(p));
      auto after = before;
      const double opened = law.surface().return_to_yield(after).opening;
      const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> axes(full(before));
      bool found = false;
      double opening = 0;
      Eigen::Vector3d y = koiter_return(p, axes.eigenvalues(), opening, found);
      if (!found) {
        REQUIRE(p.dilatancy ==
                0);  // only without dilatancy is there a trial state that no plane's flow brings back
        y.setConstant(apex_of(p));
      }
      const Eigen::Matrix3d expected = axes.eigenvectors() * y.asDiagonal() * axes.eigenvectors().transpose();
      const double size = full(before).norm();
      REQUIRE((full(after) - expected).norm() <= 1e-9 * size + 1e-9 * p.cohesion);
      const double gap = y.maxCoeff() - y.minCoeff(), fell = (axes.eigenvalues() - y).norm();
      if (fell > 1e-6 * size) {
        if (gap <= 1e-9 * size) {
          ++apex;
          const double volume = (axes.eigenvalues().sum() - 3 * apex_of(p)) / (3 * law.elasticity().bulk());
          REQUIRE(std::abs(opened - volume) <= 1e-9 * size / p.young);
        } else {
          REQUIRE(std::abs(opened) <= 1e-12 * size / p.young);
          const bool on_edge = std::min(y(1) - y(0), y(2) - y(1)) <= 1e-9 * size;
          ++(on_edge ? edge : plane);
        }
      }
    }
  }
  REQUIRE(apex > 500);
  REQUIRE(edge > 500);
  REQUIRE(plane > 500);
}

TEST_CASE("associated flow goes to the closest point in the energy norm") {
  const MohrCoulombParameters p{
      .density = 1, .young = 5e6, .poisson = 0.3, .friction = 33_deg, .cohesion = 2e3, .dilatancy = 33_deg};
  const MohrCoulomb law{p};
  std::mt19937 random(29);
  std::normal_distribution<double> normal;
  for (int trial = 0; trial < 500; ++trial) {
    const auto before = trial_state<3>(random, apex_of(p));
    auto after = before;
    law.surface().return_to_yield(after);
    const auto distance = [&](const Sym<double, 3>& s) { return law.elastic_energy(s - before); };
    const double best = distance(after);
    for (int i = 0; i < 200; ++i) {  // no admissible state nearby or far is closer
      Sym<double, 3> other = after;
      const double size = full(before).norm() * std::pow(10, -double(i % 6));
      for (double& c : other.c) c += size * normal(random);
      if (violation(p, principal_values(other)) <= 0) REQUIRE(distance(other) >= best * (1 - 1e-9));
    }
  }
}

TEST_CASE("with a cut-off returns are those of Koiter's rule over the planes of both") {
  int cut = 0, both = 0;
  auto sets = cut_sets();
  for (const double friction : {20_deg, 70_deg})
    for (const double poisson : {-0.8, 0.499})
      sets.push_back({.density = 1,
                      .young = 5e6,
                      .poisson = poisson,
                      .friction = friction,
                      .cohesion = 2e3,
                      .dilatancy = friction / 3,
                      .tension = 0.3e3});
  for (const auto& p : sets) {
    const MohrCoulomb law{p};
    std::mt19937 random(47);
    std::uniform_real_distribution<double> uniform(-1, 1);
    for (int trial = 0; trial < 500; ++trial) {
      auto before = trial_state<3>(random, p.tension);
      if (trial % 2 == 0) {  // pulled and pressed at once
        const Eigen::Vector3d v(std::abs(uniform(random)), uniform(random), -std::abs(uniform(random)));
        const Eigen::Matrix3d r = rotation<3>(random);
        before = symmetric<3>(r * (v * std::pow(10, 4 + uniform(random))).asDiagonal() * r.transpose());
      }
      auto after = before;
      const double opened = law.surface().return_to_yield(after).opening;
      const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> axes(full(before));
      bool found = false;
      double opening = 0;
      const Eigen::Vector3d y = koiter_return(p, axes.eigenvalues(), opening, found);
      REQUIRE(found);
      const Eigen::Matrix3d expected = axes.eigenvectors() * y.asDiagonal() * axes.eigenvectors().transpose();
      const double size = full(before).norm() + p.cohesion;
      REQUIRE((full(after) - expected).norm() <= 1e-9 * size);
      REQUIRE(std::abs(opened - opening) <= 1e-9 * size / p.young);
      REQUIRE(opened >= 0);
      const double slope = (1 + std::sin(p.friction)) / (1 - std::sin(p.friction));
      const double corner = slope * p.tension - 2 * p.cohesion * std::sqrt(slope);
      if (opening > 1e-9 * size / p.young) ++(std::abs(y(0) - corner) <= 1e-9 * size ? both : cut);
    }
  }
  REQUIRE(cut > 500);
  REQUIRE(both > 300);
}

TEMPLATE_TEST_CASE("with a cut-off one large step ends near where many small ones end", "", double, float) {
  // Elastic up to 10 times the strain at yield, and far beyond it: a step of first order, as without a
  // cut-off.
  const MohrCoulomb law{{.density = 1,
                         .young = 5e6,
                         .poisson = 0.3,
                         .friction = 30_deg,
                         .cohesion = 5e3,
                         .dilatancy = 10_deg,
                         .tension = 1e3}};
  std::mt19937 random(53);
  std::uniform_real_distribution<double> uniform(-1, 1);
  const auto end = [&](const Sym<TestType, 3>& start, const Sym<TestType, 3>& strain, int steps) {
    auto stress = start;
    NoHistory<TestType> history;
    for (int k = 0; k < steps; ++k)
      law.update(stress, {strain * static_cast<TestType>(1.0 / steps), {}}, history);
    return stress;
  };
  double mean = 0, worst = 0, mean_of_ten = 0;
  const int states = 500;
  for (int k = 0; k < states; ++k) {
    Sym<TestType, 3> start, strain;
    for (std::size_t i = 0; i < 3; ++i) start[i] = static_cast<TestType>(-1e4 * std::abs(uniform(random)));
    law.surface().return_to_yield(start);
    const double size = std::pow(10, uniform(random) - 3);
    for (auto& c : strain.c) c = static_cast<TestType>(size * uniform(random));
    const auto exact = end(start, strain, 500);
    const auto off = [&](int steps) {
      const auto trial = start + law.elasticity().stress(strain), miss = end(start, strain, steps) - exact;
      return static_cast<double>(std::sqrt(contract(miss, miss) / contract(trial, trial)));
    };
    const double one = off(1);
    mean += one / states;
    worst = std::max(worst, one);
    mean_of_ten += off(10) / states;
  }
  CAPTURE(mean, worst, mean_of_ten);
  REQUIRE(mean <= 0.015);
  REQUIRE(worst <= 0.25);
  REQUIRE(mean_of_ten <= 0.003);
}
