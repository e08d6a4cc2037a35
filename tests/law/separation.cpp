// Matter that separates carries no stress and its volume does not swell, so that nothing blows up when it is
// compressed again; with memory it carries none before the gap is closed.
#include <arenite/core/units.hpp>
#include <arenite/law/drucker_prager.hpp>
#include <arenite/law/mohr_coulomb.hpp>
#include <string>

#include "catch.hpp"
#include "states.hpp"

using namespace arenite;
using namespace arenite::test;

namespace {

template <class Law>
struct Point {
  Sym<double, 3> stress{};
  typename Law::template History<double> history{};
  double strain = 0, opening = 0;  // volumetric, summed

  /// A step of volumetric strain and shear.
  double step(const Law& law, double volume, double shear = 0) {
    StrainStep<double, 3> strain_step;
    strain_step.strain = {{volume / 3, volume / 3, volume / 3, shear, 0, 0}};
    const double opened = law.update(stress, strain_step, history).opening;
    strain += volume;
    opening += opened;
    return opened;
  }
  double volume() const { return std::exp(strain - opening); }  // over V0
};

template <class Law>
void open_and_close(const Law& law) {
  Point<Law> point;
  point.step(law, -0.01);
  const double pressed = point.stress[0];
  REQUIRE(pressed < 0);
  REQUIRE(point.opening == 0);
  const double stretch = std::log(30.0);
  for (int i = 0; i < 1000; ++i) {
    REQUIRE(point.step(law, stretch / 1000, 1e-3 * (i % 7)) >= 0);
    REQUIRE(point.volume() <= 1 + 1e-12);
  }
  for (std::size_t i = 0; i < 6; ++i) REQUIRE(std::abs(point.stress[i]) <= 1e-9);
  REQUIRE(std::abs(point.volume() - 1) <= 1e-12);
  for (int i = 0; i < 1000; ++i) {
    const double gap = point.opening;  // still open before this step
    point.step(law, -stretch / 1000);
    REQUIRE(point.volume() <= 1 + 1e-12);
    const double p = trace(point.stress) / 3;
    // Bounded by what the strain could build up without any gap.
    REQUIRE(p >= -law.elasticity().bulk() * stretch * (i + 1) / 1000 * (1 + 1e-9));
    if constexpr (!std::is_same_v<typename Law::template History<double>, NoHistory<double>>) {
      if (gap > 2 * stretch / 1000) REQUIRE(p == 0);
      REQUIRE(point.history.opening >= 0);
    }
  }
}

}  // namespace

TEST_CASE("opened thirty-fold and closed again: no swelling, no blow-up") {
  open_and_close(MohrCoulomb{{.density = 1, .young = 5e6, .poisson = 0.33, .friction = 40_deg}});
  open_and_close(DruckerPrager{{.density = 1, .young = 5e6, .poisson = 0.33, .friction = 40_deg}});
  const RemembersOpening memory{{.limit = 10}};
  open_and_close(MohrCoulomb{{.density = 1, .young = 5e6, .poisson = 0.33, .friction = 40_deg}, memory});
  open_and_close(DruckerPrager{{.density = 1, .young = 5e6, .poisson = 0.33, .friction = 40_deg}, memory});
}

TEST_CASE("with memory a closed cycle ends where it began, without it pressure is left") {
  const MohrCoulombParameters sand{.density = 1, .young = 5e6, .poisson = 0.33, .friction = 40_deg};
  const auto cycle = [](const auto& law) {
    Point<std::decay_t<decltype(law)>> point;
    for (const double volume : {-0.01, 0.05, 0.1, -0.07, -0.0775, -0.0025}) point.step(law, volume);
    REQUIRE(std::abs(point.strain + 0.01) <= 1e-15);
    return point;
  };
  const MohrCoulomb with{sand, RemembersOpening{}};
  const auto closed = cycle(with);
  REQUIRE(std::abs(trace(closed.stress) / 3 + 0.01 * with.elasticity().bulk()) <= 1e-6);
  REQUIRE(std::abs(closed.opening) <= 1e-15);
  REQUIRE(std::abs(closed.volume() - std::exp(-0.01)) <= 1e-14);
  REQUIRE(closed.history.opening == 0);

  const MohrCoulomb without{sand};
  const auto left = cycle(without);
  REQUIRE(std::abs(trace(left.stress) / 3 + 0.15 * without.elasticity().bulk()) <= 1e-6);
  REQUIRE(std::abs(left.volume() - std::exp(-0.15)) <= 1e-14);
}

TEST_CASE("what is remembered is bounded, and shear moves no stress into a gap") {
  const MohrCoulomb law{{.density = 1, .young = 5e6, .poisson = 0.33, .friction = 40_deg},
                        RemembersOpening{{.limit = 0.2}}};
  Point<MohrCoulomb<RemembersOpening>> point;
  for (int i = 0; i < 10; ++i) point.step(law, 0.1);
  REQUIRE(point.history.opening == 0.2);
  point.step(law, -0.1, 0.05);
  for (std::size_t i = 0; i < 6; ++i) REQUIRE(point.stress[i] == 0);
  REQUIRE(std::abs(point.history.opening - 0.1) <= 1e-15);
  point.step(law, -0.2);  // half of it closes
  REQUIRE(std::abs(trace(point.stress) / 3 + 0.1 * law.elasticity().bulk()) <= 1e-6);
  REQUIRE(std::abs(point.volume() - std::exp(-0.1)) <= 1e-14);
}

TEST_CASE("a law without memory stores nothing, one with memory one number") {
  static_assert(std::tuple_size_v<decltype(MohrCoulomb<>::History<double>{}.members())> == 0);
  static_assert(std::tuple_size_v<decltype(DruckerPrager<>::History<float>{}.members())> == 0);
  static_assert(std::tuple_size_v<decltype(MohrCoulomb<RemembersOpening>::History<double>{}.members())> == 1);
  static_assert(std::is_same_v<decltype(MohrCoulomb{MohrCoulombParameters{}}), MohrCoulomb<ForgetsOpening>>);
}

TEST_CASE("a memory refuses what it cannot represent") {
  const auto message = [](const auto& make) -> std::string {
    try {
      make();
    } catch (const error& e) {
      return e.what();
    }
    return "";
  };
  REQUIRE(message([] { RemembersOpening{{.limit = 0}}; }) == "RemembersOpening.limit = 0: must be positive");
  REQUIRE(message([] {
            MohrCoulomb{
                {.density = 1, .young = 1, .poisson = 0, .friction = 0.5, .cohesion = 1, .tension = 0},
                RemembersOpening{}};
          }) ==
          "MohrCoulomb.tension = 0: a law that remembers its opening needs the cut-off at the apex (leave "
          "tension out)");
}
