// Rules that each friction and stiffness by point keeps: the same bits as the plain law when turned off, no
// plastic work below zero, refusals, and states that are saved and restored. Packs: packs.cpp.
#include <cstring>

#include "catch.hpp"
#include "message.hpp"
#include "sand.hpp"
#include "state_buffer.hpp"
#include "states.hpp"

using namespace arenite;
using namespace arenite::test;

namespace {

/// A step at random, from a stress at random, in each lane.
template <class P, int D>
struct Lanes {
  Sym<P, D> stress;
  StrainStep<P, D> step;
};

template <class P, int D>
Lanes<P, D> random_lanes(std::mt19937& random) {
  std::uniform_real_distribution<double> uniform(-1, 1);
  Lanes<P, D> lanes;
  lanes.step.dt = 1e-4;
  for (int k = 0; k < lane_count<P>; ++k) {
    const auto s = trial_state<D>(random, 1e3);
    for (std::size_t i = 0; i < s.size; ++i) {
      set(lanes.stress[i], k, s[i]);
      set(lanes.step.strain[i], k, 1e-3 * uniform(random));
    }
    for (auto& spin : lanes.step.spin) set(spin, k, 0.1 * uniform(random));
  }
  return lanes;
}

template <class T>
bool same_bits(const T& a, const T& b) {
  return std::memcmp(&a, &b, sizeof(T)) == 0;
}

/// Ten steps by both laws give the same bits.
template <class P, int D, class A, class B>
void check_same_bits(const A& plain, const B& off) {
  std::mt19937 random(5);
  for (int round = 0; round < 100; ++round) {
    typename A::template History<P> nothing{};
    typename B::template History<P> history{};
    auto [stress, step] = random_lanes<P, D>(random);
    auto same = stress;
    for (int k = 0; k < 10; ++k) {
      const auto a = plain.update(stress, step, nothing);
      const auto b = off.update(same, step, history);
      for (int l = 0; l < lane_count<P>; ++l) {
        for (std::size_t i = 0; i < stress.size; ++i)
          REQUIRE(same_bits(lane(stress[i], l), lane(same[i], l)));
        REQUIRE(same_bits(lane(a.opening, l), lane(b.opening, l)));
        REQUIRE(same_bits(lane(a.dilation, l), lane(b.dilation, l)));
      }
    }
  }
}

template <class Friction>
void check_off(const Friction& off) {
  auto p = pyramid;
  auto c = cone;
  p.dilatancy = c.dilatancy = 9_deg;
  p.cohesion = c.cohesion = 1_kPa;
  p.tension = 300;
  check_same_bits<double, 3>(MohrCoulomb{p}, mohr_coulomb(off, p));
  check_same_bits<float, 2>(MohrCoulomb{p}, mohr_coulomb(off, p));
  check_same_bits<Pack<double, 4>, 2>(MohrCoulomb{p}, mohr_coulomb(off, p));
  check_same_bits<double, 2>(DruckerPrager{c}, drucker_prager(off, c));
  check_same_bits<Pack<float, 8>, 3>(DruckerPrager{c}, drucker_prager(off, c));
}

/// Plastic work of random steps is never negative, and no number infinite.
template <class P, class Law>
void check_plastic_work(const Law& law, double extremes) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> uniform(-1, 1);
  for (int round = 0; round < 300; ++round) {
    Sym<P, 3> stress;
    typename Law::template History<P> history{};
    for (int k = 0; k < 20; ++k) {
      StrainStep<P, 3> step;
      step.dt = std::pow(10, -4 + 2 * uniform(random));
      const double size = std::pow(10, -4 + extremes * uniform(random)), volume = 0.3 * uniform(random);
      for (std::size_t i = 0; i < 6; ++i)
        step.strain[i] = static_cast<P>(size * (uniform(random) + (i < 3 ? volume : 0)));
      P factor(1);
      if constexpr (stiffness_varies<Law, P, 3>)
        factor = law.wave_modulus(stress, history) / static_cast<P>(law.wave_modulus());
      const auto trial = stress + law.elasticity().stress(step.strain * factor);
      law.update(stress, step, history);
      REQUIRE(std::apply([](const auto&... member) { return (std::isfinite(member) && ...); },
                         history.members()));
      REQUIRE(std::isfinite(contract(stress, stress)));
      const auto plastic = trial - stress;  // the stiffness times the plastic strain
      const double dev =
          static_cast<double>(contract(stress, deviator(plastic))) / (2 * law.elasticity().shear());
      const double vol = static_cast<double>(trace(stress) * trace(plastic)) / (9 * law.elasticity().bulk());
      const double scale = static_cast<double>(contract(trial, trial)) / law.elasticity().shear();
      REQUIRE(dev + vol >= -1e3 * static_cast<double>(std::numeric_limits<P>::epsilon()) * scale);
    }
  }
}

template <class Friction>
void check_all_plastic_work(const Friction& friction) {
  auto p = pyramid;
  auto c = cone;
  p.dilatancy = c.dilatancy = 35_deg;
  c.cone = Cone::extension;
  for (const double extremes : {2.0, 5.0}) {
    check_plastic_work<double>(mohr_coulomb(friction), extremes);
    check_plastic_work<double>(mohr_coulomb(friction, p), extremes);
    check_plastic_work<float>(mohr_coulomb(friction, p), extremes);
    check_plastic_work<double>(drucker_prager(friction), extremes);
    check_plastic_work<double>(drucker_prager(friction, c), extremes);
  }
}

}  // namespace

TEST_CASE("turned off, a policy by point gives the same bits as constant friction") {
  check_off(LinearRateFriction{{.time = 0}});
  check_off(InertialFriction{{.rise = 0}});
  check_off(LogarithmicFriction{{.per_decade = 0}});
  check_off(SofteningFriction{{.residual_friction = 20_deg, .decay = 0}});
  const PressureStiffness same{{.exponent = 0}};
  check_same_bits<double, 3>(MohrCoulomb{pyramid},
                             MohrCoulomb{pyramid, ForgetsOpening{}, ConstantFriction{}, same});
  check_same_bits<Pack<float, 4>, 2>(DruckerPrager{cone},
                                     DruckerPrager{cone, ForgetsOpening{}, ConstantFriction{}, same});
  check_off(RateSofteningFriction{{.softening = {.residual_friction = 20_deg, .decay = 0},
                                   .friction_per_decade = 0,
                                   .dilatancy_per_decade = 0}});
}

TEST_CASE("no plastic work below zero") {
  check_all_plastic_work(LinearRateFriction{{.time = 1e-3, .smoothing = 1e-3}});
  check_all_plastic_work(LinearRateFriction{{.time = 1e9}});
  check_all_plastic_work(InertialFriction{{.rise = 1e3, .reference_inertia = 1e-9, .grain_size = 1}});
  check_all_plastic_work(LogarithmicFriction{{.per_decade = 10}});
  SofteningParameters extreme{.residual_friction = 1e-9, .decay = 1e4};
  check_all_plastic_work(SofteningFriction{extreme});
  check_all_plastic_work(
      RateSofteningFriction{{.softening = extreme, .friction_per_decade = 0, .dilatancy_per_decade = 5}});
  check_plastic_work<double>(stiffening, 5.0);
  auto p = pyramid;
  p.dilatancy = 35_deg;
  check_plastic_work<float>(MohrCoulomb{p, ForgetsOpening{}, ConstantFriction{},
                                        PressureStiffness{{.exponent = 1, .lowest_pressure = 1e-3}}},
                            2.0);
}

TEST_CASE("constants that make no sense are refused") {
  CHECK(message([] { LinearRateFriction{{.time = -1}}; }) ==
        "LinearRateFriction.time = -1: must not be negative (s)");
  CHECK(message([] { LinearRateFriction{{.smoothing = -1}}; }) ==
        "LinearRateFriction.smoothing = -1: must not be negative (s)");
  CHECK(message([] { InertialFriction{{.rise = -0.1}}; }) ==
        "InertialFriction.rise = -0.1: must not be negative");
  CHECK(message([] { InertialFriction{{.grain_size = 0}}; }) ==
        "InertialFriction.grain_size = 0: must be positive (m)");
  CHECK(message([] { LogarithmicFriction{{.reference_rate = 0}}; }) ==
        "LogarithmicFriction.reference_rate = 0: must be positive (1/s)");
  CHECK(message([] { SofteningFriction{{.decay = 8}}; }) ==
        "SofteningFriction.residual_friction = nan: must be given");
  CHECK(
      message([] { SofteningFriction{{.residual_friction = 0.5, .decay = 8, .cell_size = 0.01}}; }) ==
      "SofteningFriction.reference_size = 0: must be positive (m) where cell_size is, and 0 where it is not");
  const SofteningFriction too_strong{{.residual_friction = 0.7, .decay = 8}};
  CHECK(message([&] { mohr_coulomb(too_strong); }) ==
        "SofteningFriction.residual_friction = 0.7: must not exceed the law's friction");
  const SofteningFriction too_loose{{.residual_friction = 0.5, .residual_dilatancy = 0.1, .decay = 8}};
  CHECK(message([&] { drucker_prager(too_loose); }) ==
        "SofteningFriction.residual_dilatancy = 0.1: must not exceed the law's dilatancy");
  CHECK(message([] { PressureStiffness{{.exponent = 1.5}}; }) ==
        "PressureStiffness.exponent = 1.5: must lie in [0, 1]");
  CHECK(message([] { RateStiffness{{.residual = 0}}; }) == "RateStiffness.residual = 0: must lie in (0, 1]");
  CHECK(message([] { PressureStiffness{{.lowest_pressure = 0}}; }) ==
        "PressureStiffness.lowest_pressure = 0: must be positive (Pa)");
  const DrivenPoint<MohrCoulomb<>, 2> start{.stress = {{-1, -1, -1, 0}}};
  const DriveStage<2> beyond{.components = {{stress_to(-1), stress_to(-9), stress_to(-1), {}}}};
  CHECK(message<run_error>([&] { drive(MohrCoulomb{pyramid}, std::vector{beyond}, start); }).substr(0, 12) ==
        "drive: step ");
}

TEST_CASE(
    "a scene of sand with rate, softening, stiffness and memory: restored it continues with the same bits") {
  const auto make = [] {
    using Sand = MohrCoulomb<RemembersOpening, RateSofteningFriction, PressureStiffness>;
    auto p = pyramid;
    p.dilatancy = 10_deg;
    const Sand sand{
        p, {}, RateSofteningFriction{{.softening = soft, .smoothing = 1e-3}}, PressureStiffness{}};
    return Scene{PlaneStrain{},
                 CartesianGrid<2>{{.lower = {0, 0}, .upper = {1, 0.6}, .cell = 0.05}},
                 Numerics<QuadraticBSpline>{},
                 bodies(fill<"sand">(Box{{0., 0.}, {0.3, 0.4}}, sand,
                                     {.per_cell = 4, .stress = Geostatic{.surface = 0.4, .k0 = 0.5}})),
                 walls(bottom(fixed), left(symmetry({1, 0, 0}))),
                 gravity({0, -9.81})};
  };
  const auto steps = [](auto& scene, int count) {
    for (int k = 0; k < count; ++k) step(scene, 0.4 * stable_step(scene));
  };
  auto whole = make(), restored = make();
  steps(whole, 150);
  const StateBuffer middle(whole);
  CHECK(middle.has("bodies/sand/points/history/opening"));
  CHECK(middle.has("bodies/sand/points/history/shear_rate"));
  CHECK(middle.has("bodies/sand/points/history/plastic_strain"));
  const auto& plastic = whole.body<"sand">().points.history[2];
  CHECK(*std::max_element(plastic.begin(), plastic.end()) > 1e-4);
  middle.restore(restored);
  steps(whole, 50);
  steps(restored, 50);
  CHECK(StateBuffer::first_difference(StateBuffer(restored), StateBuffer(whole)) == "");
}
