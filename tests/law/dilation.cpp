// Inelastic volumetric strain that a law reports: opening and dilation account for all of it, dilation
// follows the angle of dilatancy, and open matter carries no stress, whatever an average gave it.
#include <arenite/core/units.hpp>
#include <arenite/law/drucker_prager.hpp>
#include <arenite/law/mohr_coulomb.hpp>
#include <arenite/law/pass.hpp>
#include <arenite/particles/points.hpp>

#include "catch.hpp"
#include "states.hpp"

using namespace arenite;
using namespace arenite::test;

namespace {

template <class Law>
void check_account(const Law& law) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> uniform(-1, 1);
  double dilated = 0;
  for (int round = 0; round < 3000; ++round) {
    Sym<double, 3> stress = trial_state<3>(random, 0);
    typename Law::template History<double> history{};
    law.update(stress, {}, history);  // to an admissible state
    history = {};
    StrainStep<double, 3> strain_step;
    for (std::size_t i = 0; i < 6; ++i) strain_step.strain[i] = 1e-2 * uniform(random);
    const double before = trace(stress);
    const auto [opening, dilation] = law.update(stress, strain_step, history);
    const double elastic = (trace(stress) - before) / (3 * law.elasticity().bulk());
    REQUIRE(std::abs(elastic + opening + dilation - trace(strain_step.strain)) <= 1e-13);
    REQUIRE(dilation >= -1e-14);
    dilated += dilation;
  }
  REQUIRE(dilated > 1);
}

const MohrCoulombParameters pyramid{.density = 1540,
                                    .young = 5e6,
                                    .poisson = 0.33,
                                    .friction = 35_deg,
                                    .cohesion = 1_kPa,
                                    .dilatancy = 15_deg};
const DruckerPragerParameters cone{.density = 1540,
                                   .young = 5e6,
                                   .poisson = 0.33,
                                   .friction = 35_deg,
                                   .cohesion = 1_kPa,
                                   .dilatancy = 15_deg};

}  // namespace

TEST_CASE("volumetric strain = change of the mean stress / K + opening + dilation") {
  check_account(MohrCoulomb{pyramid});
  check_account(MohrCoulomb{pyramid, RemembersOpening{}});
  check_account(DruckerPrager{cone});
  check_account(DruckerPrager{cone, RemembersOpening{}});
  auto cut = pyramid;
  cut.tension = 200;
  check_account(MohrCoulomb{cut});
}

TEST_CASE("plane strain: dilation over plastic shear strain is the sine of the angle of dilatancy") {
  for (const double psi : {0.0, 5_deg, 15_deg, 35_deg}) {
    CAPTURE(psi);
    auto p = pyramid;
    p.cohesion = 0;
    p.dilatancy = psi;
    const MohrCoulomb law{p};
    Sym<double, 2> stress{{-1e4, -1e4, -1e4, 0}};
    NoHistory<double> history;
    for (int k = 0; k < 200; ++k) {
      const Sym<double, 2> before = stress;
      StrainStep<double, 2> step;
      step.strain = {{0, 0, 0, 1e-4}};
      const auto [opening, dilation] = law.update(stress, step, history);
      REQUIRE(opening == 0);
      if (psi == 0) REQUIRE(dilation == 0);  // to the bit: an average keeps nothing out
      if (k < 100) continue;
      const Eigen::Matrix3d plastic =
          full(step.strain) - strain_of(law.elasticity(), full(Sym<double, 2>(stress - before)));
      const Eigen::Vector3d e = Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(plastic).eigenvalues();
      REQUIRE(std::abs(dilation - std::sin(psi) * (e[2] - e[0])) <= 1e-12);
    }
  }
}

TEST_CASE(
    "open matter carries no stress, even if an average gave it some: an opening cycle gives no energy") {
  const auto check = [](const auto& law) {
    const double bulk = law.elasticity().bulk();
    Sym<double, 3> stress{};
    typename std::remove_cvref_t<decltype(law)>::template History<double> history{};
    const auto pull = [&](double e) {
      StrainStep<double, 3> step;
      step.strain = {{e, e, e, 0, 0, 0}};
      const Sym<double, 3> before = stress;
      law.update(stress, step, history);
      return contract(before + stress, step.strain) / 2;  // J/m3
    };
    pull(1e-2);
    REQUIRE(history.opening > 0);
    const double p = -1e3;  // from the neighbours, through the mean over a cell
    stress = {{p, p, p, 0, 0, 0}};
    const double stored = p * p / (2 * bulk);
    double gained = 0;
    for (int k = 0; k < 1000; ++k) gained -= pull(1e-5);
    CHECK(gained <= stored);
    for (std::size_t i = 0; i < 6; ++i) CHECK(stress[i] == 0);
  };
  auto loose = pyramid;
  loose.cohesion = 0;
  check(MohrCoulomb{loose, RemembersOpening{}});
  auto loose_cone = cone;
  loose_cone.cohesion = 0;
  check(DruckerPrager{loose_cone, RemembersOpening{}});
}

TEST_CASE("material dilates up to its greatest volume ratio; what it would dilate beyond counts as opened") {
  auto p = pyramid;
  p.cohesion = 0;
  p.greatest_volume_ratio = 1.1;
  const MohrCoulomb law{p};
  Points<double, 2, MohrCoulomb<>> points;
  points.push_back({0, 0}, {0, 0}, 2e-3 * p.density, 2e-3, {{-1e4, -1e4, -1e4, 0}}, 0);
  // Simple shear at the rate of dilation that keeps the vertical stress.
  const double shear = 1e-3, up = shear * std::tan(p.dilatancy);
  StrainStep<double, 2> step;
  step.strain = {{0, up, 0, shear / 2}};
  StrainBuffer<double, 2> buffer;
  buffer.store(0, step);
  G2pSums sums;
  const int steps = 2000;
  for (int k = 0; k < steps; ++k) law_pass<false, 1>(law, points, 0, 1, buffer, 0, sums);
  CHECK(std::abs(points.volume[0] - 1.1 * 2e-3) <= 1e-15);
  CHECK(std::abs(sums.opened_volume / (1.1 * 2e-3 * (steps * up - std::log(1.1))) - 1) <= 1e-3);
}

TEST_CASE("material that does not dilate has no greatest volume ratio, whatever its neighbours do") {
  auto p = pyramid;
  p.cohesion = 0;
  p.greatest_volume_ratio = 1.1;
  const MohrCoulomb law{p};
  const auto volumes = [&]<int Width>(std::integral_constant<int, Width>, bool beside) {
    Points<double, 2, MohrCoulomb<>> points;
    StrainBuffer<double, 2> buffer;
    // Beyond its bound, and unloaded elastically; at it, and sheared.
    points.push_back({0, 0}, {0, 0}, 2e-3 * p.density, 2.3e-3, {{-1e4, -1e4, -1e4, 0}}, 0);
    buffer.store(0, StrainStep<double, 2>{.strain = {{1e-4, 1e-4, 0, 0}}});
    if (beside) {
      points.push_back({0, 0}, {0, 0}, 2e-3 * p.density, 2.2e-3, {{-1e4, -1e4, -1e4, 0}}, 0);
      buffer.store(1, StrainStep<double, 2>{.strain = {{0, 0, 0, 1e-2}}});
    }
    G2pSums sums;
    law_pass<false, Width>(law, points, 0, beside ? 2 : 1, buffer, 0, sums);
    return std::array{points.volume[0], beside ? points.volume[1] : 0};
  };
  const double alone = volumes(std::integral_constant<int, 1>{}, false)[0];
  CHECK(alone == Approx(2.3e-3 * std::exp(2e-4)).epsilon(1e-12));
  const auto both = volumes(std::integral_constant<int, 2>{}, true);
  CHECK(both[0] == Approx(alone).epsilon(1e-15));
  CHECK(both[1] == Approx(2.2e-3).epsilon(1e-15));
}

TEST_CASE("the greatest volume ratio must be at least 1") {
  auto p = pyramid;
  p.greatest_volume_ratio = 0.9;
  CHECK_THROWS_WITH(MohrCoulomb{p}, "MohrCoulomb.greatest_volume_ratio = 0.9: must be at least 1");
}
