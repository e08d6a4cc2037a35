// The shapes of the drop, against the formulas of solids, and the line grading.
#include "../../examples/ffp/geometry/geometry.hpp"

#include <arenite/geometry/cone_cylinder.hpp>

#include "../../examples/ffp/geometry/grading.hpp"
#include "../../examples/ffp/geometry/mass.hpp"
#include "../../examples/ffp/geometry/tilted.hpp"
#include "catch.hpp"

using namespace arenite;
using namespace arenite::ffp;

TEST_CASE("the sharp device is a cone of 60 degrees under a cylinder") {
  const Device d{{}};
  const double h = 0.04375 * std::sqrt(3.0);
  REQUIRE(std::abs(d.tip_end() - h) < 1e-15);
  REQUIRE(d.profile(-1) == 0);
  REQUIRE(d.profile(0) == 0);
  REQUIRE(std::abs(d.profile(0.03) - 0.03 / std::sqrt(3.0)) < 1e-15);
  REQUIRE(d.profile(h + 1e-12) == 0.04375);
  const double volume = pi * 0.04375 * 0.04375 * (h / 3 + 0.631 - h);
  REQUIRE(std::abs(d.volume() - volume) < 1e-12 * volume);
}

TEST_CASE("a rounded edge touches cone and cylinder") {
  const ConeSection d{{.fillet = 0.01}};
  const double tangent = 0.01 * std::tan(15 * pi / 180), h = d.cone_height();
  REQUIRE(std::abs(d.fillet_end() - (h + tangent)) < 1e-15);
  REQUIRE(std::abs(d.fillet_start() - (h - tangent * std::cos(30 * pi / 180))) < 1e-15);
  for (const double y : {d.fillet_start(), d.fillet_end()})  // continuous, with a continuous slope
    REQUIRE(std::abs(d.profile(y + 1e-9) - d.profile(y - 1e-9)) < 2e-9);
  const auto slope = [&](double y) { return (d.profile(y + 1e-7) - d.profile(y - 1e-7)) / 2e-7; };
  REQUIRE(std::abs(slope(d.fillet_start() + 2e-7) - std::tan(30 * pi / 180)) < 1e-3);
  REQUIRE(std::abs(slope(d.fillet_end() - 2e-7)) < 1e-3);
  for (const double y : d.marks(1e-3)) {  // on the circle
    const double r = d.profile(y) - (0.04375 - 0.01), up = y - d.fillet_end();
    REQUIRE(std::abs(std::hypot(r, up) - 0.01) < 1e-12);
  }
  REQUIRE(d.marks(0.005).size() == 2);  // the arc is 5.24 mm long: one facet
  REQUIRE(d.marks(0.006).size() == 1);  // too short for one
  REQUIRE(d.marks(0.001).size() == 6);  // five
  REQUIRE(Device{{.fillet = 0.01}}.volume() < Device{{}}.volume());
}

TEST_CASE("other tips: a flat end, a parabola, no tip at all") {
  const Device cut{{.flat = 0.0022}}, round{{.parabola = 0.024184}}, blunt{{.flat = 0.04375}};
  REQUIRE(std::abs(cut.tip_end() - (0.04375 - 0.0022) * std::sqrt(3.0)) < 1e-15);
  REQUIRE(std::abs(round.tip_end() - 0.04375 * 0.04375 / 0.024184) < 1e-15);
  REQUIRE(blunt.tip_end() == 0);
  REQUIRE((cut.profile(0) == 0.0022 && round.profile(0) == 0 && blunt.profile(0) == 0.04375));
  REQUIRE(std::abs(cut.profile(0.03) - 0.0022 - 0.03 / std::sqrt(3.0)) < 1e-15);
  REQUIRE(std::abs(round.profile(0.03) - std::sqrt(0.024184 * 0.03)) < 1e-15);
  for (const Device& d : {cut, round, blunt}) {
    REQUIRE(d.profile(-1e-9) == 0);
    REQUIRE(d.profile(0.08) == 0.04375);
    for (const Point2& x : d.outline())
      if (x[0] > 0) REQUIRE((x[1] == 0 || std::abs(x[0] - d.profile(x[1])) < 1e-12));
  }
  const double r = 0.04375, h = cut.tip_end(), k = round.tip_end();
  const double frustum = pi / 3 * h * (r * r + r * 0.0022 + 0.0022 * 0.0022);
  REQUIRE(std::abs(cut.volume() - frustum - pi * r * r * (0.631 - h)) < 1e-15);
  REQUIRE(std::abs(round.volume() / (pi * r * r * (0.631 - k / 2)) - 1) < 1e-4);  // facets inside
  REQUIRE(std::abs(blunt.volume() - pi * r * r * 0.631) < 1e-15);
}

TEST_CASE("mass of a homogeneous penetrometer: that of a cylinder, and of a cone below one") {
  const double r = 0.04375, length = 0.631;
  const MassOf blunt = mass_in(Device{{.flat = r}});
  REQUIRE(std::abs(blunt.centre - length / 2) < 1e-15);
  REQUIRE(std::abs(square(blunt.gyration) - (length * length / 12 + r * r / 4)) < 1e-15);
  // A cone of height h on its tip: centre 3/4 h, about its centre 3/80 (4 r^2 + h^2).
  const Device sharp{{}};
  const double h = sharp.tip_end(), tall = length - h, cone = h / 3,
               centre = (cone * h * 3 / 4 + tall * (h + tall / 2)) / (cone + tall);
  const double second = cone * (3. / 80 * (4 * r * r + h * h) + square(h * 3 / 4 - centre)) +
                        tall * (tall * tall / 12 + r * r / 4 + square(h + tall / 2 - centre));
  const MassOf mass = mass_in(sharp);
  REQUIRE(std::abs(mass.centre - centre) < 1e-14);
  REQUIRE(std::abs(square(mass.gyration) - second / (cone + tall)) < 1e-14);
}

TEST_CASE(
    "the penetrometer in space: its distance is that of a cone on a cylinder, its lowest point on the sand") {
  const ConeCylinder cone{{.radius = 0.04375, .apex = 60 * pi / 180, .length = 0.631}};
  const TurnedSection turned{whole_section(Device{{}})};
  for (const double x : {-0.1, -0.02, 0.0, 0.03})
    for (const double y : {-0.05, 0.01, 0.09, 0.4, 0.7})
      for (const double z : {0.0, 0.02, 0.06}) {
        const Vec<double, 3> at(x, y, z);
        REQUIRE(std::abs(turned(at) - cone(at)) < 1e-15);
      }
  REQUIRE((turned.bounds().upper[2] == 0.04375 && turned.bounds().lower[1] == 0));
  for (const double flat : {0.0, 0.0022, 0.04375})
    for (const double offset : {0.0, -0.002})
      for (const double tilt : {0.0, 0.1, 0.5}) {
        const Device met{{.flat = flat, .offset = offset}};
        const DeviceStart start(met, tilt);
        const auto body = placed(TurnedSection{whole_section(met)}, start.placement());
        double lowest = 1;
        for (int k = -20000; k <= 20000; ++k)  // along y = 0 and just below
          lowest = std::min({lowest, body(Vec<double, 3>(k * 5e-6, 0, 0))});
        REQUIRE(std::abs(lowest) < 3e-6);
        REQUIRE(start.lift == Approx(met.flat_radius() * std::sin(tilt)).margin(1e-15));
        REQUIRE(start.tip[0] == Approx(-met.tip_above() * std::sin(tilt)).margin(1e-15));
        REQUIRE(start.tip[1] == Approx(start.lift + met.tip_above() * std::cos(tilt)).margin(1e-15));
      }
}

TEST_CASE("the surface that the sand touches is parallel to the penetrometer's") {
  // Any of its points, in the penetrometer's own place, lies at the offset from the penetrometer's line.
  for (const double offset : {-0.015, -0.003, -0.0005, 0.0005, 0.003, 0.015})
    for (DeviceShape shape : {DeviceShape{}, DeviceShape{.fillet = 0.02}, DeviceShape{.flat = 0.0022},
                              DeviceShape{.flat = 0.04375}, DeviceShape{.parabola = 0.024184}}) {
      INFO("offset " << offset << " fillet " << shape.fillet << " flat " << shape.flat);
      shape.offset = offset;
      const Device met{shape}, body = met.instrument();
      REQUIRE(body.radius() == 0.04375);
      REQUIRE(std::abs(met.radius() - body.radius() - offset) < 1e-15);
      const auto line = body.outline();
      const auto distance = [&](const Point2& x) {
        double nearest = 1;
        for (std::size_t k = 1; k + 1 < line.size(); ++k) {
          const Point2 along = line[k] - line[k - 1], from = x - line[k - 1];
          const double t = std::clamp(from.dot(along) / along.squaredNorm(), 0.0, 1.0);
          nearest = std::min(nearest, (from - t * along).norm());
        }
        return nearest;
      };
      // Above a mitre, which lies further out than the offset.
      const double start = shape.parabola > 0 ? met.tip_end() : ConeSection{shape}.fillet_start();
      for (const double y : {0.3 * start, 0.8 * start, met.tip_end() + 0.05}) {
        if (y == 0) continue;  // the mitre of a blunt tip
        const Point2 x{met.profile(y), y - met.tip_above()};
        REQUIRE(std::abs(distance(x) - std::abs(offset)) < 2e-5);
        REQUIRE((x[0] > body.profile(x[1])) == (offset > 0));
      }
    }
  REQUIRE(std::abs(Device{{.offset = 0.003}}.tip_above() - 0.006) < 1e-15);
  REQUIRE(Device{{.flat = 0.0022, .offset = 0.003}}.tip_above() == 0.003);
  REQUIRE(Device{{.flat = 0.0022, .offset = -0.01}}.flat_radius() == 0);  // nothing is left of it
  REQUIRE(Device{{.fillet = 0.002, .offset = -0.003}}.marks(1e-4).size() == 1);
  REQUIRE(std::abs(Device{{.parabola = 0.024184, .offset = 0.003}}.tip_above() - 0.003) < 1e-15);
}

TEST_CASE("areas in the ground are those of solids, at any depth") {
  const auto by_pieces = [](const Device& d, double depth) {  // frusta, without the flat end
    const int n = 20000;
    double area = 0, r = d.profile(0);
    for (int k = 1; k <= n; ++k) {
      const double y = std::min(depth, d.tip_end() - 1e-12) * k / n, next = d.profile(y);
      area += pi * (r + next) * std::hypot(next - r, std::min(depth, d.tip_end()) / n);
      r = next;
    }
    return area;
  };
  const double r = 0.04375;
  for (const DeviceShape& shape :
       {DeviceShape{}, DeviceShape{.fillet = 0.01}, DeviceShape{.flat = 0.0022},
        DeviceShape{.flat = 0.0022, .fillet = 0.002}, DeviceShape{.parabola = 0.024184}}) {
    const Device d{shape};
    for (const double depth : {0.01, 0.04, 0.0721, 0.0745, 0.1, 0.3}) {
      INFO("depth " << depth << " flat " << shape.flat << " fillet " << shape.fillet);
      const double flat = pi * shape.flat * shape.flat;
      REQUIRE(std::abs(d.mantle_area(depth) - flat - by_pieces(d, depth)) < 2e-5 * d.mantle_area(depth));
      REQUIRE(d.projected_area(depth) == pi * d.profile(depth) * d.profile(depth));
    }
    REQUIRE((d.projected_area(-0.01) == 0 && d.mantle_area(-0.01) == 0));
    REQUIRE(std::abs(d.projected_area(0.2) - pi * r * r) < 1e-15);
  }
  const Device cone{{}}, wide{{.offset = 0.003}}, blunt{{.flat = r}};
  const double in = 0.03 / std::sqrt(3.0);
  REQUIRE(std::abs(cone.mantle_area(0.03) - pi * in * std::hypot(in, 0.03)) < 1e-15);
  REQUIRE(std::abs(cone.mantle_area(0.2) - 2 * cone.projected_area(0.2)) < 1e-15);
  REQUIRE((wide.mantle_area(0.03) == cone.mantle_area(0.03) && wide.projected_area(1) == pi * r * r));
  REQUIRE(wide.mantle_area(0.2) == cone.mantle_area(0.2));
  REQUIRE((blunt.projected_area(0) == pi * r * r && blunt.mantle_area(0.1) == pi * r * r));
}

TEST_CASE("a device that does not fit together is refused") {
  REQUIRE_THROWS_AS(Device{{.radius = 0}}, error);
  REQUIRE_THROWS_AS(Device{{.length = 0.07}}, error);
  REQUIRE_THROWS_AS(Device{{.fillet = -0.01}}, error);
  REQUIRE_THROWS_AS(Device{{.fillet = 0.5}}, error);
  REQUIRE_THROWS_AS(Device{{.flat = 0.05}}, error);
  REQUIRE_THROWS_AS((Device{{.flat = 0.04375, .fillet = 0.001}}), error);
  REQUIRE_THROWS_AS((Device{{.parabola = 0.02, .fillet = 0.001}}), error);
  REQUIRE_THROWS_AS(Device{{.offset = -0.05}}, error);
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
