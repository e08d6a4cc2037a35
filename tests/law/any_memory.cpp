// A law whose memory and stiffness are chosen at run time has the bits of the law that is compiled for them.
#include <arenite/arenite.hpp>
#include <arenite/law/frictional/any_friction.hpp>
#include <arenite/law/frictional/any_memory.hpp>
#include <arenite/law/frictional/any_stiffness.hpp>

#include "bits.hpp"
#include "catch.hpp"

using namespace arenite;
using namespace arenite::test;

namespace {

const SofteningParameters soft{.residual_friction = 25_deg, .decay = 8};
const RateSofteningFriction softening{{.softening = soft, .smoothing = 1e-3}};

template <class Memory, class Stiffness>
void check(const Memory& memory, const Stiffness& stiffness) {
  for (const double cohesion : {0.0, 2e3}) {
    CAPTURE(cohesion);
    const MohrCoulombParameters p{.density = 1540,
                                  .young = 20_MPa,
                                  .poisson = 0.3,
                                  .friction = 40_deg,
                                  .cohesion = cohesion,
                                  .dilatancy = 10_deg};
    const MohrCoulomb exact{p, memory, softening, stiffness};
    const MohrCoulomb any{p, AnyMemory{memory}, AnyFriction{softening}, AnyStiffness{stiffness}};
    compare_bits(exact, any, detail::apex(40_deg, cohesion));
  }
}

}  // namespace

TEST_CASE("memory chosen at run time: the bits of each policy of the list, and what is open") {
  Memories::each([]<class P>(std::type_identity<P>) { check(P{}, ConstantStiffness{}); });
  const AnyMemory::History<double> open{{.opening = 0.1}};
  CHECK(AnyMemory{RemembersOpening{}}.is_open(open));
  CHECK_FALSE(AnyMemory{}.is_open(open));
}

TEST_CASE("stiffness chosen at run time: the bits of each policy of the list") {
  Stiffnesses::each([]<class P>(std::type_identity<P>) { check(ForgetsOpening{}, P{}); });
}

TEST_CASE("memory and stiffness chosen at run time: what does not go together is refused") {
  const MohrCoulombParameters p{
      .density = 1540, .young = 20_MPa, .poisson = 0.3, .friction = 40_deg, .cohesion = 1e3, .tension = 0};
  CHECK_NOTHROW(MohrCoulomb{p, AnyMemory{}});
  CHECK_THROWS_WITH((MohrCoulomb{p, AnyMemory{RemembersOpening{}}}), Catch::Contains("leave tension out"));

  const AnyFriction rate{LinearRateFriction{}};
  CHECK_NOTHROW(MohrCoulomb{p, ForgetsOpening{}, rate, AnyStiffness{PressureStiffness{}}});
  CHECK_NOTHROW(MohrCoulomb{p, ForgetsOpening{}, AnyFriction{softening}, AnyStiffness{RateStiffness{}}});
  CHECK_THROWS_WITH((MohrCoulomb{p, ForgetsOpening{}, rate, AnyStiffness{RateStiffness{}}}),
                    Catch::Contains("must keep"));
  CHECK_THROWS_WITH((MohrCoulomb{p, ForgetsOpening{}, rate, RateStiffness{}}), Catch::Contains("must keep"));
}
