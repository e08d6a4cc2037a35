// A law's result for a point is independent of other points: the same bits in packs of any width, beside any
// other points, for every law; and no result lies outside its yield surface.
#include <algorithm>
#include <arenite/arenite.hpp>
#include <bit>
#include <cstdint>
#include <numeric>
#include <vector>

#include "catch.hpp"
#include "states.hpp"

using namespace arenite;
using namespace arenite::test;

namespace {

template <class T>
using Bits = std::conditional_t<sizeof(T) == 8, std::uint64_t, std::uint32_t>;

/// A point before a step, and the strain and spin of the step.
template <int D>
struct Before {
  Sym<double, D> stress, strain;
  std::array<double, D == 2 ? 1 : 3> spin{};
  std::array<double, 16> history{};  // by member
};

/// In tension and compression, on edges and near the apex; strained by up to three times what it can carry;
/// sheared, open and fast, or fresh.
template <int D>
std::vector<Before<D>> random_points(std::size_t count, double apex) {
  std::mt19937 random(12);
  std::uniform_real_distribution<double> uniform(-1, 1);
  std::vector<Before<D>> points(count);
  for (auto& p : points) {
    p.stress = trial_state<D>(random, apex);
    const double size = std::pow(10, -4 + uniform(random)),
                 volume = random() % 3 == 0 ? 5 * uniform(random) : 0;
    for (std::size_t i = 0; i < p.strain.size; ++i)
      p.strain[i] = size * (uniform(random) + (i < 3 ? volume : 0));
    for (double& w : p.spin) w = 0.1 * uniform(random);
    const bool fresh = random() % 2 == 0;
    for (double& h : p.history) h = fresh ? 0 : std::pow(10, -1.5 + 1.5 * uniform(random));
  }
  return points;
}

inline constexpr double time_step = 1e-4;  // s

/// Bits of a point after the step: stress, history, opening, dilation.
template <class T>
using After = std::vector<Bits<T>>;

/// The points of a pack, which `which` numbers, updated at once.
template <class P, int D, class Law>
void update(const Law& law, const std::vector<Before<D>>& points, const std::vector<std::size_t>& which,
            std::vector<After<scalar_of<P>>>& after) {
  using T = scalar_of<P>;
  Sym<P, D> stress;
  StrainStep<P, D> step;
  step.dt = time_step;
  typename Law::template History<P> history{};
  const auto each_member = [&](auto&& f) {
    std::size_t m = 0;
    std::apply([&](auto&... member) { (f(member, m++), ...); }, history.members());
  };
  for (int k = 0; k < lane_count<P>; ++k) {
    const auto& p = points[which[static_cast<std::size_t>(k)]];
    for (std::size_t i = 0; i < stress.size; ++i) {
      set(stress[i], k, p.stress[i]);
      set(step.strain[i], k, p.strain[i]);
    }
    for (std::size_t i = 0; i < p.spin.size(); ++i) set(step.spin[i], k, p.spin[i]);
    each_member([&](P& member, std::size_t m) { set(member, k, p.history[m]); });
  }
  const auto parts = inelastic(law.update(stress, step, history));
  for (int k = 0; k < lane_count<P>; ++k) {
    auto& bits = after[which[static_cast<std::size_t>(k)]];
    bits.clear();
    const auto add = [&](const P& value) { bits.push_back(std::bit_cast<Bits<T>>(lane(value, k))); };
    for (const P& component : stress.c) add(component);
    each_member([&](const P& member, std::size_t) { add(member); });
    add(parts.opening);
    add(parts.dilation);
  }
}

/// Number of points whose answer in packs depends on their neighbours.
template <int Width, class T, int D, class Law>
std::size_t differing(const Law& law, const std::vector<Before<D>>& points,
                      [[maybe_unused]] const std::vector<After<T>>& of_scalars) {
  using P = typename LawLanes<Law, T, Width>::type;
  constexpr std::size_t width = lane_count<P>;
  std::vector<After<T>> alone(points.size()), beside(points.size());
  for (std::size_t p = 0; p < points.size(); ++p)
    update<P>(law, points, std::vector<std::size_t>(width, p), alone);
  std::size_t count = 0;
  // Fused products and estimates of reciprocals, where a pack has them, give a scalar other bits.
#if !defined(__AVX512F__) && !defined(__FMA__)
  for (std::size_t p = 0; p < points.size(); ++p) count += alone[p] != of_scalars[p];
#endif
  std::vector<std::size_t> order(points.size());
  std::iota(order.begin(), order.end(), 0);
  std::mt19937 random(13);
  for (int round = 0; round < 3; ++round) {
    std::shuffle(order.begin(), order.end(), random);
    for (std::size_t p = 0; p + width <= order.size(); p += width)
      update<P>(law, points,
                {order.begin() + static_cast<long>(p), order.begin() + static_cast<long>(p + width)}, beside);
    for (std::size_t p = 0; p < points.size(); ++p) count += beside[p] != alone[p];
  }
  return count;
}

template <class T, int D, class Law>
void check_packs(const Law& law, const std::vector<Before<D>>& points) {
  std::vector<After<T>> of_scalars(points.size());
  for (std::size_t p = 0; p < points.size(); ++p) update<T>(law, points, {p}, of_scalars);
  if constexpr (sizeof(T) == 8) CHECK(differing<2, T>(law, points, of_scalars) == 0);
  CHECK(differing<4, T>(law, points, of_scalars) == 0);
  CHECK(differing<8, T>(law, points, of_scalars) == 0);
  if constexpr (sizeof(T) == 4) CHECK(differing<16, T>(law, points, of_scalars) == 0);
}

/// The greatest distance of a point from its surface, over the size of trial stress and strength and in units
/// of the last place. The surface is that of the plastic strain before the step, and of the pressure after
/// it.
template <class T, int D, class Law>
double greatest_yield(const Law& law, const std::vector<Before<D>>& points, double cohesion) {
  double worst = 0;
  const auto size = [](const auto& s) { return std::sqrt(static_cast<double>(contract(s, s))); };
  for (const auto& p : points) {
    const auto number = [](const auto& s) {
      return Sym<T, D>::each([&](std::size_t i) { return static_cast<T>(s[i]); });
    };
    auto stress = number(p.stress);
    StrainStep<T, D> step{.strain = number(p.strain), .dt = time_step};
    std::transform(p.spin.begin(), p.spin.end(), step.spin.begin(),
                   [](double w) { return static_cast<T>(w); });
    typename Law::template History<T> history{};
    std::size_t m = 0;
    std::apply([&](auto&... member) { ((member = static_cast<T>(p.history[m++])), ...); }, history.members());
    const auto before = history;
    law.update(stress, step, history);
    if constexpr (requires { history.plastic_strain; }) history.plastic_strain = before.plastic_strain;
    const double own = 2 * size(stress) + cohesion;  // no less than what `yield` is a fraction of
    const double trial = size(p.stress) + law.wave_modulus() * size(p.strain) + cohesion;
    worst = std::max(worst, static_cast<double>(yield_of(law, stress, history)) * own / trial);
  }
  return worst / static_cast<double>(std::numeric_limits<T>::epsilon());
}

template <int D, class Law>
void check_law(const Law& law, double apex, double cohesion) {
  const auto points = random_points<D>(1024, apex);
  check_packs<double>(law, points);
  check_packs<float>(law, points);
  CHECK(greatest_yield<double>(law, points, cohesion) <= 512);
}

/// Strength without cohesion and with it, with a cut-off, without dilatancy and with it.
struct Strength {
  double friction, cohesion, dilatancy, tension = std::numeric_limits<double>::infinity();
};
const std::array strengths{Strength{45_deg, 1_kPa, 0}, Strength{40_deg, 0, 10_deg},
                           Strength{35_deg, 5_kPa, 15_deg}, Strength{30_deg, 2_kPa, 5_deg, 300},
                           Strength{45_deg, 1_kPa, 10_deg, 1500}};  // a cut-off only for softened points

template <template <class, class, class> class Law, class Parameters, int D, class Memory = ForgetsOpening,
          class Friction = ConstantFriction, class Stiffness = ConstantStiffness>
void check(const Friction& friction = {}, const Stiffness& stiffness = {}) {
  for (const auto& s : strengths)
    for (const Cone cone : {Cone::compression, Cone::extension, Cone::plane_strain}) {
      Parameters p{.density = 1540,
                   .young = 20_MPa,
                   .poisson = 0.3,
                   .friction = s.friction,
                   .cohesion = s.cohesion,
                   .dilatancy = s.dilatancy};
      if (!Memory::remembers()) p.tension = s.tension;
      if constexpr (requires { p.cone; })
        p.cone = cone;
      else if (cone != Cone::compression)
        continue;
      CAPTURE(s.friction, s.cohesion, s.dilatancy, p.tension, static_cast<int>(cone));
      const Law<Memory, Friction, Stiffness> law{p, {}, friction, stiffness};
      check_law<D>(law, detail::apex(s.friction, s.cohesion), s.cohesion);
    }
}

const SofteningParameters soft{.residual_friction = 10_deg, .decay = 8};
const RateSofteningFriction fast_and_soft{
    {.softening = soft, .friction_per_decade = 0.05, .smoothing = 1e-3}};

template <template <class, class, class> class Law, class Parameters>
void check_all() {
  check<Law, Parameters, 3>();
  check<Law, Parameters, 2, RemembersOpening>();
  check<Law, Parameters, 3>(LinearRateFriction{{.time = 1e-2}});
  check<Law, Parameters, 3>(InertialFriction{{.grain_size = 5e-3}});
  check<Law, Parameters, 2, RemembersOpening>(InertialFriction{{.rise = 2}});
  check<Law, Parameters, 2, RemembersOpening>(LogarithmicFriction{{.per_decade = 0.1}});
  check<Law, Parameters, 3>(SofteningFriction{soft}, PressureStiffness{});
  check<Law, Parameters, 2>(SofteningFriction{{.residual_friction = 25_deg, .decay = 3}});
  check<Law, Parameters, 3, RemembersOpening>(fast_and_soft, RateStiffness{{.decay = 3}});
}

}  // namespace

TEST_CASE("Mohr-Coulomb: a point's answer is its own in any pack, and on its surface") {
  check_all<MohrCoulomb, MohrCoulombParameters>();
}

TEST_CASE("Drucker-Prager: a point's answer is its own in any pack, and on its surface") {
  check_all<DruckerPrager, DruckerPragerParameters>();
}

TEST_CASE("linear elasticity, and a law with its strain: a point's answer is its own in any pack") {
  const auto points = random_points<3>(1024, 0);
  const LinearElastic elastic{{.density = 1540, .young = 20_MPa, .poisson = 0.3}};
  check_packs<double>(elastic, points);
  check_packs<float>(elastic, points);
  const WithDeviatoricStrain recorded{MohrCoulomb{
      MohrCoulombParameters{.density = 1540, .young = 20_MPa, .poisson = 0.3, .friction = 40_deg}}};
  check_packs<double>(recorded, points);
}

namespace {

template <class Law>
void check_inertial(const Law& law, double friction, double cohesion) {
  const auto points = random_points<3>(20'000, detail::apex(friction, cohesion));
  CHECK(greatest_yield<double>(law, points, cohesion) <= 512);
  CHECK(greatest_yield<float>(law, points, cohesion) <= 512);
}

}  // namespace

TEST_CASE("mu(I) is that of the pressure at which the return ends, whatever the material dilated") {
  for (const double cohesion : {0.0, 1e3, 5e3})
    for (const double dilatancy : {0_deg, 10_deg, 25_deg})
      for (const double tension : {std::numeric_limits<double>::infinity(), 300.0}) {
        CAPTURE(cohesion, dilatancy, tension);
        const InertialFriction inertial{{.rise = dilatancy > 0.2 ? 2 : 0.261}};
        const auto with = [&](auto p) {
          p.density = 1540;
          p.young = 20_MPa;
          p.poisson = 0.3;
          p.friction = 30_deg;
          p.cohesion = cohesion;
          p.dilatancy = dilatancy;
          p.tension = tension;
          return p;
        };
        check_inertial(MohrCoulomb{with(MohrCoulombParameters{}), ForgetsOpening{}, inertial}, 30_deg,
                       cohesion);
        check_inertial(DruckerPrager{with(DruckerPragerParameters{}), ForgetsOpening{}, inertial}, 30_deg,
                       cohesion);
      }
}

TEST_CASE("cohesive material that softens carries in tension what its own apex says, beside any neighbour") {
  // Stretched alike on all sides from a part of its strength by a half of it: c / tan(phi).
  const MohrCoulombParameters p{
      .density = 1540, .young = 20_MPa, .poisson = 0.3, .friction = 45_deg, .cohesion = 1_kPa};
  for (const double residual : {25_deg, 10_deg}) {
    const MohrCoulomb law{p, ForgetsOpening{},
                          SofteningFriction{{.residual_friction = residual, .decay = 10}}};
    using P = Pack<double, 2>;
    for (const double plastic : {0.0, 0.05, 1.0}) {
      const double exact = 1_kPa / std::tan(residual + (45_deg - residual) * std::exp(-10 * plastic));
      for (const double start : {0.6, 1.0, 1.5}) {
        Sym<double, 3> alone{{start * exact, start * exact, start * exact, 0, 0, 0}};
        Sym<P, 3> beside = Sym<P, 3>::each([&](std::size_t i) { return P(alone[i]); });
        beside[3].set(1, 50_kPa);
        const double e = 0.5 * exact / (3 * law.elasticity().bulk());
        StrainStep<double, 3> stretch{.strain = {{e, e, e, 0, 0, 0}}};
        StrainStep<P, 3> both;
        for (std::size_t i = 0; i < 6; ++i) both.strain[i] = P(stretch.strain[i]);
        std::remove_const_t<decltype(law)>::History<double> history{};
        history.plastic_strain = plastic;
        std::remove_const_t<decltype(law)>::History<P> histories{};
        histories.plastic_strain = P(plastic);
        law.update(alone, stretch, history);
        law.update(beside, both, histories);
        for (std::size_t i = 0; i < 3; ++i) {
          CHECK(alone[i] == Approx(exact).epsilon(1e-12));
          CHECK(beside[i][0] == alone[i]);
        }
      }
    }
  }
}
