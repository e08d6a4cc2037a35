// The cone-tipped cylinder against hand values and against its outline sampled point by point.
#include "catch.hpp"

#include <arenite/core/units.hpp>
#include <arenite/geometry/cone_cylinder.hpp>

#include "../mesh/sample_meshes.hpp"

using namespace arenite;
using namespace arenite::test;

namespace {
using P = Vec<double, 2>;
}

TEST_CASE("cone-tipped cylinder: hand values") {
  // Half angle 45 degrees, radius 1: the cone is 1 high.
  const ConeCylinder cone({.radius = 1, .apex = 90_deg, .length = 3, .tip = 10});
  const double s = std::sqrt(0.5);
  REQUIRE(std::abs(cone(P(0, 9)) - 1) < 1e-15);       // below the tip
  REQUIRE(std::abs(cone(P(0, 10))) < 1e-15);          // at the tip
  REQUIRE(std::abs(cone(P(1, 10)) - s) < 1e-15);      // beside the flank
  REQUIRE(std::abs(cone(P(-1, 10)) - s) < 1e-15);     // and on the other side
  REQUIRE(std::abs(cone(P(1.5, 12)) - 0.5) < 1e-15);  // beside the shaft
  REQUIRE(std::abs(cone(P(0.8, 12)) + 0.2) < 1e-15);  // in the shaft
  REQUIRE(std::abs(cone(P(0, 11)) + s) < 1e-15);      // on the axis, nearest the flank
  REQUIRE(std::abs(cone(P(0, 14)) - 1) < 1e-15);      // above the end
  REQUIRE(std::abs(cone(P(4, 17)) - 5) < 1e-15);      // off the upper edge, 3-4-5
  const ConeCylinder same({.radius = 1, .apex = 90_deg, .length = 3, .tip = 10});
  REQUIRE(std::abs(same(Vec<double, 3>(0.6, 10, 0.8)) - s) < 1e-15);  // r = 1 in three dimensions
}

TEST_CASE("cone-tipped cylinder: exact against its sampled outline") {
  const ConeCylinder cone({.radius = 0.044, .apex = 60_deg, .length = 0.25, .tip = -0.1});
  const double height = 0.044 / std::tan(30_deg);
  const double spacing = 0.25 / 4000;  // of the samples, at most
  std::vector<P> outline;
  const auto line = [&](P a, P b) {
    for (int i = 0; i <= 4000; ++i) outline.push_back(a + (b - a) * i / 4000.0);
  };
  line({0, -0.1}, {0.044, -0.1 + height});
  line({0.044, -0.1 + height}, {0.044, 0.15});
  line({0.044, 0.15}, {0, 0.15});
  std::mt19937 random(2);
  std::uniform_real_distribution<double> r(0, 0.1), y(-0.2, 0.25);
  double off = 0;
  int inside = 0;
  for (int i = 0; i < 500; ++i) {
    const double radius = r(random), at = y(random);
    const P x(radius, at);
    double nearest = 1;
    for (const P& q : outline) nearest = std::min(nearest, (x - q).norm());
    const double z = x[1] + 0.1;
    const bool within = z > 0 && z < 0.25 && x[0] < 0.044 && x[0] < z * std::tan(30_deg);
    inside += within;
    // A sample lies within half a spacing of the foot of the normal: its distance is too large by at most
    // this.
    const double bound = nearest > spacing ? spacing * spacing / (8 * (nearest - spacing / 2)) : spacing / 2;
    off = std::max(off, std::abs(cone(x) - (within ? -nearest : nearest)) / bound);
    REQUIRE(std::abs(cone(Vec<double, 3>(0.6 * x[0], x[1], -0.8 * x[0])) - cone(x)) < 1e-15);
  }
  REQUIRE(inside > 50);
  REQUIRE(off <= 1 + 1e-6);
}

TEST_CASE("cone-tipped cylinder: bad shapes are refused") {
  const double nan = std::nan(""), inf = std::numeric_limits<double>::infinity();
  const auto refuses = [](ConeCylinder::Parameters p, const std::string& text) {
    return throws([&] { ConeCylinder c(p); }, text);
  };
  REQUIRE(refuses({}, "ConeCylinder.radius = nan: must be given, positive"));
  REQUIRE(
      refuses({.radius = -1, .apex = 1, .length = 9}, "ConeCylinder.radius = -1: must be given, positive"));
  REQUIRE(refuses({.radius = 1, .apex = 60, .length = 9},
                  "ConeCylinder.apex = 60: must be given, in (0, pi) rad"));
  REQUIRE(refuses({.radius = 1, .apex = 90_deg, .length = 0.5},
                  "ConeCylinder.length = 0.5: must reach the cone's height 1"));
  REQUIRE(refuses({.radius = 1, .apex = 90_deg, .length = inf}, "ConeCylinder.length = inf"));
  REQUIRE(refuses({.radius = 1, .apex = 90_deg, .length = 2, .tip = nan},
                  "ConeCylinder.tip = nan: must be finite"));
  // A bare cone, no shaft.
  const ConeCylinder bare({.radius = 1, .apex = 90_deg, .length = 1 / std::tan(45_deg)});
  REQUIRE(std::abs(bare(P(0, 0.9)) + 0.1) < 1e-14);
}
