// Friction as a policy: a slope by point, from rate and history, through the same return as the constant one.
#include <arenite/core/units.hpp>
#include <arenite/law/drucker_prager.hpp>
#include <arenite/law/mohr_coulomb.hpp>
#include <arenite/simd/lanes.hpp>

#include "catch.hpp"
#include "states.hpp"

using namespace arenite;
using namespace arenite::test;

namespace {

/// The slope given, by a policy that the law cannot know to be constant.
struct Given {
  template <class T>
  using History = NoHistory<T>;
  template <class T, int D>
  T slope(double given, const StrainStep<T, D>&, History<T>&) const {
    return T(given);
  }
};

/// Grows with the logarithm of the shear rate: here by its root, which a pack has.
struct RateDependent {
  double time;  // s
  template <class T>
  using History = NoHistory<T>;
  template <class T, int D>
  T slope(double given, const StrainStep<T, D>& step, History<T>&) const {
    using std::sqrt;
    const auto e = deviator(step.strain) * T(step.per_time());
    return T(given) * (T(1) + T(time) * sqrt(T(2) * contract(e, e)));
  }
};

/// Softens with the shear strain that a point has seen, from the slope given to a half of it.
struct Softening {
  double strain;  // that halves it
  template <class T>
  struct History {
    T sheared{0};
    auto members() { return std::tie(sheared); }
    auto members() const { return std::tie(sheared); }
  };
  template <class T, int D>
  T slope(double given, const StrainStep<T, D>& step, History<T>& history) const {
    using std::max, std::sqrt;
    const auto e = deviator(step.strain);
    history.sheared = history.sheared + sqrt(T(2) * contract(e, e));
    return T(given) * max(T(T(1) - history.sheared * T(0.5 / strain)), T(0.5));
  }
};

const MohrCoulombParameters pyramid{.density = 1540,
                                    .young = 5e6,
                                    .poisson = 0.33,
                                    .friction = 35_deg,
                                    .cohesion = 1_kPa,
                                    .dilatancy = 10_deg};
const DruckerPragerParameters cone{.density = 1540,
                                   .young = 5e6,
                                   .poisson = 0.33,
                                   .friction = 35_deg,
                                   .cohesion = 1_kPa,
                                   .dilatancy = 10_deg,
                                   .cone = Cone::plane_strain};

template <class P, int D, class A, class B>
void check_same(const A& constant, const B& by_point, double tolerance) {
  std::mt19937 random(11);
  for (int round = 0; round < 2000; ++round) {
    Sym<P, D> stress, same;
    for (int k = 0; k < lane_count<P>; ++k) {
      const auto s = trial_state<D>(random, 1e3 / std::tan(35_deg));
      for (std::size_t i = 0; i < s.size; ++i) {
        if constexpr (is_pack<P>)
          stress[i].set(k, s[i]);
        else
          stress[i] = s[i];
      }
    }
    same = stress;
    NoHistory<P> nothing;
    typename B::template History<P> history{};
    const auto a = constant.update(stress, StrainStep<P, D>{}, nothing);
    const auto b = by_point.update(same, StrainStep<P, D>{}, history);
    for (int k = 0; k < lane_count<P>; ++k) {
      const auto lane = [&](const P& value) {
        if constexpr (is_pack<P>)
          return value[k];
        else
          return value;
      };
      double size = 1e3;
      for (const P& c : stress.c) size = std::max(size, std::abs(lane(c)));
      for (std::size_t i = 0; i < stress.size; ++i)
        REQUIRE(std::abs(lane(stress[i]) - lane(same[i])) <= tolerance * size);
      REQUIRE(std::abs(lane(a.opening) - lane(b.opening)) <= tolerance * size / 5e6);
      REQUIRE(std::abs(lane(a.dilation) - lane(b.dilation)) <= tolerance * size / 5e6);
    }
  }
}

/// Shear stress over vertical stress in simple shear at a rate, 1/s.
template <class Law>
double strength(const Law& law, double rate, int steps) {
  Sym<double, 2> stress{{-1e4, -1e4, -1e4, 0}};
  typename Law::template History<double> history{};
  StrainStep<double, 2> step;
  step.strain[3] = 5e-5;
  step.dt = 1e-4 / rate;
  for (int k = 0; k < steps; ++k) law.update(stress, step, history);
  return stress[3] / -stress[1];
}

}  // namespace

TEST_CASE("the slope given, point by point: the same returns as with the constant policy") {
  for (const double tension : {std::numeric_limits<double>::infinity(), 300.0}) {
    auto p = pyramid;
    auto c = cone;
    p.tension = c.tension = tension;
    const MohrCoulomb sand{p};
    const MohrCoulomb same{p, ForgetsOpening{}, Given{}};
    const DruckerPrager grains{c};
    const DruckerPrager alike{c, ForgetsOpening{}, Given{}};
    check_same<double, 3>(sand, same, 1e-12);
    check_same<Pack<double, 4>, 2>(sand, same, 1e-12);
    check_same<double, 3>(grains, alike, 1e-12);
    check_same<Pack<double, 8>, 3>(grains, alike, 1e-12);
  }
}

TEST_CASE("a constant policy stores nothing, another what its history says") {
  STATIC_REQUIRE(std::is_same_v<MohrCoulomb<>::History<double>, NoHistory<double>>);
  STATIC_REQUIRE(history_size<MohrCoulomb<RemembersOpening, Softening>::History<double>> == 2);
}

TEST_CASE("friction that grows with the rate, and friction that softens: tan(phi) as the policy says") {
  auto p = pyramid;
  p.cohesion = p.dilatancy = 0;
  // Without dilatancy both principal stresses stay about the mean: tau / sigma = sin(phi).
  const auto sin = [&](double factor) { return std::sin(std::atan(factor * std::tan(p.friction))); };
  const MohrCoulomb fast{p, ForgetsOpening{}, RateDependent{0.01}};
  CHECK(strength(fast, 0.001, 1000) == Approx(sin(1 + 1e-5)).epsilon(1e-9));
  CHECK(strength(fast, 20, 1000) == Approx(sin(1.2)).epsilon(1e-9));
  const MohrCoulomb soft{p, ForgetsOpening{}, Softening{0.1}};
  CHECK(strength(soft, 1, 500) == Approx(sin(1 - 0.05 / 0.1 / 2)).epsilon(1e-9));
  CHECK(strength(soft, 1, 3000) == Approx(sin(0.5)).epsilon(1e-9));
}
