// A law whose friction is chosen at run time has the bits of the law that is compiled for that policy.
#include <arenite/arenite.hpp>
#include <arenite/law/any_friction.hpp>
#include <bit>
#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "catch.hpp"
#include "states.hpp"

using namespace arenite;
using namespace arenite::test;

namespace {

/// Packs of random states, taken through `steps` steps; the bits of each number after each step, those of the
/// history by name.
template <class P, int D, class Law>
std::map<std::string, std::vector<std::uint64_t>> bits_of(const Law& law, double apex) {
  using History = typename Law::template History<P>;
  std::map<std::string, std::vector<std::uint64_t>> bits;
  std::mt19937 random(5);
  std::uniform_real_distribution<double> uniform(-1, 1);
  for (int pack = 0; pack < 512; ++pack) {
    Sym<P, D> stress;
    History history{};
    for (int k = 0; k < lane_count<P>; ++k) {
      const auto state = trial_state<D>(random, apex);
      for (std::size_t i = 0; i < stress.size; ++i) set(stress[i], k, state[i]);
    }
    for (int n = 0; n < 3; ++n) {
      StrainStep<P, D> step;
      step.dt = 1e-4;
      for (int k = 0; k < lane_count<P>; ++k) {
        const double size = std::pow(10, -4 + uniform(random));
        for (std::size_t i = 0; i < stress.size; ++i) set(step.strain[i], k, size * uniform(random));
        for (P& w : step.spin) set(w, k, 0.01 * uniform(random));
      }
      const auto parts = inelastic(law.update(stress, step, history));
      const auto add = [&](const std::string& name, const P& value) {
        for (int k = 0; k < lane_count<P>; ++k)
          bits[name].push_back(std::bit_cast<std::uint64_t>(lane(value, k)));
      };
      for (const P& component : stress.c) add("stress", component);
      add("opening", parts.opening);
      add("dilation", parts.dilation);
      add("yield", yield_of(law, stress, history));
      add("energy", elastic_energy_of(law, stress, history));
      std::apply(
          [&](const auto&... member) {
            std::size_t m = 0;
            (add(std::string(history_names<History>[m++]), member), ...);
          },
          history.members());
    }
  }
  return bits;
}

template <class P, int D, class Exact, class Any>
void compare(const Exact& exact, const Any& any, double apex) {
  const auto wanted = bits_of<P, D>(exact, apex), found = bits_of<P, D>(any, apex);
  for (const auto& [name, bits] : wanted) {
    CAPTURE(name, lane_count<P>, D);
    CHECK((found.at(name) == bits));
  }
  CHECK(found.contains("shear_rate"));
  CHECK(found.contains("plastic_strain"));
}

template <template <class, class, class> class Law, class Parameters, class Memory = ForgetsOpening,
          class Friction>
void check(const Friction& friction) {
  for (const double cohesion : {0.0, 2e3})
    for (const double dilatancy : {0_deg, 10_deg})
      for (const double tension : {std::numeric_limits<double>::infinity(), 300.0}) {
        if (Memory::remembers && std::isfinite(tension)) continue;
        CAPTURE(cohesion, dilatancy, tension);
        const Parameters p{.density = 1540,
                           .young = 20_MPa,
                           .poisson = 0.3,
                           .friction = 40_deg,
                           .cohesion = cohesion,
                           .dilatancy = dilatancy,
                           .tension = tension};
        const Law<Memory, Friction, ConstantStiffness> exact{p, {}, friction};
        const Law<Memory, AnyFriction, ConstantStiffness> any{p, {}, AnyFriction{friction}};
        const double apex = detail::apex(40_deg, cohesion);
        compare<double, 3>(exact, any, apex);
        compare<double, 2>(exact, any, apex);
        compare<Pack<double, 4>, 3>(exact, any, apex);
      }
}

const SofteningParameters soft{.residual_friction = 25_deg, .decay = 8};

}  // namespace

TEST_CASE("friction chosen at run time: the bits of each policy in Mohr-Coulomb") {
  check<MohrCoulomb, MohrCoulombParameters>(ConstantFriction{});
  check<MohrCoulomb, MohrCoulombParameters>(LinearRateFriction{{.time = 1e-2, .smoothing = 1e-3}});
  check<MohrCoulomb, MohrCoulombParameters>(LinearRateFriction{{.time = 0}});
  check<MohrCoulomb, MohrCoulombParameters>(InertialFriction{{.grain_size = 5e-3}});
  check<MohrCoulomb, MohrCoulombParameters>(LogarithmicFriction{{.per_decade = 0.1}});
  check<MohrCoulomb, MohrCoulombParameters>(SofteningFriction{soft});
  check<MohrCoulomb, MohrCoulombParameters>(RateSofteningFriction{{.softening = soft, .smoothing = 1e-3}});
}

TEST_CASE("friction chosen at run time: the bits of policies in Drucker-Prager, and with memory") {
  check<DruckerPrager, DruckerPragerParameters>(ConstantFriction{});
  check<DruckerPrager, DruckerPragerParameters>(InertialFriction{{.grain_size = 5e-3}});
  check<DruckerPrager, DruckerPragerParameters>(RateSofteningFriction{{.softening = soft}});
  check<MohrCoulomb, MohrCoulombParameters, RemembersOpening>(LinearRateFriction{{.time = 1e-2}});
}

TEST_CASE("friction chosen at run time: what a policy refuses is refused, and none is the law's own") {
  const MohrCoulombParameters p{.density = 1540, .young = 20_MPa, .poisson = 0.3, .friction = 20_deg};
  CHECK_THROWS_WITH((MohrCoulomb{p, ForgetsOpening{}, AnyFriction{SofteningFriction{soft}}}),
                    Catch::Contains("must not exceed the law's friction"));
  CHECK(AnyFriction{}.constant());
  CHECK(std::holds_alternative<ConstantFriction>(AnyFriction{}.policy()));
}
