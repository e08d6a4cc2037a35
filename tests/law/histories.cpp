// Random histories of laws with extreme but legal constants: every number stays finite, every stress
// admissible, nothing closes that was not open, and plastic work is never negative, each to the round-off of
// the trial stress.
#include <arenite/law/drucker_prager.hpp>
#include <arenite/law/linear_elastic.hpp>
#include <arenite/law/mohr_coulomb.hpp>
#include <arenite/simd/lanes.hpp>
#include <limits>
#include <string>

#include "catch.hpp"
#include "states.hpp"

using namespace arenite;
using namespace arenite::test;

namespace {

std::mt19937 random_source(61);

double number(double low, double high) {
  return std::uniform_real_distribution<double>(low, high)(random_source);
}
double power(double low, double high) { return std::pow(10, number(low, high)); }
int choice(int n) { return static_cast<int>(random_source() % static_cast<unsigned>(n)); }

/// Constants to the ends of what is legal and beyond what is real.
struct Constants {
  double young = power(2, 11);
  double poisson = std::array{-0.9, 0.4999, number(-0.9, 0.4999)}[static_cast<std::size_t>(choice(3))];
  double friction = std::array{0.0, 80 * pi / 180, power(-12, -2),
                               number(0, 80 * pi / 180)}[static_cast<std::size_t>(choice(4))];
  double dilatancy = friction * std::array{0.0, 1.0, number(0, 1)}[static_cast<std::size_t>(choice(3))];
  double cohesion = friction > 0 && choice(3) == 0
                        ? 0
                        : std::array{1e6, power(-6, 6)}[static_cast<std::size_t>(choice(2))];
  double tension = std::array{std::numeric_limits<double>::infinity(), 0.0,
                              power(-3, 6)}[static_cast<std::size_t>(choice(3))];

  std::string text() const {
    return joined_text({"young ", young, ", poisson ", poisson, ", friction ", friction, ", dilatancy ",
                        dilatancy, ", cohesion ", cohesion, ", tension ", tension});
  }
  MohrCoulombParameters mohr_coulomb() const {
    return {.density = 1,
            .young = young,
            .poisson = poisson,
            .friction = friction,
            .cohesion = cohesion,
            .dilatancy = dilatancy,
            .tension = tension};
  }
  DruckerPragerParameters drucker_prager() const {
    return {.density = 1,
            .young = young,
            .poisson = poisson,
            .friction = friction,
            .cohesion = cohesion,
            .dilatancy = dilatancy,
            .tension = tension,
            .cone = static_cast<Cone>(choice(3))};
  }
};

/// Strains of 1e-12 to 10 a step: volumetric, nearly so, along one axis, any; turned a little or right over.
template <int D>
StrainStep<double, D> random_step() {
  StrainStep<double, D> inc;
  const double size = power(-12, 1), volume = number(-1, 1),
               shear = std::array{0.0, 1e-6, 1.0, 1.0}[static_cast<std::size_t>(choice(4))];
  for (std::size_t i = 0; i < inc.strain.size; ++i)
    inc.strain[i] = size * (shear * number(-1, 1) + (i < 3 && shear < 1 ? volume : 0));
  if (choice(4) == 0)
    for (std::size_t i = 1; i < inc.strain.size; ++i) inc.strain[i] = 0;
  for (double& w : inc.spin) w = (choice(3) == 0 ? 10 : 0.1) * number(-1, 1);
  return inc;
}

using test::lane;
template <class P, int D>
Sym<double, D> lane(const Sym<P, D>& s, int k) {
  return Sym<double, D>::each([&](std::size_t i) { return static_cast<double>(lane(s[i], k)); });
}

double greatest(const auto& s) {
  double size = 0;
  for (const double c : s.c) size = std::max(size, std::abs(c));
  return size;
}

/// One history a lane.
template <class P, int D, class Law>
void follow(const Law& law, const Constants& constants) {
  using T = scalar_of<P>;
  const double ulp = std::numeric_limits<T>::epsilon();
  const double modulus = law.wave_modulus();
  Sym<P, D> stress;
  typename Law::template History<P> history{};
  for (int step = 0; step < 15; ++step) {
    StrainStep<P, D> strain_step;
    for (int k = 0; k < lane_count<P>; ++k) {
      const auto inc = random_step<D>();
      for (std::size_t i = 0; i < stress.size; ++i) set(strain_step.strain[i], k, inc.strain[i]);
      for (std::size_t i = 0; i < inc.spin.size(); ++i) set(strain_step.spin[i], k, inc.spin[i]);
    }
    const auto before = stress;
    const P opened = inelastic(law.update(stress, strain_step, history)).opening;
    const P energy = law.elastic_energy(stress);
    for (int k = 0; k < lane_count<P>; ++k) {
      const auto was = lane(before, k), is = lane(stress, k);
      bool finite = std::isfinite(lane(opened, k)) && std::isfinite(lane(energy, k));
      for (const double c : is.c) finite = finite && std::isfinite(c);
      std::apply([&](const auto&... member) { ((finite = finite && std::isfinite(lane(member, k))), ...); },
                 history.members());
      // Of the trial stress and the strength, whose parts may cancel.
      const StrainStep<double, D> inc{lane(strain_step.strain, k), {}};
      const double round_off = ulp * (greatest(was) + greatest(inc.strain) * modulus + constants.cohesion);
      if (!finite) FAIL(constants.text() << ", step " << step);
      if constexpr (requires { law.yield(is); }) {
        const double p = trace(is) / 3, size = greatest(is) + std::abs(p) + constants.cohesion;
        if (law.yield(is) * size > 60 * round_off)
          FAIL(constants.text() << ", step " << step << ": yield " << law.yield(is) * size / round_off);
        if constexpr (std::is_same_v<typename Law::template History<P>, NoHistory<P>>) {
          const auto& e = law.elasticity();
          if (lane(opened, k) < -60 * round_off / e.bulk())
            FAIL(constants.text() << ", step " << step << ": opened " << lane(opened, k));
          StrainStep<double, D> turn;
          for (std::size_t i = 0; i < turn.spin.size(); ++i) turn.spin[i] = lane(strain_step.spin[i], k);
          const auto corrected = turned(was, turn.spin) + e.stress(inc.strain) - is;
          const double work =
              contract(is, deviator(corrected)) * 0.5 / e.shear() + p * trace(corrected) / (3 * e.bulk());
          const double scale = (greatest(deviator(is)) + greatest(deviator(corrected))) / e.shear() +
                               (std::abs(p) + std::abs(trace(corrected))) / e.bulk();
          if (work < -60 * round_off * scale)
            FAIL(constants.text() << ", step " << step << ": plastic work " << work / (round_off * scale));
        }
      }
    }
  }
}

template <class P, int D>
void follow_all(int rounds) {
  for (int round = 0; round < rounds; ++round) {
    const Constants c;
    follow<P, D>(LinearElastic{{.density = 1, .young = c.young, .poisson = c.poisson}}, c);
    follow<P, D>(MohrCoulomb{c.mohr_coulomb()}, c);
    follow<P, D>(DruckerPrager{c.drucker_prager()}, c);
    Constants open = c;
    open.tension = std::numeric_limits<double>::infinity();
    const RemembersOpening memory{{.limit = power(-3, 3)}};
    follow<P, D>(MohrCoulomb{open.mohr_coulomb(), memory}, c);
    follow<P, D>(DruckerPrager{open.drucker_prager(), memory}, c);
  }
  SUCCEED();
}

}  // namespace

TEST_CASE("in double") {
  follow_all<double, 3>(2000);
  follow_all<double, 2>(1000);
}
TEST_CASE("in float") {
  follow_all<float, 3>(2000);
  follow_all<float, 2>(1000);
}
TEST_CASE("in packs") { follow_all<Pack<float, 16>, 3>(150); }
