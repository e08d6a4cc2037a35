// Contact at nodes that keeps each node's gap: what rests or rubs on a rigid body is not lifted.
#include <algorithm>
#include <arenite/arenite.hpp>
#include <arenite/rigid/with_matter/node_gaps.hpp>
#include <cmath>

#include "catch.hpp"

using namespace arenite;

namespace {

using V = Vec<double, 2>;

struct Slid {
  double travel, rise, residual;  // m, m, J
};

/// An elastic block of 0.2 x 0.1 m is laid on a slope, whose surface lies `place` cells above a line of the grid,
/// and runs for 0.5 s. `rise`: the greatest of its centre, across the slope.
template <class N, class Coupling>
Slid slide(double slope, Friction friction, double place, Coupling coupling, double courant = 0.4) {
  const double cell = 0.02, surface = 0.2 + place * cell,
               off = 1e-6;  // the region's edges do not lie on sub-cells
  const auto at_rest = [](double) { return std::array{0., 0., 0.}; };
  const LinearElastic rubber{{.density = 1800, .young = 1e6, .poisson = 0.3}};
  Scene scene{PlaneStrain{},
              CartesianGrid<2>{{.lower = {0, 0}, .upper = {1, 0.4}, .cell = cell}},
              N{},
              bodies(fill(Box{{0.2, surface - off}, {0.4, surface + 0.1 - off}}, rubber, {.per_cell = 4})),
              gravity({9.81 * std::sin(slope), -9.81 * std::cos(slope)}),
              rigid(DistanceSurface{Box{{-1, -1}, {2, surface}}}, Prescribed{at_rest}, friction, coupling),
              TrackEnergy{}};
  const auto centre = [&]() -> V {
    const auto& points = scene.template body<0>().points;
    V sum = V::Zero();
    double mass = 0;
    for (std::size_t p = 0; p < points.size(); ++p) {
      sum += points.mass[p] * points.position[p];
      mass += points.mass[p];
    }
    return sum / mass;
  };
  const V begin = centre();
  double rise = 0;
  run(scene, {.end = 0.5, .courant = courant},
      every(0.01, [&](const auto&) { rise = std::max(rise, centre()[1] - begin[1]); }));
  return {centre()[0] - begin[0], rise, energies(scene).residual};
}

using SplinesApic = Numerics<QuadraticBSpline, Apic, Musl>;
using SplinesFlip = Numerics<QuadraticBSpline, Flip, Usl>;

struct Touched {
  std::size_t field;
  Index node;
  bool inside;
  double closing = 0;
};

}  // namespace

TEST_CASE("A block that sticks to a slope is not lifted, wherever the slope lies in its cell") {
  const double slope = 30_deg;
  const Friction rough(40_deg);
  for (const double place : {0.0, 0.5}) {
    CAPTURE(place);
    const Slid apic = slide<SplinesApic>(slope, rough, place, NodalGap{});
    CHECK(apic.rise < 0.2e-3);
    CHECK(apic.travel < 3e-3);
    CHECK(std::abs(apic.residual) < 0.01);
    const Slid flip = slide<SplinesFlip>(slope, rough, place, NodalGap{}, 0.2);
    CHECK(flip.rise < 0.2e-3);
    CHECK(flip.travel < 3e-3);
  }
  // The error that it cures.
  const Slid ratchet = slide<SplinesApic>(slope, rough, 0.5, RigidVelocity{});
  CHECK(ratchet.rise > 3e-3);
  CHECK(ratchet.travel > 15e-3);
}

TEST_CASE("A block that slides goes as far as a rigid one, and is not lifted") {
  const double slope = 30_deg, friction = 25_deg;
  const double exact = 9.81 * (std::sin(slope) - std::tan(friction) * std::cos(slope)) * 0.25 / 2;
  for (const double place : {0.0, 0.5}) {
    const Slid slid = slide<SplinesApic>(slope, Friction(friction), place, NodalGap{});
    CAPTURE(place, slid.travel, exact);
    CHECK(slid.rise < 0.5e-3);
    CHECK(slid.travel == Approx(exact).epsilon(0.1));  // the block vibrates, with a smaller load meanwhile
    CHECK(slid.residual < 0.01);
  }
}

TEST_CASE("A gap grows as material parts, closes by as much, and is forgotten where nothing is touched") {
  NodeGaps<double> gaps;
  const std::size_t nodes = 10;
  const double dt = 0.1;
  double velocity = 2;
  const auto step = [&](std::vector<Touched> touched) {
    gaps.give(touched, 2, nodes, dt);
    gaps.follow(touched, dt, [&](const Touched&) { return velocity; });
    return touched[0].closing;
  };
  CHECK(step({{1, 4, false}, {0, 4, false}}) == 0);  // it parts by 0.2 m
  CHECK(step({{1, 4, false}}) == Approx(2));         // and by 0.2 m more
  velocity = -1;
  CHECK(step({{1, 4, false}}) == Approx(4));  // may close with 4 m/s, closes with 1
  CHECK(step({{1, 4, false}}) == Approx(3));
  velocity = -9;
  step({{1, 4, false}});
  CHECK(step({{1, 4, false}}) == 0);  // a gap is never below zero
  velocity = 1;
  step({{1, 4, false}});
  step({{0, 7, false}});
  CHECK(step({{1, 4, false}}) == 0);
  CHECK(step({{0, 7, true}}) == 0);  // none inside
}

TEST_CASE("Gaps of a restored state must be of the mesh") {
  const auto refused = [](std::vector<std::size_t> field, std::vector<std::size_t> node,
                          std::vector<double> gap) {
    NodeGaps<double> gaps;
    gaps.visit_state([&](const char* name, auto& values) {
      if constexpr (std::same_as<std::remove_cvref_t<decltype(values)>, std::vector<double>>)
        values = gap;
      else
        values = std::string(name) == "field" ? field : node;
    });
    try {
      gaps.check(2, 10);
    } catch (const error& e) {
      return std::string(e.what());
    }
    return std::string();
  };
  CHECK(refused({0, 1}, {9, 0}, {1e-3, 2}) == "");
  CHECK(refused({0}, {9, 0}, {1e-3, 2}) ==
        "state: gaps of a rigid body = 2: must be as many as their fields and nodes");
  CHECK(refused({0, 2}, {9, 0}, {1e-3, 2}) == "state: gap of a rigid body, node = 0: must lie in the mesh");
  CHECK(refused({0, 1}, {9, 10}, {1e-3, 2}) == "state: gap of a rigid body, node = 10: must lie in the mesh");
  CHECK(refused({0, 1}, {9, 0}, {1e-3, std::nan("")}) ==
        "state: gap of a rigid body = nan: must be positive");
}
