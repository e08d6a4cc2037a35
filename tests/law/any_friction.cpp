// A law whose friction is chosen at run time has the bits of the law that is compiled for that policy.
#include <arenite/arenite.hpp>
#include <arenite/law/frictional/any_friction.hpp>

#include "bits.hpp"
#include "catch.hpp"

using namespace arenite;
using namespace arenite::test;

namespace {

template <template <class, class, class> class Law, class Parameters, class Memory = ForgetsOpening,
          class Friction>
void check(const Friction& friction) {
  for (const double cohesion : {0.0, 2e3})
    for (const double dilatancy : {0_deg, 10_deg})
      for (const double tension : {std::numeric_limits<double>::infinity(), 300.0}) {
        if (Memory::remembers() && std::isfinite(tension)) continue;
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
        compare_bits(exact, any, apex);
        const auto names = history_names<typename decltype(any)::template History<double>>;
        for (const char* kept : {"shear_rate", "plastic_strain"})
          CHECK(std::find(names.begin(), names.end(), kept) != names.end());
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

TEST_CASE("friction chosen at run time: the bits of each policy of the list") {
  Frictions::each([]<class P>(std::type_identity<P>) {
    if constexpr (std::is_default_constructible_v<P>) check<MohrCoulomb, MohrCoulombParameters>(P{});
  });
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
