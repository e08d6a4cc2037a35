// The recorded deviatoric strain against simple shear, rigid turns and strains that are undone.
#include <arenite/law/linear_elastic.hpp>
#include <arenite/law/with_deviatoric_strain.hpp>
#include <cmath>

#include "catch.hpp"

using namespace arenite;

namespace {

const WithDeviatoricStrain law{LinearElastic{{.density = 1000, .young = 1e6, .poisson = 0.25}}};

template <int D>
double after(WithDeviatoricStrain<LinearElastic>::History<double>& history, const StrainStep<double, D>& inc,
             int steps) {
  Sym<double, D> stress{};
  for (int k = 0; k < steps; ++k) law.update(stress, inc, history);
  return law.deviatoric_strain(history);
}

}  // namespace

TEST_CASE("uniaxial strain: two thirds of it is deviatoric") {
  WithDeviatoricStrain<LinearElastic>::History<double> h{};
  StrainStep<double, 2> inc{};
  inc.strain = {{0, -0.01, 0, 0}};
  REQUIRE(std::abs(after(h, inc, 10) - 0.1 * 2 / 3) < 1e-14);
}

TEST_CASE("a small simple shear gamma gives gamma / sqrt(3)") {
  WithDeviatoricStrain<LinearElastic>::History<double> h{};
  StrainStep<double, 3> inc{};
  inc.strain[3] = 0.5e-6;
  inc.spin[0] = 0.5e-6;
  REQUIRE(std::abs(after(h, inc, 100) - 1e-4 / std::sqrt(3.0)) < 1e-12);
}

TEST_CASE("a turn adds nothing, and a strain that is undone leaves nothing") {
  WithDeviatoricStrain<LinearElastic>::History<double> h{};
  StrainStep<double, 2> there{}, turn{}, back{};
  there.strain = {{0.02, -0.02, 0, 0.01}};
  turn.spin[0] = 0.1;
  back.strain = there.strain * -1.0;
  const double strained = after(h, there, 1);
  REQUIRE(std::abs(after(h, turn, 25) - strained) < 1e-15);
  WithDeviatoricStrain<LinearElastic>::History<double> fresh{};
  after(fresh, there, 1);
  REQUIRE(after(fresh, back, 1) < 1e-16);
}

TEST_CASE("a plane tracer stores three components and says the same") {
  const WithDeviatoricStrain<LinearElastic, 2> plane{law.law()};
  WithDeviatoricStrain<LinearElastic, 2>::History<double> narrow{};
  WithDeviatoricStrain<LinearElastic>::History<double> wide{};
  STATIC_REQUIRE(std::tuple_size_v<decltype(narrow.members())> == 3);
  STATIC_REQUIRE(std::tuple_size_v<decltype(wide.members())> == 5);
  StrainStep<double, 2> inc{};
  inc.strain = {{0.02, -0.01, 0.005, 0.01}};
  inc.spin[0] = 0.03;
  Sym<double, 2> stress{};
  for (int k = 0; k < 7; ++k) plane.update(stress, inc, narrow);
  REQUIRE(plane.deviatoric_strain(narrow) == after(wide, inc, 7));
}

namespace {
struct Branching : LinearElastic {
  using LinearElastic::LinearElastic;
  static constexpr int max_pack_width = 1;
  static constexpr bool two_packs_at_once = false;
};
struct Chain : LinearElastic {
  using LinearElastic::LinearElastic;
  static constexpr int max_pack_width = 4;
  static constexpr bool two_packs_at_once = true;
};
}  // namespace

TEST_CASE("a law with its deviatoric strain is called with the packs that the law asks for") {
  STATIC_REQUIRE(max_pack_width<WithDeviatoricStrain<Branching>> == 1);
  STATIC_REQUIRE_FALSE(two_packs_at_once<WithDeviatoricStrain<Branching>>);
  STATIC_REQUIRE(max_pack_width<WithDeviatoricStrain<Chain>> == 4);
  STATIC_REQUIRE(two_packs_at_once<WithDeviatoricStrain<Chain>>);
  STATIC_REQUIRE(max_pack_width<WithDeviatoricStrain<LinearElastic>> == max_pack_width<LinearElastic>);
  STATIC_REQUIRE_FALSE(two_packs_at_once<WithDeviatoricStrain<LinearElastic>>);
}
