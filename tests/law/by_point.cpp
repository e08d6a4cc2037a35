// Constants by point: a law with factors is that of the scaled parameters.
#include <arenite/law/by_point.hpp>
#include <arenite/law/linear_elastic.hpp>
#include <arenite/law/mohr_coulomb.hpp>
#include <cmath>
#include <limits>

#include "catch.hpp"

using namespace arenite;

namespace {

MohrCoulombParameters clay() {
  return {.density = 1800,
          .young = 1e6,
          .poisson = 0.3,
          .friction = std::atan(0.5),
          .cohesion = 1000,
          .dilatancy = 0.1,
          .tension = 500};
}

/// Compressed, sheared, and pulled apart: all parts of the yield surface.
template <class Law, class Other>
void check_same(const Law& law, typename Law::template History<double> history, const Other& other) {
  typename Other::template History<double> none{};
  Sym<double, 2> a{{-8e3, -12e3, -9e3, 0}}, b = a;
  const double way[][4] = {
      {-1e-3, -2e-3, 0, 0}, {2e-3, -3e-3, 0, 8e-3}, {9e-3, 4e-3, 0, -2e-3}, {5e-3, 9e-3, 0, 0}};
  double greatest = 0;
  for (const auto& go : way)
    for (int k = 0; k < 10; ++k) {
      const StrainStep<double, 2> step{{{go[0], go[1], go[2], go[3]}}, {1e-3}, 1e-3};
      const auto here = inelastic(law.update(a, step, history));
      const auto there = inelastic(other.update(b, step, none));
      for (std::size_t c = 0; c < a.c.size(); ++c) {
        CHECK(a[c] == Approx(b[c]).epsilon(1e-11).margin(1e-8));
        greatest = std::max(greatest, std::abs(b[c]));
      }
      CHECK(here.opening == Approx(there.opening).epsilon(1e-10).margin(1e-15));
      CHECK(here.dilation == Approx(there.dilation).epsilon(1e-10).margin(1e-15));
      CHECK(law.elastic_energy(a, history) == Approx(elastic_energy_of(other, b, none)).epsilon(1e-10));
    }
  CHECK(greatest > 1e3);
  CHECK(law.wave_modulus(a, history) == Approx(other.wave_modulus()));
}

}  // namespace

TEST_CASE("factors of Young's modulus, cohesion and friction are those of the parameters") {
  const ByPoint law{MohrCoulomb<ForgetsOpening, PointFriction>{clay()}};
  using History = decltype(law)::History<double>;
  CHECK(history_names<History> == std::array<std::string_view, 3>{"friction", "stiffness", "strength"});
  const auto scaled = [](double stiffness, double strength, double friction) {
    auto p = clay();
    p.young *= stiffness;
    p.cohesion *= strength;
    p.tension *= strength;
    p.friction = std::atan(0.5 * friction);
    return MohrCoulomb<>{p};
  };
  const auto history = [](double stiffness, double strength, double friction) {
    History h{};
    h.stiffness = stiffness;
    h.strength = strength;
    h.friction = friction;
    return h;
  };
  check_same(law, History{}, MohrCoulomb<>{clay()});
  check_same(law, history(3, 1, 1), scaled(3, 1, 1));
  check_same(law, history(1, 0.3, 1), scaled(1, 0.3, 1));
  check_same(law, history(1, 1, 1.4), scaled(1, 1, 1.4));
  check_same(law, history(0.2, 1.7, 0.6), scaled(0.2, 1.7, 0.6));

  const ByPoint rubber{LinearElastic{{.density = 1000, .young = 1e6, .poisson = 0.3}}};
  decltype(rubber)::History<double> twice{};
  twice.stiffness = 2.5;
  check_same(rubber, twice, LinearElastic{{.density = 1000, .young = 2.5e6, .poisson = 0.3}});
}

TEST_CASE("a law that a rate changes has no constants by point") {
  auto p = clay();
  p.tension = std::numeric_limits<double>::infinity();
  REQUIRE_THROWS_WITH(ByPoint(MohrCoulomb<RemembersOpening>(p)), Catch::Contains("ByPoint.law"));
}
