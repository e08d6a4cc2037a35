// Mohr-Coulomb: strengths and flow against closed forms, and what it refuses.
#include <string>

#include "catch.hpp"
#include "mohr_coulomb_sets.hpp"
#include "states.hpp"

using namespace arenite;
using namespace arenite::test;

namespace {

std::string message(const MohrCoulombParameters& p) {
  try {
    MohrCoulomb law(p);
  } catch (const error& e) {
    return e.what();
  }
  return "";
}

}  // namespace

TEST_CASE("the cut-off relaxes sideways like a crack") {
  // Stretched along x only, the plastic strain is an opening along x: what is left of the stress sideways is
  // elastic.
  const MohrCoulomb law{
      {.density = 1, .young = 5e6, .poisson = 0.25, .friction = 30_deg, .cohesion = 50e3, .tension = 1e3}};
  Sym<double, 3> stress{{0, -10e3, -12e3, 0, 0, 0}};
  const auto start = stress;
  StrainStep<double, 3> stretch;
  stretch.strain[0] = 2e-3;
  NoHistory<double> history;
  const double opened = law.update(stress, stretch, history).opening;
  const double side = 0.25 * 1e3 / 0.75;  // lambda/(lambda + 2 G) of the stress that x did keep
  REQUIRE(std::abs(stress[0] - 1e3) <= 1e-9);
  REQUIRE(std::abs(stress[1] - (start[1] + side)) <= 1e-8);
  REQUIRE(std::abs(stress[2] - (start[2] + side)) <= 1e-8);
  REQUIRE(std::abs(opened - (2e-3 - 1e3 / law.wave_modulus())) <= 1e-15);
}

TEST_CASE("triaxial compression: strength, and dilatancy from the plastic strains") {
  for (auto p : parameter_sets()) {
    p.poisson = 0.3;
    const MohrCoulomb law{p};
    const double lateral = -10e3, k = std::tan(pi / 4 + p.friction / 2);
    const auto end = triaxial_compression(law, lateral, 1e-3, 400);
    REQUIRE(std::abs(end.axial_stress - (k * k * lateral - 2 * p.cohesion * k)) <=
            1e-8 * std::abs(end.axial_stress));
    const double volume = 2 * end.lateral_strain_rate + end.axial_strain_rate;
    const double sum = 2 * std::abs(end.lateral_strain_rate) + std::abs(end.axial_strain_rate);
    REQUIRE(std::abs(volume / sum - std::sin(p.dilatancy)) <= 1e-8);
  }
}

TEST_CASE("simple shear in plane strain: tau/sigma = sin(phi) cos(psi)/(1 - sin(phi) sin(psi))") {
  // Davis (1968): the plane of shear is one without stretch.
  for (const double dilatancy : {0_deg, 10_deg, 35_deg}) {
    const double friction = 35_deg;
    const MohrCoulomb law{
        {.density = 1, .young = 5e6, .poisson = 0.3, .friction = friction, .dilatancy = dilatancy}};
    const auto end = simple_shear(law, -10e3, 2e-4, 1500);
    const double expected =
        std::sin(friction) * std::cos(dilatancy) / (1 - std::sin(friction) * std::sin(dilatancy));
    REQUIRE(std::abs(end.shear_stress / -end.vertical_stress - expected) <= 1e-6);
    REQUIRE(std::abs(end.dilation_rate - std::tan(dilatancy)) <= 1e-6);
  }
}

TEST_CASE("oedometer: at rest until K0 reaches the active limit") {
  const auto ratio = [](double poisson, double friction) {
    const MohrCoulomb law{{.density = 1, .young = 5e6, .poisson = poisson, .friction = friction}};
    Sym<double, 2> stress;
    StrainStep<double, 2> squeeze;
    squeeze.strain[1] = -1e-4;
    NoHistory<double> history;
    for (int i = 0; i < 100; ++i) REQUIRE(law.update(stress, squeeze, history).opening == 0);
    return stress[0] / stress[1];
  };
  REQUIRE(std::abs(ratio(0.33, 30_deg) - 0.33 / 0.67) <= 1e-13);
  REQUIRE(std::abs(ratio(0.1, 30_deg) - 1.0 / 3) <= 1e-13);
}

TEST_CASE("bad constants of Mohr-Coulomb are named with their rule") {
  const MohrCoulombParameters good{.density = 1, .young = 1, .poisson = 0.3, .friction = 0.5};
  auto p = good;
  REQUIRE(message(p).empty());
  p.poisson = 0.6;
  REQUIRE(message(p) == "MohrCoulomb.poisson = 0.6: must lie in (-1, 0.5)");
  p = good;
  p.friction = 40;
  REQUIRE(message(p) == "MohrCoulomb.friction = 40: must lie in [0, 1.55] rad (88.8 deg)");
  p.friction = detail::not_given;
  REQUIRE(message(p) == "MohrCoulomb.friction = nan: must be given");
  p.friction = 0;
  REQUIRE(
      message(p) ==
      "MohrCoulomb.cohesion = 0: must be positive where friction is 0: matter without both has no strength");
  p = good;
  p.dilatancy = 0.6;
  REQUIRE(message(p) == "MohrCoulomb.dilatancy = 0.6: must lie in [0, friction]");
  p = good;
  p.cohesion = -1;
  REQUIRE(message(p) == "MohrCoulomb.cohesion = -1: must not be negative (Pa)");
  p = good;
  p.tension = -2;
  REQUIRE(message(p) == "MohrCoulomb.tension = -2: must not be negative (Pa)");
}
