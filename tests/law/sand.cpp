// Friction by point that the library has (rate, pressure, softening): closed forms on driven paths, the same
// bits as the constant friction when turned off and in packs, no plastic work below zero, refusals.
#include <arenite/core/lanes.hpp>
#include <arenite/core/units.hpp>
#include <arenite/law/drive.hpp>
#include <arenite/law/drucker_prager.hpp>
#include <arenite/law/inertial_friction.hpp>
#include <arenite/law/linear_rate_friction.hpp>
#include <arenite/law/logarithmic_friction.hpp>
#include <arenite/law/mohr_coulomb.hpp>
#include <arenite/law/rate_softening_friction.hpp>
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

/// Strength at a constant rate by a policy whose tan(phi) is slope(rate, mean pressure).
template <class Friction, class Slope>
void check_strength(const Friction& friction, double rate, const Slope& slope) {
  const double p = 10_kPa;
  // Without dilatancy the mean of the in-plane stresses stays: tau = p sin(phi).
  const double sin = sin_of_slope(slope(rate, p)), eta = 6 * sin / (std::sqrt(3.0) * (3 - sin));
  CHECK(simple_shear(mohr_coulomb(friction), p, 0.05, rate, 500).stress[3] == Approx(p * sin).epsilon(1e-6));
  CHECK(simple_shear(drucker_prager(friction), p, 0.05, rate, 500).stress[3] ==
        Approx(p * eta).epsilon(1e-6));
  // At constant volume the shear rate is sqrt(3) of the axial strain rate. The mean pressure follows.
  double ratio = 3;
  for (int k = 0; k < 100; ++k) {
    const double s = sin_of_slope(slope(std::sqrt(3.0) * rate, p * (ratio + 2) / 3));
    ratio = (1 + s) / (1 - s);
  }
  CHECK(triaxial(mohr_coulomb(friction), p, 0.05, rate, 500).stress[1] == Approx(-p * ratio).epsilon(1e-6));
  CHECK(triaxial(drucker_prager(friction), p, 0.05, rate, 500).stress[1] == Approx(-p * ratio).epsilon(1e-6));
}

}  // namespace

TEST_CASE("friction by rate: the strength in simple shear and in triaxial compression") {
  for (const double rate : {1e-6, 1.0, 50.0, 400.0}) {
    const double given = std::tan(35_deg);
    check_strength(LinearRateFriction{{.time = 1e-3}}, rate,
                   [&](double r, double) { return given + 1e-3 * r; });
    check_strength(
        InertialFriction{{.rise = 0.3, .reference_inertia = 0.2, .grain_size = 1e-3, .grain_density = 2600}},
        rate, [&](double r, double p) {
          const double inertia = r * 1e-3 / std::sqrt(p / 2600);
          return given + 0.3 / (0.2 / inertia + 1);
        });
    check_strength(LogarithmicFriction{{.per_decade = 0.03, .reference_rate = 1e-4}}, rate,
                   [&](double r, double) {
                     return std::tan(35_deg * (1 + 0.03 * std::max(std::log10(r / 1e-4), 0.0)));
                   });
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

const SofteningParameters soft{.residual_friction = 31_deg, .residual_dilatancy = 1_deg, .decay = 8};

/// A value that falls from its peak to the residual one.
double softened(double peak, double residual, double plastic) {
  return residual + (peak - residual) * std::exp(-soft.decay * plastic);
}

/// Simple shear without dilatancy with `peak` angle of friction, rad: tau = p sin(phi), with phi of the
/// plastic strain (gamma - tau / G) / sqrt(3). The step's friction is that of its begin, so that the error
/// falls with the step: extrapolated from two.
template <class Friction>
void check_softening(const Friction& friction, double rate, double peak) {
  const auto law = mohr_coulomb(friction, [] {
    auto p = pyramid;
    p.dilatancy = 0;
    return p;
  }());
  for (const double gamma : {0.02, 0.1, 0.6}) {
    double tau = 0;
    for (int k = 0; k < 200; ++k)
      tau = 10_kPa * std::sin(softened(peak, soft.residual_friction,
                                       (gamma - tau / law.elasticity().shear()) / std::sqrt(3.0)));
    const double once = simple_shear(law, 10_kPa, gamma, rate, 2000).stress[3],
                 twice = simple_shear(law, 10_kPa, gamma, rate, 4000).stress[3];
    CHECK(2 * twice - once == Approx(tau).epsilon(1e-6));
  }
}

}  // namespace

TEST_CASE("softening: the stress in simple shear, without rate and with it") {
  auto constant_volume = soft;
  constant_volume.residual_dilatancy = 0;
  check_softening(SofteningFriction{constant_volume}, 1, 35_deg);
  const RateSofteningFriction both{{.softening = constant_volume, .friction_per_decade = 0.03}};
  for (const double rate : {1e-6, 1.0, 100.0})
    check_softening(both, rate, 35_deg * (1 + 0.03 * std::max(std::log10(rate / 2.1e-5), 0.0)));
}

TEST_CASE("softening: what the matter dilates, to the critical state") {
  // Flow of Drucker-Prager: the volume grows by sqrt(3) eta' per plastic strain, eta' of the dilatancy then.
  auto c = cone;
  c.dilatancy = 12_deg;
  const auto per_strain = [&](double psi) { return 6 * std::sin(psi) / (3 - std::sin(psi)); };
  const auto law = drucker_prager(SofteningFriction{soft}, c);
  const auto dilation = [&](int steps) { return triaxial(law, 10_kPa, 0.5, 1, steps); };
  const auto once = dilation(4000), twice = dilation(8000);
  const double end = 2 * twice.history.plastic_strain - once.history.plastic_strain;
  double integral = 0;
  constexpr int parts = 1000;
  for (int k = 0; k <= parts; ++k)
    integral += (k == 0 || k == parts ? 1
                 : k % 2 == 0         ? 2
                                      : 4) *
                end / (3 * parts) * per_strain(softened(12_deg, 1_deg, end * k / parts));
  CHECK(2 * twice.dilation - once.dilation == Approx(integral).epsilon(1e-6));

  // Mohr-Coulomb on the edge of triaxial compression: axial -2, lateral k' and k'.
  auto p = pyramid;
  p.dilatancy = 12_deg;
  auto critical = soft;
  critical.residual_dilatancy = 0;
  critical.decay = 40;
  const auto edge = triaxial(mohr_coulomb(SofteningFriction{critical}, p), 10_kPa, 0.9, 1, 20000);
  const auto edge_twice = triaxial(mohr_coulomb(SofteningFriction{critical}, p), 10_kPa, 0.9, 1, 40000);
  double total = 0;
  for (int k = 0; k <= 20 * parts; ++k) {
    const double sin = std::sin(12_deg * std::exp(-40 * 0.9 * k / (20 * parts)));
    const double flow = (1 + sin) / (1 - sin);
    total += (k == 0 || k == 20 * parts ? 1
              : k % 2 == 0              ? 2
                                        : 4) *
             0.9 / (60 * parts) * 3 * (flow - 1) / (flow + 2);
  }
  CHECK(2 * edge_twice.dilation - edge.dilation == Approx(total).epsilon(1e-6));
  const double sin = std::sin(31_deg);
  CHECK(edge.stress[1] == Approx(-10_kPa * (1 + sin) / (1 - sin)).epsilon(1e-6));
}

TEST_CASE("the dilatancy of a step is that of its rate and of the plastic strain before it") {
  auto c = cone;
  c.dilatancy = 8_deg;
  const RateSofteningFriction both{{.softening = soft, .dilatancy_per_decade = 0.1}};
  const auto law = drucker_prager(both, c);
  DrivenPoint<std::remove_const_t<decltype(law)>, 2> point{.stress = {{-10_kPa, -10_kPa, -10_kPa, 0}}},
      before;
  for (const double rate : {0.1, 20.0}) {
    before = point;
    const auto check = [&](const auto& now) {
      const double strain = now.history.plastic_strain - before.history.plastic_strain;
      const double peak = 8_deg * (1 + 0.1 * std::log10(now.history.shear_rate / 2.1e-5));
      const double sin = std::sin(softened(peak, 1_deg, before.history.plastic_strain));
      REQUIRE(now.dilation - before.dilation ==
              Approx(6 * sin / (3 - sin) * strain).epsilon(1e-8).margin(1e-14));
      before = now;
    };
    drive(
        law, point,
        DriveStage<2>{.components = {{{}, stress_to(-10_kPa), {}, strain_by(0.05)}}, .duration = 0.1 / rate},
        check);
  }
  CHECK(point.dilation > 0.01);
}

TEST_CASE("the displacement over which a band of one cell softens does not depend on the cells") {
  const auto slope_after = [](double cell, double slip) {
    auto p = soft;
    p.cell_size = cell;
    p.reference_size = 5e-3;
    const SofteningFriction friction{p};
    PlasticStrainHistory<double> history{slip / cell};
    return friction.slope({35_deg, 12_deg, 0, 0}, StrainStep<double, 2>{}, Sym<double, 2>{}, history);
  };
  CHECK(slope_after(5e-3, 1e-3) == Approx(std::tan(softened(35_deg, 31_deg, 0.2))).epsilon(1e-12));
  for (const double cell : {1e-3, 2e-2})
    CHECK(slope_after(cell, 1e-3) == Approx(slope_after(5e-3, 1e-3)).epsilon(1e-12));
}

TEST_CASE("softening and rate together contain softening alone and rate alone") {
  auto p = pyramid;
  p.dilatancy = 12_deg;
  const RateSofteningFriction no_rate{
      {.softening = soft, .friction_per_decade = 0, .dilatancy_per_decade = 0}};
  CHECK(triaxial(mohr_coulomb(no_rate, p), 10_kPa, 0.05, 10, 500).stress[1] ==
        triaxial(mohr_coulomb(SofteningFriction{soft}, p), 10_kPa, 0.05, 10, 500).stress[1]);
  auto kept = soft;
  kept.decay = 0;
  const RateSofteningFriction no_softening{{.softening = kept, .dilatancy_per_decade = 0}};
  CHECK(triaxial(mohr_coulomb(no_softening, p), 10_kPa, 0.05, 10, 500).stress[1] ==
        Approx(triaxial(mohr_coulomb(LogarithmicFriction{}, p), 10_kPa, 0.05, 10, 500).stress[1])
            .epsilon(1e-12));
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
  check_off(InertialFriction{{.rise = 0}});
  check_off(LogarithmicFriction{{.per_decade = 0}});
  check_off(SofteningFriction{{.residual_friction = 20_deg, .decay = 0}});
  check_off(RateSofteningFriction{{.softening = {.residual_friction = 20_deg, .decay = 0},
                                   .friction_per_decade = 0,
                                   .dilatancy_per_decade = 0}});
}

TEST_CASE("packs compute what scalars do") {
  check_all_packs(LinearRateFriction{{.time = 1e-2, .smoothing = 1e-3}});
  check_all_packs(InertialFriction{{.grain_size = 5e-3}});
  check_all_packs(LogarithmicFriction{});
  check_all_packs(SofteningFriction{soft});
  check_all_packs(RateSofteningFriction{{.softening = soft}});
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
  const DrivenPoint<MohrCoulomb<>, 2> start{.stress = {{-1, -1, -1, 0}}};
  const DriveStage<2> beyond{.components = {{stress_to(-1), stress_to(-9), stress_to(-1), {}}}};
  CHECK(message<run_error>([&] { drive(MohrCoulomb{pyramid}, std::vector{beyond}, start); }).substr(0, 12) ==
        "drive: step ");
}
