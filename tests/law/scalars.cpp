// The same law on doubles, floats and packs of any width, in the plane and in space, gives the same stress.
#include <arenite/core/units.hpp>
#include <arenite/law/drucker_prager.hpp>
#include <arenite/law/linear_elastic.hpp>
#include <arenite/law/mohr_coulomb.hpp>
#include <arenite/simd/pack.hpp>

#include "catch.hpp"
#include "states.hpp"

using namespace arenite;
using namespace arenite::test;

namespace {

template <class T>
void check_concept() {
  static_assert(constitutive_law<LinearElastic, T, 2> && constitutive_law<LinearElastic, T, 3>);
  static_assert(constitutive_law<MohrCoulomb<>, T, 2> &&
                constitutive_law<MohrCoulomb<RemembersOpening>, T, 3>);
  static_assert(constitutive_law<DruckerPrager<>, T, 2> &&
                constitutive_law<DruckerPrager<RemembersOpening>, T, 3>);
}

/// One trial: a stress, a step, an opening that is remembered (or not).
template <int D>
struct Trial {
  Sym<double, D> stress;
  StrainStep<double, D> strain_step;
  double opening;
};

template <int D>
Trial<D> random_trial(std::mt19937& random) {
  std::uniform_real_distribution<double> uniform(-1, 1);
  Trial<D> t;
  t.stress = trial_state<D>(random, 0);
  for (double& c : t.strain_step.strain.c) c = 2e-3 * uniform(random);
  for (double& c : t.strain_step.spin) c = 0.1 * uniform(random);
  t.opening = random() % 2 == 0 ? 0 : 1e-3 * std::abs(uniform(random));
  return t;
}

/// Copies lane `lane` of a trial into scalars or packs.
template <class T>
void put(T& to, int lane, double from) {
  if constexpr (std::is_floating_point_v<T>)
    to = static_cast<T>(from);
  else
    to.set(lane, static_cast<typename T::scalar>(from));
}
template <class T>
double get(const T& from, int lane) {
  if constexpr (std::is_floating_point_v<T>)
    return static_cast<double>(from);
  else
    return static_cast<double>(from[lane]);
}

template <class T, int W, int D, class Law>
void check_against_double(const Law& law, double tolerance) {
  std::mt19937 random(41);
  for (int round = 0; round < 3000 / W; ++round) {
    Sym<T, D> stress;
    StrainStep<T, D> strain_step;
    typename Law::template History<T> history{};
    std::array<Trial<D>, W> trials;
    for (int lane = 0; lane < W; ++lane) {
      auto& t = trials[static_cast<std::size_t>(lane)] = random_trial<D>(random);
      for (std::size_t i = 0; i < stress.size; ++i) {
        put(stress[i], lane, t.stress[i]);
        put(strain_step.strain[i], lane, t.strain_step.strain[i]);
      }
      for (std::size_t i = 0; i < strain_step.spin.size(); ++i)
        put(strain_step.spin[i], lane, t.strain_step.spin[i]);
      std::apply([&](auto&... member) { (put(member, lane, t.opening), ...); }, history.members());
    }
    const auto [opened, dilated] = inelastic(law.update(stress, strain_step, history));
    const T energy = law.elastic_energy(stress);
    for (int lane = 0; lane < W; ++lane) {
      auto& t = trials[static_cast<std::size_t>(lane)];
      typename Law::template History<double> expected{};
      std::apply([&](auto&... member) { ((member = t.opening), ...); }, expected.members());
      const double size = t.stress.size * 5e6 * 2e-3 + full(t.stress).norm();
      const auto parts = inelastic(law.update(t.stress, t.strain_step, expected));
      for (std::size_t i = 0; i < stress.size; ++i)
        REQUIRE(std::abs(get(stress[i], lane) - t.stress[i]) <= tolerance * size);
      REQUIRE(std::abs(get(opened, lane) - parts.opening) <= tolerance * size / 5e6);
      REQUIRE(std::abs(get(dilated, lane) - parts.dilation) <= tolerance * size / 5e6);
      REQUIRE(std::abs(get(energy, lane) - law.elastic_energy(t.stress)) <= tolerance * size * size / 5e6);
    }
  }
}

template <int D, class Law>
void check_scalars(const Law& law) {
  check_against_double<Pack<double, 1>, 1, D>(law, 1e-14);
  check_against_double<Pack<double, 2>, 2, D>(law, 1e-14);
  check_against_double<Pack<double, 4>, 4, D>(law, 1e-14);
  check_against_double<Pack<double, 8>, 8, D>(law, 1e-14);
  check_against_double<float, 1, D>(law, 1e-5);
  check_against_double<Pack<float, 8>, 8, D>(law, 1e-5);
  check_against_double<Pack<float, 16>, 16, D>(law, 1e-5);
}

template <class Law>
void check_plane_in_space(const Law& law) {
  std::mt19937 random(43);
  for (int round = 0; round < 3000; ++round) {
    const Trial<2> t = random_trial<2>(random);
    Sym<double, 2> plane = t.stress;
    Sym<double, 3> solid = symmetric<3>(full(t.stress));
    StrainStep<double, 3> strain_step{symmetric<3>(full(t.strain_step.strain)),
                                      {t.strain_step.spin[0], 0, 0}};
    typename Law::template History<double> a{}, b{};
    const auto flat = inelastic(law.update(plane, t.strain_step, a)),
               same = inelastic(law.update(solid, strain_step, b));
    const double size = 4e4 + full(t.stress).norm();
    REQUIRE((full(plane) - full(solid)).norm() <= 1e-14 * size);
    REQUIRE(std::abs(flat.opening - same.opening) <= 1e-14 * size / 5e6);
    REQUIRE(std::abs(flat.dilation - same.dilation) <= 1e-14 * size / 5e6);
  }
}

template <class Law>
void check(const Law& law) {
  check_scalars<2>(law);
  check_scalars<3>(law);
  check_plane_in_space(law);
}

}  // namespace

TEST_CASE("each law takes each scalar") {
  check_concept<double>();
  check_concept<float>();
  check_concept<Pack<double, 8>>();
  check_concept<Pack<float, 16>>();
}

TEST_CASE("linear elastic: scalars and packs") {
  check(LinearElastic{{.density = 1, .young = 5e6, .poisson = 0.33}});
}

TEST_CASE("Mohr-Coulomb: scalars and packs") {
  check(MohrCoulomb{{.density = 1, .young = 5e6, .poisson = 0.33, .friction = 40_deg}});
  check(MohrCoulomb{{.density = 1,
                     .young = 5e6,
                     .poisson = 0.33,
                     .friction = 30_deg,
                     .cohesion = 2e3,
                     .dilatancy = 9_deg,
                     .tension = 100}});
  check(MohrCoulomb{{.density = 1, .young = 5e6, .poisson = 0.33, .friction = 0, .cohesion = 2e3}});
  check(MohrCoulomb{{.density = 1, .young = 5e6, .poisson = 0.33, .friction = 40_deg}, RemembersOpening{}});
}

TEST_CASE("Drucker-Prager: scalars and packs") {
  check(DruckerPrager{{.density = 1, .young = 5e6, .poisson = 0.33, .friction = 40_deg}});
  check(DruckerPrager{{.density = 1,
                       .young = 5e6,
                       .poisson = 0.33,
                       .friction = 30_deg,
                       .cohesion = 2e3,
                       .dilatancy = 9_deg,
                       .tension = 100}});
  check(DruckerPrager{{.density = 1, .young = 5e6, .poisson = 0.33, .friction = 40_deg}, RemembersOpening{}});
}
