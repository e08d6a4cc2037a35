// Friction by point that the library has (rate, pressure, softening): closed forms on driven paths, the same
// bits as the constant friction when turned off and in packs, no plastic work below zero, refusals.
#include <arenite/core/lanes.hpp>
#include <arenite/core/units.hpp>
#include <arenite/law/drive.hpp>
#include <arenite/law/drucker_prager.hpp>
#include <arenite/law/linear_rate_friction.hpp>
#include <arenite/law/mohr_coulomb.hpp>
#include <cstring>

#include "catch.hpp"
#include "message.hpp"
#include "states.hpp"

using namespace arenite;
using namespace arenite::test;

namespace {

const MohrCoulombParameters pyramid{.density = 1540, .young = 20_MPa, .poisson = 0.3, .friction = 35_deg};
const DruckerPragerParameters cone{.density = 1540, .young = 20_MPa, .poisson = 0.3, .friction = 35_deg};

template <class Friction>
auto mohr_coulomb(const Friction& friction, const MohrCoulombParameters& p = pyramid) {
  return MohrCoulomb<ForgetsOpening, Friction>{p, {}, friction};
}
template <class Friction>
auto drucker_prager(const Friction& friction, const DruckerPragerParameters& p = cone) {
  return DruckerPrager<ForgetsOpening, Friction>{p, {}, friction};
}

/// Simple shear in plane strain by `gamma` at a rate, 1/s, under constant mean stress -p: all normal stresses
/// begin alike and the matter does not dilate, so that it is at constant volume.
template <class Law>
auto simple_shear(const Law& law, double p, double gamma, double rate, int steps) {
  DrivenPoint<Law, 2> point{.stress = {{-p, -p, -p, 0}}};
  drive(law, point,
        DriveStage<2>{
            .components = {{{}, {}, {}, strain_by(gamma / 2)}}, .duration = gamma / rate, .steps = steps},
        [](const auto&) {});
  return point;
}

/// Triaxial compression along y at a rate of the axial strain, 1/s, at a cell pressure.
template <class Law>
auto triaxial(const Law& law, double pressure, double shortening, double rate, int steps) {
  DrivenPoint<Law, 3> point{.stress = {{-pressure, -pressure, -pressure, 0, 0, 0}}};
  const auto cell = stress_to(-pressure);
  drive(law, point,
        DriveStage<3>{.components = {{cell, strain_by(-shortening), cell, {}, {}, {}}},
                      .duration = shortening / rate,
                      .steps = steps},
        [](const auto&) {});
  return point;
}

double sin_of_slope(double slope) { return std::sin(std::atan(slope)); }

}  // namespace

TEST_CASE("friction by rate: the strength in simple shear and in triaxial compression") {
  const double slope = std::tan(35_deg);
  const LinearRateFriction linear{{.time = 1e-3}};
  for (const double rate : {1e-6, 1.0, 50.0, 400.0}) {
    const double sin = sin_of_slope(slope + 1e-3 * rate);
    // Without dilatancy the mean of the in-plane stresses stays: tau = p sin(phi).
    const auto shear = simple_shear(mohr_coulomb(linear), 10_kPa, 0.05, rate, 500);
    CHECK(shear.stress[3] == Approx(10_kPa * sin).epsilon(1e-6));
    const double eta = 6 * sin / (std::sqrt(3.0) * (3 - sin));
    CHECK(simple_shear(drucker_prager(linear), 10_kPa, 0.05, rate, 500).stress[3] ==
          Approx(10_kPa * eta).epsilon(1e-6));
    // At constant volume the shear rate is sqrt(3) of the axial strain rate.
    const double sin_triaxial = sin_of_slope(slope + 1e-3 * std::sqrt(3.0) * rate);
    const double ratio = (1 + sin_triaxial) / (1 - sin_triaxial);
    CHECK(triaxial(mohr_coulomb(linear), 10_kPa, 0.05, rate, 500).stress[1] ==
          Approx(-10_kPa * ratio).epsilon(1e-6));
    CHECK(triaxial(drucker_prager(linear), 10_kPa, 0.05, rate, 500).stress[1] ==
          Approx(-10_kPa * ratio).epsilon(1e-6));
  }
}

TEST_CASE("a smoothed rate follows a sudden one exponentially, whatever the step") {
  const LinearRateFriction linear{{.time = 1e-3, .smoothing = 2e-3}};
  for (const int steps : {1, 10, 1000}) {
    const auto end = simple_shear(mohr_coulomb(linear), 10_kPa, 0.3, 100, steps);  // 3 ms
    CHECK(end.history.shear_rate == Approx(100 * (1 - std::exp(-1.5))).epsilon(1e-12));
    const double slope = std::tan(35_deg) + 1e-3 * end.history.shear_rate;
    CHECK(end.stress[3] == Approx(10_kPa * sin_of_slope(slope)).epsilon(1e-6));
  }
}

namespace {

/// A step at random, from a stress at random, in each lane.
template <class P, int D>
struct Lanes {
  Sym<P, D> stress;
  StrainStep<P, D> step;
};

template <class P>
void set(P& to, int k, double value) {
  if constexpr (is_pack<P>)
    to.set(k, static_cast<typename P::scalar>(value));
  else
    to = static_cast<P>(value);
}
template <class P>
auto lane(const P& value, int k) {
  if constexpr (is_pack<P>)
    return value[k];
  else
    return value;
}

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

/// Packs compute what scalars do: to the bit, unless packs of this instruction set use estimates of
/// reciprocals or the compiler contracts products and sums.
template <class P, int D, class Law>
void check_packs(const Law& law) {
  using T = typename P::scalar;
  std::mt19937 random(6);
  for (int round = 0; round < 100; ++round) {
    typename Law::template History<P> history{};
    auto [stress, step] = random_lanes<P, D>(random);
    const auto begin = stress;
    for (int k = 0; k < 10; ++k) law.update(stress, step, history);
    for (int l = 0; l < lane_count<P>; ++l) {
      StrainStep<T, D> alone{
          .strain = Sym<T, D>::each([&, &s = step](std::size_t i) { return s.strain[i][l]; }), .dt = step.dt};
      for (std::size_t i = 0; i < alone.spin.size(); ++i) alone.spin[i] = step.spin[i][l];
      auto expected = Sym<T, D>::each([&](std::size_t i) { return begin[i][l]; });
      typename Law::template History<T> of_one{};
      for (int k = 0; k < 10; ++k) law.update(expected, alone, of_one);
      for (std::size_t i = 0; i < stress.size; ++i) {
#if defined(__AVX512F__) || defined(__FMA__)
        REQUIRE(std::abs(stress[i][l] - expected[i]) <= 1e5 * 1e3 * std::numeric_limits<T>::epsilon());
#else
        REQUIRE(same_bits(stress[i][l], expected[i]));
#endif
      }
    }
  }
}

template <class Friction>
void check_all_packs(const Friction& friction) {
  auto p = pyramid;
  auto c = cone;
  p.dilatancy = c.dilatancy = 9_deg;
  p.cohesion = 1_kPa;
  p.tension = 300;
  check_packs<Pack<double, 2>, 3>(mohr_coulomb(friction, p));
  check_packs<PackPair<Pack<double, 4>>, 2>(mohr_coulomb(friction, p));
  check_packs<Pack<float, 8>, 3>(drucker_prager(friction, c));
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
      const auto trial = stress + law.elasticity().stress(step.strain);
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
}

TEST_CASE("packs compute what scalars do") { check_all_packs(LinearRateFriction{{.time = 1e-2}}); }

TEST_CASE("no plastic work below zero") {
  check_all_plastic_work(LinearRateFriction{{.time = 1e-3, .smoothing = 1e-3}});
  check_all_plastic_work(LinearRateFriction{{.time = 1e9}});
}

TEST_CASE("constants that make no sense are refused") {
  CHECK(message([] { LinearRateFriction{{.time = -1}}; }) ==
        "LinearRateFriction.time = -1: must not be negative (s)");
  CHECK(message([] { LinearRateFriction{{.smoothing = -1}}; }) ==
        "LinearRateFriction.smoothing = -1: must not be negative (s)");
}
