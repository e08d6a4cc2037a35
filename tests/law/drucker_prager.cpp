// Drucker-Prager: its cones against Mohr-Coulomb's strengths, returns against closed forms and the energy
// norm.
#include <arenite/core/units.hpp>
#include <arenite/law/drucker_prager.hpp>
#include <string>
#include <vector>

#include "catch.hpp"
#include "states.hpp"

using namespace arenite;
using namespace arenite::test;

namespace {

std::vector<DruckerPragerParameters> parameter_sets() {
  std::vector<DruckerPragerParameters> sets;
  for (const Cone cone : {Cone::compression, Cone::extension, Cone::plane_strain}) {
    sets.push_back({.density = 1, .young = 5e6, .poisson = 0.33, .friction = 40_deg, .cone = cone});
    sets.push_back({.density = 1,
                    .young = 5e6,
                    .poisson = 0.2,
                    .friction = 30_deg,
                    .cohesion = 3e3,
                    .dilatancy = 30_deg,
                    .cone = cone});
    sets.push_back({.density = 1,
                    .young = 5e6,
                    .poisson = 0.45,
                    .friction = 25_deg,
                    .cohesion = 10e3,
                    .dilatancy = 5_deg,
                    .tension = 1e3,
                    .cone = cone});
    sets.push_back(
        {.density = 1, .young = 5e6, .poisson = -0.5, .friction = 0, .cohesion = 5e3, .cone = cone});
    sets.push_back(
        {.density = 1, .young = 5e6, .poisson = 0, .friction = 35_deg, .dilatancy = 20_deg, .cone = cone});
  }
  return sets;
}

struct Invariants {
  double p, q;
};
template <int D>
Invariants invariants(const Sym<double, D>& s) {
  const Eigen::Matrix3d m = full(s);
  const double p = m.trace() / 3;
  return {p, (m - p * Eigen::Matrix3d::Identity()).norm() / std::sqrt(2)};
}

template <int D>
void check_returns(const DruckerPragerParameters& p) {
  const DruckerPrager law{p};
  const double apex = detail::apex(p.friction, p.cohesion), limit = std::min(p.tension, apex);
  std::mt19937 random(31);
  for (int trial = 0; trial < 10000; ++trial) {
    const auto before = trial_state<D>(random, apex);
    auto after = before;
    NoHistory<double> history;
    const double opened = law.update(after, StrainStep<double, D>{}, history).opening;
    const auto [p0, q0] = invariants(before);
    const auto [p1, q1] = invariants(after);
    const double size = q1 + std::abs(p1) + p.cohesion, trial_size = full(before).norm();
    const double violation = std::max(q1 + law.surface().slope() * p1 - law.surface().strength(), p1 - limit);
    REQUIRE(violation <= 1e-10 * size + 1e-15 * trial_size);
    REQUIRE(opened >= 0);
    REQUIRE(std::abs(law.yield(after) - violation / (size + 1e-300)) <=
            1e-12 + 1e-15 * trial_size / (size + 1e-300));

    const double excess = q0 + law.surface().slope() * p0 - law.surface().strength();
    if (std::max(excess, p0 - limit) < 0) REQUIRE(after.c == before.c);
    const Eigen::Matrix3d plastic = strain_of(law.elasticity(), full(before) - full(after));
    REQUIRE((full(after) * plastic).trace() >= -1e-13 * trial_size * trial_size / p.young);
    // The deviator shrinks and does not turn.
    const Eigen::Matrix3d d0 = full(before) - p0 * Eigen::Matrix3d::Identity();
    const Eigen::Matrix3d d1 = full(after) - p1 * Eigen::Matrix3d::Identity();
    REQUIRE((d1 * q0 - d0 * q1).norm() <= 1e-13 * trial_size * trial_size);
    // On the cone the volumetric plastic strain is eta' times the multiplier, (q0 - q1)/G.
    if (excess > 0 && q1 > 1e-9 * size && p1 < limit - 1e-9 * size) {
      REQUIRE(opened == 0);
      REQUIRE(std::abs(plastic.trace() - law.surface().flow_slope() * (q0 - q1) / law.elasticity().shear()) <=
              1e-12 * trial_size / p.young);
    }
    if (q1 == 0 && q0 > 0)
      REQUIRE(std::abs(opened - (p0 - p1) / law.elasticity().bulk()) <= 1e-13 * trial_size / p.young);
  }
}

}  // namespace

TEST_CASE("random states come back to the cone, its tip or the cut-off, and dissipate") {
  for (const auto& p : parameter_sets()) {
    check_returns<2>(p);
    check_returns<3>(p);
  }
}

TEST_CASE("associated flow goes to the closest point in the energy norm, with a cut-off too") {
  const double apex = 2e3 / std::tan(33_deg);
  for (const double tension : {1.0, 0.4, 0.0}) {
    const DruckerPrager law{{.density = 1,
                             .young = 5e6,
                             .poisson = 0.3,
                             .friction = 33_deg,
                             .cohesion = 2e3,
                             .dilatancy = 33_deg,
                             .tension = tension * apex}};
    std::mt19937 random(37);
    std::normal_distribution<double> normal;
    for (int trial = 0; trial < 500; ++trial) {
      const auto before = trial_state<3>(random, tension * apex);
      auto after = before;
      law.surface().return_to_yield(after);
      const double best = law.elastic_energy(after - before);
      for (int i = 0; i < 200; ++i) {
        Sym<double, 3> other = after;
        const double size = full(before).norm() * std::pow(10, -double(i % 6));
        for (double& c : other.c) c += size * normal(random);
        const auto [p, q] = invariants(other);
        if (q + law.surface().slope() * p <= law.surface().strength() && p <= tension * apex)
          REQUIRE(law.elastic_energy(other - before) >= best * (1 - 1e-9));
      }
    }
  }
}

TEST_CASE("where both the cone and the cut-off act, their flows add up, and only the cut-off's opens") {
  const DruckerPrager law{{.density = 1,
                           .young = 5e6,
                           .poisson = 0.3,
                           .friction = 30_deg,
                           .cohesion = 5e3,
                           .dilatancy = 10_deg,
                           .tension = 1e3}};
  const double rim = law.surface().strength() - law.surface().slope() * 1e3;
  Sym<double, 3> stress{{20e3, 20e3, 20e3, 15e3, 0, 0}};
  const auto before = stress;
  const double opened = law.surface().return_to_yield(stress).opening;
  REQUIRE(std::abs(stress[0] - 1e3) <= 1e-9);
  REQUIRE(std::abs(stress[3] - rim) <= 1e-9);
  const double volume = strain_of(law.elasticity(), full(before) - full(stress)).trace();
  const double multiplier = (15e3 - rim) / law.elasticity().shear();
  REQUIRE(std::abs(opened - (volume - law.surface().flow_slope() * multiplier)) <= 1e-15);
}

TEST_CASE("triaxial compression: the compression cone has Mohr-Coulomb's strength") {
  for (const double cohesion : {0.0, 4e3}) {
    const DruckerPrager law{{.density = 1,
                             .young = 5e6,
                             .poisson = 0.3,
                             .friction = 35_deg,
                             .cohesion = cohesion,
                             .dilatancy = 10_deg}};
    const double lateral = -10e3, k = std::tan(pi / 4 + 35_deg / 2);
    const auto end = triaxial_compression(law, lateral, 1e-3, 300);
    REQUIRE(std::abs(end.axial_stress - (k * k * lateral - 2 * cohesion * k)) <=
            1e-8 * std::abs(end.axial_stress));
    const double volume = 2 * end.lateral_strain_rate + end.axial_strain_rate;
    const double sum = 2 * std::abs(end.lateral_strain_rate) + std::abs(end.axial_strain_rate);
    REQUIRE(std::abs(volume / sum - std::sin(10_deg)) <= 1e-8);
  }
}

TEST_CASE("the extension cone touches Mohr-Coulomb where two stresses are the greatest compression") {
  const double k = std::tan(pi / 4 + 35_deg / 2), a = 5e3, s1 = -10e3;
  const DruckerPrager law{{.density = 1,
                           .young = 5e6,
                           .poisson = 0.3,
                           .friction = 35_deg,
                           .cohesion = a,
                           .cone = Cone::extension}};
  const double s3 = k * k * s1 - 2 * a * k;
  REQUIRE(std::abs(law.yield(Sym<double, 3>{{s3, s1, s1, 0, 0, 0}})) > 0.01);
  const double two_low = law.yield(Sym<double, 3>{{s3, s1, s3, 0, 0, 0}});
  REQUIRE(std::abs(two_low) <= 1e-14);
}

TEST_CASE("simple shear in plane strain: the plane-strain cone flows like Mohr-Coulomb") {
  // Davis (1968), as for Mohr-Coulomb: both angles come out exactly.
  for (const double dilatancy : {0_deg, 10_deg, 35_deg}) {
    const double friction = 35_deg;
    const DruckerPrager law{{.density = 1,
                             .young = 5e6,
                             .poisson = 0.3,
                             .friction = friction,
                             .dilatancy = dilatancy,
                             .cone = Cone::plane_strain}};
    const auto end = simple_shear(law, -10e3, 2e-4, 2500);
    const double expected =
        std::sin(friction) * std::cos(dilatancy) / (1 - std::sin(friction) * std::sin(dilatancy));
    REQUIRE(std::abs(end.shear_stress / -end.vertical_stress - expected) <= 1e-6);
    REQUIRE(std::abs(end.dilation_rate - std::tan(dilatancy)) <= 1e-6);
  }
  // Without dilatancy stress is isotropic but for the shear: tau = kappa - eta sigma on any cone.
  const DruckerPrager law{{.density = 1, .young = 5e6, .poisson = 0.3, .friction = 20_deg, .cohesion = 2e3}};
  const auto end = simple_shear(law, -10e3, 2e-4, 2500);
  REQUIRE(std::abs(end.shear_stress - (law.surface().strength() + law.surface().slope() * 10e3)) <= 1e-2);
}

TEST_CASE("the plane-strain cone with psi = phi is the one of the records") {
  const double phi = 28_deg, t = std::tan(phi), root = std::sqrt(9 + 12 * t * t);
  const DruckerPrager law{{.density = 1,
                           .young = 1,
                           .poisson = 0,
                           .friction = phi,
                           .cohesion = 7,
                           .dilatancy = phi,
                           .cone = Cone::plane_strain}};
  REQUIRE(std::abs(law.surface().slope() - 3 * t / root) <= 1e-15);
  REQUIRE(std::abs(law.surface().flow_slope() - 3 * t / root) <= 1e-15);
  REQUIRE(std::abs(law.surface().strength() - 7 * 3 / root) <= 1e-14);
}

TEST_CASE("oedometer: the ratio of stresses on the cone is the closed form") {
  // q = -eta p with q = (1 - x) sv/sqrt(3), p = -(1 + 2 x) sv/3, x = sh/sv. Hence 1 - x = h (1 + 2 x).
  const DruckerPrager law{{.density = 1, .young = 5e6, .poisson = 0.05, .friction = 25_deg}};
  Sym<double, 3> stress;
  StrainStep<double, 3> squeeze;
  squeeze.strain[1] = -1e-4;
  NoHistory<double> history;
  for (int i = 0; i < 100; ++i) law.update(stress, squeeze, history);
  const double h = law.surface().slope() / std::sqrt(3.0);
  REQUIRE(std::abs(stress[0] / stress[1] - (1 - h) / (1 + 2 * h)) <= 1e-12);
}

TEST_CASE("without friction there is no apex: any history stays finite, and shear strength is all there is") {
  const auto check = [](auto scalar, double friction) {
    using T = decltype(scalar);
    const DruckerPrager law{
        {.density = 1, .young = 5e6, .poisson = 0.3, .friction = friction, .cohesion = 5e3}};
    std::mt19937 random(41);
    std::uniform_real_distribution<double> uniform(-1, 1);
    Sym<T, 3> stress;
    NoHistory<T> history;
    for (int step = 0; step < 5000; ++step) {
      StrainStep<T, 3> inc;
      const double size = std::pow(10, 2 * uniform(random) - 2);
      for (T& c : inc.strain.c) c = static_cast<T>(size * uniform(random));
      const double mean =
          static_cast<double>(trace(stress) / 3 + trace(law.elasticity().stress(inc.strain)) / 3);
      REQUIRE(law.update(stress, inc, history).opening == 0);
      for (const T c : stress.c) REQUIRE(std::isfinite(c));
      const double p = static_cast<double>(trace(stress)) / 3, ulp = std::numeric_limits<T>::epsilon();
      REQUIRE(std::abs(p - mean) <= 100 * ulp * (std::abs(mean) + size * law.elasticity().wave_modulus()));
      REQUIRE(static_cast<double>(law.yield(stress)) * (std::abs(p) + 1e4) <=
              100 * ulp * (std::abs(p) + size * law.elasticity().wave_modulus()));
    }
  };
  check(0.0f, 0);
  check(0.0, 0);
  check(0.0f, 1e-9);
  check(0.0, 1e-12);
}

TEST_CASE("bad constants of Drucker-Prager are named with their rule") {
  const auto message = [](const DruckerPragerParameters& p) -> std::string {
    try {
      DruckerPrager law(p);
    } catch (const error& e) {
      return e.what();
    }
    return "";
  };
  REQUIRE(message({.density = 1, .young = 1, .poisson = 0.5, .friction = 0.5}) ==
          "DruckerPrager.poisson = 0.5: must lie in (-1, 0.5)");
  REQUIRE(message({.density = 1, .young = 1, .poisson = 0.3}) ==
          "DruckerPrager.friction = nan: must be given");
  REQUIRE(message({.density = 1, .young = 1, .poisson = 0.3, .friction = 0.5, .dilatancy = -0.1}) ==
          "DruckerPrager.dilatancy = -0.1: must lie in [0, friction]");
  REQUIRE(message({.density = 1, .young = 1, .poisson = 0.3, .friction = 0.5}).empty());
}
