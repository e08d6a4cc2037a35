// Friction and stiffness by point that the library has (rate, pressure, softening): closed forms on driven
// paths.
#include "sand.hpp"

#include "catch.hpp"

using namespace arenite;
using namespace arenite::test;

namespace {

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

TEST_CASE("softening: what the material dilates, to the critical state") {
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

namespace {

/// Constant friction that sums twice the strain it is given.
struct Told {
  template <class T>
  using History = PlasticStrainHistory<T>;
  template <class T, int D>
  T slope(double given, const StrainStep<T, D>&, const History<T>&) const {
    return T(given);
  }
  template <class T>
  void flow(const T& strain, History<T>& history) const {
    history.plastic_strain = history.plastic_strain + T(2) * strain;
  }
};
/// The same, summed by the law.
struct Untold {
  template <class T>
  using History = PlasticStrainHistory<T>;
  template <class T, int D>
  T slope(double given, const StrainStep<T, D>&, const History<T>&) const {
    return T(given);
  }
};

}  // namespace

TEST_CASE("the law sums the plastic strain of a history, unless the policy does") {
  const auto summed = [](const auto& policy) {
    return simple_shear(mohr_coulomb(policy), 10_kPa, 0.1, 1, 1000);
  };
  const auto by_law = summed(Untold{});
  const auto by_policy = summed(Told{});
  // The plastic strain is what the elastic strain leaves of the whole.
  const double shear = mohr_coulomb(Untold{}).elasticity().shear();
  CHECK(by_law.history.plastic_strain ==
        Approx((0.1 - by_law.stress[3] / shear) / std::sqrt(3.0)).epsilon(1e-9));
  CHECK(by_policy.history.plastic_strain == Approx(2 * by_law.history.plastic_strain).epsilon(1e-14));
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

TEST_CASE("softening and rate together contain each of the two") {
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

/// From isotropic stress -p through strains, each component evenly.
auto strained(double p, const Sym<double, 2>& strain, int steps) {
  DrivenPoint<std::remove_const_t<decltype(stiffening)>, 2> point{.stress = {{-p, -p, -p, 0}}};
  DriveStage<2> stage{.steps = steps};
  for (std::size_t i = 0; i < 4; ++i) stage.components[i] = strain_by(strain[i]);
  drive(stiffening, point, stage, [](const auto&) {});
  return point;
}

}  // namespace

TEST_CASE("stiffness by pressure: isotropic compression, its energy, and the speed of waves") {
  const double p0 = 20_kPa, bulk = pyramid.young / (3 * (1 - 2 * pyramid.poisson)), ref = 100_kPa;
  for (const double volume : {-2e-3, 4e-4}) {
    const Sym<double, 2> strain{{volume / 3, volume / 3, volume / 3, 0}};
    const auto once = strained(p0, strain, 2000), twice = strained(p0, strain, 4000),
               begin = strained(p0, {}, 1);
    // dp / dv = K (p / p_ref)^(1/2)
    const double p = square(std::sqrt(p0) - 0.5 * bulk / std::sqrt(ref) * volume);
    CHECK(-2 * twice.stress[0] + once.stress[0] == Approx(p).epsilon(1e-6));
    const auto energy = [](const auto& point) {
      return stiffening.elastic_energy(point.stress, point.history);
    };
    CHECK(2 * (energy(twice) - twice.work) - (energy(once) - once.work) ==
          Approx(energy(begin)).epsilon(1e-6));
    const double there = trace(twice.stress) / -3;
    CHECK(stiffening.wave_modulus(twice.stress, twice.history) ==
          Approx(stiffening.elasticity().wave_modulus() * std::sqrt(there / ref)).epsilon(1e-12));
  }
  const Sym<double, 2> tension{{10, 10, 10, 0}};
  CHECK(stiffening.wave_modulus(tension, NoHistory<double>{}) ==
        Approx(stiffening.elasticity().wave_modulus() * std::sqrt(0.02)).epsilon(1e-12));
  CHECK(stiffening.elastic_energy(tension, NoHistory<double>{}) ==
        Approx(100 / (2 * bulk * std::sqrt(0.02))).epsilon(1e-12));
}

TEST_CASE("stiffness by pressure: what a closed cycle of shear and pressure makes of energy") {
  // Sheared under p_2, unsheared under p_1: W = tau^2 / 2 G_ref (1 / f_2 - 1 / f_1), put in by who moves it.
  const double p1 = 50_kPa, p2 = 100_kPa, tau = 20_kPa;
  const auto work = [&](int steps) {
    DrivenPoint<std::remove_const_t<decltype(stiffening)>, 2> point{.stress = {{-p1, -p1, -p1, 0}}};
    for (const auto& [p, t] : {std::pair{p2, 0.0}, {p2, tau}, {p1, tau}, {p1, 0.0}}) {
      const DriveStage<2> stage{.components = {{stress_to(-p), stress_to(-p), stress_to(-p), stress_to(t)}},
                                .steps = steps};
      drive(stiffening, point, stage, [](const auto&) {});
    }
    return point.work;
  };
  const double exact = tau * tau / (2 * stiffening.elasticity().shear()) * (1 - std::sqrt(2.0));
  CHECK(2 * work(2000) - work(1000) == Approx(exact).epsilon(1e-5));
}

TEST_CASE("stiffness by pressure leaves the strength, and scales the strain to it") {
  const double sin = std::sin(35_deg), ratio = (1 + sin) / (1 - sin);
  CHECK(triaxial(stiffening, 10_kPa, 0.05, 1, 500).stress[1] == Approx(-10_kPa * ratio).epsilon(1e-6));
  // With friction that softens, the plastic strain is what the elastic strain leaves of the whole.
  const MohrCoulomb<ForgetsOpening, SofteningFriction, PressureStiffness> both{
      pyramid, {}, SofteningFriction{{.residual_friction = 31_deg, .decay = 8}}, hypoelastic};
  const auto end = simple_shear(both, 10_kPa, 0.1, 1, 1000);
  const double shear = both.elasticity().shear() * std::sqrt(0.1);
  CHECK(end.history.plastic_strain == Approx((0.1 - end.stress[3] / shear) / std::sqrt(3.0)).epsilon(1e-9));
}

TEST_CASE(
    "stiffness by rate and plastic strain: the path, the waves, and what a closed cycle makes of energy") {
  const RateSofteningFriction kept{
      {.softening = {.residual_friction = 35_deg, .decay = 0}, .friction_per_decade = 0}};
  const RateStiffness by_rate{{.per_decade = 0.1, .residual = 0.6, .decay = 5}};
  using Law = MohrCoulomb<ForgetsOpening, RateSofteningFriction, RateStiffness>;
  const Law law{pyramid, {}, kept, by_rate};
  const double shear = law.elasticity().shear(), gamma = 1e-4;
  const auto sheared = [&](auto& point, double by, double rate) {
    drive(
        law, point,
        DriveStage<2>{
            .components = {{{}, {}, {}, strain_by(by / 2)}}, .duration = std::abs(by) / rate, .steps = 10000},
        [](const auto&) {});
  };
  const auto factor = [](double rate) { return 1 + 0.1 * std::log10(rate / 2.1e-5); };
  DrivenPoint<Law, 2> point{.stress = {{-10_kPa, -10_kPa, -10_kPa, 0}}};
  sheared(point, gamma, 10);
  // The rate of a step counts from the next one on: one step of 10,000 has the moduli of matter at rest.
  CHECK(point.stress[3] == Approx(shear * gamma * factor(10)).epsilon(1e-4));
  CHECK(law.wave_modulus(point.stress, point.history) ==
        Approx(law.elasticity().wave_modulus() * factor(10)).epsilon(1e-12));
  const double tau = point.stress[3];
  sheared(point, -tau / (shear * factor(0.1)), 0.1);
  CHECK(std::abs(point.stress[3]) <= 1e-4 * tau);
  CHECK(point.work == Approx(tau * tau / (2 * shear) * (1 / factor(10) - 1 / factor(0.1))).epsilon(1e-3));
  // With plastic strain the moduli fall to the residual ones.
  sheared(point, 0.5, 10);
  const double left = std::exp(-5 * point.history.plastic_strain);
  CHECK(law.wave_modulus(point.stress, point.history) ==
        Approx(law.elasticity().wave_modulus() * (0.6 + (factor(10) - 0.6) * left)).epsilon(1e-12));
}
