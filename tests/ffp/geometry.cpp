// The shapes of the drop, against the formulas of solids, and the line grading.
#include "../../examples/ffp/geometry.hpp"

#include "../../examples/ffp/grading.hpp"
#include "catch.hpp"

using namespace arenite;
using namespace arenite::ffp;

TEST_CASE("the sharp device is a cone of 60 degrees under a cylinder") {
  const Device d{{}};
  const double h = 0.04375 * std::sqrt(3.0);
  REQUIRE(std::abs(d.cone_height() - h) < 1e-15);
  REQUIRE(d.profile(-1) == 0);
  REQUIRE(d.profile(0) == 0);
  REQUIRE(std::abs(d.profile(0.03) - 0.03 / std::sqrt(3.0)) < 1e-15);
  REQUIRE(d.profile(h + 1e-12) == 0.04375);
  const double volume = pi * 0.04375 * 0.04375 * (h / 3 + 0.631 - h);
  REQUIRE(std::abs(d.volume() - volume) < 1e-12 * volume);
}

TEST_CASE("a rounded edge touches cone and cylinder") {
  const Device d{{.fillet = 0.01}};
  const double tangent = 0.01 * std::tan(15 * pi / 180), h = d.cone_height();
  REQUIRE(std::abs(d.fillet_end() - (h + tangent)) < 1e-15);
  REQUIRE(std::abs(d.fillet_start() - (h - tangent * std::cos(30 * pi / 180))) < 1e-15);
  for (const double y : {d.fillet_start(), d.fillet_end()})  // continuous, with a continuous slope
    REQUIRE(std::abs(d.profile(y + 1e-9) - d.profile(y - 1e-9)) < 2e-9);
  const auto slope = [&](double y) { return (d.profile(y + 1e-7) - d.profile(y - 1e-7)) / 2e-7; };
  REQUIRE(std::abs(slope(d.fillet_start() + 2e-7) - std::tan(30 * pi / 180)) < 1e-3);
  REQUIRE(std::abs(slope(d.fillet_end() - 2e-7)) < 1e-3);
  for (const double y : d.edge_heights(1e-3)) {  // on the circle
    const double r = d.profile(y) - (0.04375 - 0.01), up = y - d.fillet_end();
    REQUIRE(std::abs(std::hypot(r, up) - 0.01) < 1e-12);
  }
  REQUIRE(d.edge_heights(0.005).size() == 2);  // the arc is 5.24 mm long: one facet
  REQUIRE(d.edge_heights(0.006).size() == 1);  // too short for one
  REQUIRE(d.edge_heights(0.001).size() == 6);  // five
  REQUIRE(d.volume() < Device{{}}.volume());
}

TEST_CASE("a device that does not fit together is refused") {
  REQUIRE_THROWS_AS(Device{{.radius = 0}}, error);
  REQUIRE_THROWS_AS(Device{{.length = 0.07}}, error);
  REQUIRE_THROWS_AS(Device{{.fillet = -0.01}}, error);
  REQUIRE_THROWS_AS(Device{{.fillet = 0.5}}, error);
}

TEST_CASE("the moving mesh: whole above, even compression below, fixed at the bottom") {
  REQUIRE(motion_factor(0.7, 0.06) == 1);
  REQUIRE(motion_factor(-0.06, 0.06) == 1);
  REQUIRE(motion_factor(-0.4, 0.06) == 0);
  REQUIRE(std::abs(motion_factor(-0.23, 0.06) - 0.5) < 1e-15);
}

TEST_CASE("graded lines follow the wished length and end exactly") {
  const auto x = graded(-0.1, 0.7, [](double s) { return 0.01 * (1 + std::max(0.0, s)); });
  REQUIRE(x.front() == -0.1);
  REQUIRE(x.back() == 0.7);
  // number of pieces: the integral of 1 / size = 10 + 100 ln 1.7
  REQUIRE(x.size() == static_cast<std::size_t>(std::lround(10 + 100 * std::log(1.7))) + 1);
  for (std::size_t i = 1; i < x.size(); ++i) {
    const double middle = (x[i] + x[i - 1]) / 2;
    REQUIRE(std::abs((x[i] - x[i - 1]) / (0.01 * (1 + std::max(0.0, middle))) - 1) < 0.003);
  }
  REQUIRE(even(0, 1, 5).size() == 2);
  REQUIRE(even(0, 1, 0.25).size() == 5);
  REQUIRE_THROWS_AS(even(1, 1, 0.25), error);
}
