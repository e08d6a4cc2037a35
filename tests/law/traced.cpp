// The recorded deviatoric strain against simple shear, rigid turns and strains that are undone.
#include <arenite/law/linear_elastic.hpp>
#include <arenite/law/traced.hpp>
#include <cmath>

#include "catch.hpp"

using namespace arenite;

namespace {

const Traced law{LinearElastic{{.density = 1000, .young = 1e6, .poisson = 0.25}}};

template <int D>
double after(Traced<LinearElastic>::History<double>& history, const Increment<double, D>& inc, int steps) {
  Sym<double, D> stress{};
  for (int k = 0; k < steps; ++k) law.update(stress, inc, history);
  return law.deviatoric_strain(history);
}

}  // namespace

TEST_CASE("uniaxial strain: two thirds of it is deviatoric") {
  Traced<LinearElastic>::History<double> h{};
  Increment<double, 2> inc{};
  inc.strain = {{0, -0.01, 0, 0}};
  REQUIRE(std::abs(after(h, inc, 10) - 0.1 * 2 / 3) < 1e-14);
}

TEST_CASE("a small simple shear gamma gives gamma / sqrt(3)") {
  Traced<LinearElastic>::History<double> h{};
  Increment<double, 3> inc{};
  inc.strain[3] = 0.5e-6;
  inc.spin[0] = 0.5e-6;
  REQUIRE(std::abs(after(h, inc, 100) - 1e-4 / std::sqrt(3.0)) < 1e-12);
}

TEST_CASE("a turn adds nothing, and a strain that is undone leaves nothing") {
  Traced<LinearElastic>::History<double> h{};
  Increment<double, 2> there{}, turn{}, back{};
  there.strain = {{0.02, -0.02, 0, 0.01}};
  turn.spin[0] = 0.1;
  back.strain = there.strain * -1.0;
  const double strained = after(h, there, 1);
  REQUIRE(std::abs(after(h, turn, 25) - strained) < 1e-15);
  Traced<LinearElastic>::History<double> fresh{};
  after(fresh, there, 1);
  REQUIRE(after(fresh, back, 1) < 1e-16);
}

TEST_CASE("a plane tracer stores three components and says the same") {
  const Traced<LinearElastic, 2> plane{law.law()};
  Traced<LinearElastic, 2>::History<double> narrow{};
  Traced<LinearElastic>::History<double> wide{};
  STATIC_REQUIRE(std::tuple_size_v<decltype(narrow.members())> == 3);
  STATIC_REQUIRE(std::tuple_size_v<decltype(wide.members())> == 5);
  Increment<double, 2> inc{};
  inc.strain = {{0.02, -0.01, 0.005, 0.01}};
  inc.spin[0] = 0.03;
  Sym<double, 2> stress{};
  for (int k = 0; k < 7; ++k) plane.update(stress, inc, narrow);
  REQUIRE(plane.deviatoric_strain(narrow) == after(wide, inc, 7));
}

namespace {
struct Branching : LinearElastic {
  using LinearElastic::LinearElastic;
  static constexpr int widest = 1;
  static constexpr bool twins = false;
};
struct Chain : LinearElastic {
  using LinearElastic::LinearElastic;
  static constexpr int widest = 4;
  static constexpr bool twins = true;
};
}  // namespace

TEST_CASE("a traced law is called with the packs that the law asks for") {
  STATIC_REQUIRE(lane_wishes<Traced<Branching>>.widest == 1);
  STATIC_REQUIRE_FALSE(lane_wishes<Traced<Branching>>.twins);
  STATIC_REQUIRE(lane_wishes<Traced<Chain>>.widest == 4);
  STATIC_REQUIRE(lane_wishes<Traced<Chain>>.twins);
  STATIC_REQUIRE(lane_wishes<Traced<LinearElastic>>.widest == lane_wishes<LinearElastic>.widest);
  STATIC_REQUIRE_FALSE(lane_wishes<Traced<LinearElastic>>.twins);
}
