// Shapes as signed distances: against samples of their surfaces, the eikonal equation, and hand values.
#include <arenite/core/units.hpp>
#include <arenite/fill/regions.hpp>
#include <arenite/geometry/cone_cylinder.hpp>
#include <random>

#include "catch.hpp"

using namespace arenite;

namespace {

template <int D>
Vec<double, D> any_place(std::mt19937& random, double size) {
  std::uniform_real_distribution<double> uniform(-size, size);
  Vec<double, D> x;
  for (int k = 0; k < D; ++k) x[k] = uniform(random);
  return x;
}

/// Checks an exact signed distance: its slope is 1, and the foot x - d grad d lies on the surface. (Where
/// it has no slope, on edges and the medial axis, nothing is required.) Its sign is that of `contains`, and
/// outside of its bounds it is not smaller than the distance to them. Returns the number of places checked.
template <int D, class Shape>
int check_exact(const Shape& shape, double size, bool outside = true, bool inside = true) {
  std::mt19937 random(3);
  const double h = 1e-6 * size;
  const auto box = bounds_of<D>(shape);
  int looked = 0;
  for (int n = 0; n < 3000; ++n) {
    const Vec<double, D> x = any_place<D>(random, size);
    const double d = shape(x);
    if (std::abs(d) > 1e-12 * size) REQUIRE((d < 0) == shape.contains(x));
    REQUIRE(d >= box(x) - 1e-12 * size);
    if (d > 0 ? !outside : !inside) continue;
    Vec<double, D> slope;
    bool smooth = std::abs(d) > 10 * h;
    for (int k = 0; k < D; ++k) {
      const Vec<double, D> step = h * Vec<double, D>::Unit(k);
      const Vec<double, D> above = x + step, below = x - step;
      const double up = shape(above) - d, down = d - shape(below);
      REQUIRE(std::abs(up) <= h * (1 + 1e-6));  // no steeper than 1 anywhere
      smooth = smooth && std::abs(up - down) < 1e-4 * h;
      slope[k] = (up + down) / (2 * h);
    }
    if (!smooth) continue;
    ++looked;
    REQUIRE(slope.norm() == Approx(1).epsilon(1e-4));
    const Vec<double, D> foot = x - d * slope;
    REQUIRE(std::abs(shape(foot)) < 2e-4 * size);
  }
  return looked;
}

}  // namespace

TEST_CASE("Shapes: signed distances are exact outside and inside") {
  CHECK(check_exact<2>(Ball({0.2, -0.1}, 0.6), 1) > 2000);
  CHECK(check_exact<3>(Ball({0.2, -0.1, 0.1}, 0.6), 1) > 2000);
  CHECK(check_exact<2>(Box<2>{{-0.5, -0.2}, {0.7, 0.6}}, 1) > 2000);
  CHECK(check_exact<3>(Box<3>{{-0.5, -0.2, -0.6}, {0.7, 0.6, 0.5}}, 1) > 2000);
  CHECK(check_exact<2>(RoundedBox({-0.5, -0.2}, {0.7, 0.6}, 0.15), 1) > 2000);
  CHECK(check_exact<3>(RoundedBox({-0.5, -0.2, -0.6}, {0.7, 0.6, 0.5}, 0.4), 1) > 2000);
  CHECK(check_exact<2>(Capsule({-0.4, -0.2}, {0.5, 0.6}, 0.3), 1) > 2000);
  CHECK(check_exact<3>(Capsule({-0.4, -0.2, 0.3}, {0.5, 0.6, 0}, 0.3), 1) > 2000);
  CHECK(check_exact<3>(Cylinder({-0.4, -0.2, 0.3}, {0.5, 0.6, 0}, 0.3), 1) > 2000);
  const Polygon angle({{-0.8, -0.8}, {0.8, -0.8}, {0.8, -0.2}, {0, 0}, {-0.2, 0.8}, {-0.8, 0.8}});
  CHECK(check_exact<2>(angle, 1) > 2000);
  CHECK(check_exact<2>(placed(angle, {.at = {0.1, 0.2, 0}, .turned = {0, 0, 0.7}}), 1) > 2000);
  CHECK(check_exact<3>(placed(Box<3>{{-0.5, -0.2, -0.6}, {0.4, 0.3, 0.5}},
                              {.at = {0.1, 0.2, -0.1}, .turned = {1, -0.4, 0.7}}),
                       1) > 2000);
}

TEST_CASE("Shapes: cone with a flat tip and a rounded edge") {
  const ConeCylinder blunt(
      {.radius = 0.5, .apex = 60_deg, .length = 1.5, .tip = -0.8, .tip_radius = 0.1, .fillet = 0.4});
  CHECK(check_exact<2>(blunt, 1) > 2000);
  CHECK(check_exact<3>(blunt, 1) > 2000);
  CHECK(blunt(Vec<double, 2>(0.05, -0.8)) == Approx(0).margin(1e-15));
  CHECK(blunt(Vec<double, 2>(0.1, -0.9)) == Approx(0.1));
  CHECK(blunt(Vec<double, 2>(0, -0.75)) == Approx(-0.05));
  // Where flank and shaft would intersect: outside of the arc by the gap between circle and corner.
  const double corner = -0.8 + 0.4 / std::tan(30_deg);
  CHECK(blunt(Vec<double, 2>(0.5, corner)) == Approx(0.4 * (1 / std::cos(15_deg) - 1)));
  const ConeCylinder sharp({.radius = 0.5, .apex = 60_deg, .length = 1.5, .tip = -0.8, .tip_radius = 0.1});
  CHECK(sharp(Vec<double, 2>(0.5, corner)) == Approx(0).margin(1e-15));
  // An edge as round as fits; a flat end that lies in the arc's way.
  CHECK(check_exact<2>(ConeCylinder({.radius = 0.5,
                                     .apex = 90_deg,
                                     .length = 0.51,
                                     .tip = -0.3,
                                     .fillet = 0.0099 / std::tan(22.5_deg)}),
                       1) > 1500);
  using Catch::Matchers::Contains;
  const auto make = [](double tip_radius, double fillet) {
    return ConeCylinder(
        {.radius = 1, .apex = 90_deg, .length = 2, .tip_radius = tip_radius, .fillet = fillet});
  };
  CHECK_THROWS_WITH(make(1, 0), Contains("ConeCylinder.tip_radius = 1: must not be negative, and less"));
  CHECK_THROWS_WITH(make(0, 4), Contains("ConeCylinder.fillet = 4: ") && Contains("must fit"));
  CHECK_THROWS_WITH(make(0, NAN), Contains("ConeCylinder.fillet = nan"));
}

TEST_CASE("Shapes: several are a signed distance too, exact on one side") {
  const Ball disc({0.3, 0.1}, 0.5);
  const Box<2> box{{-0.7, -0.4}, {0.2, 0.6}};
  CHECK(check_exact<2>(box | disc, 1, true, false) > 1000);
  CHECK(check_exact<2>(box & disc, 1, false, true) > 10);
  CHECK(check_exact<2>(box - disc, 1, false, true) > 100);
  CHECK((box & disc).bounds<2>().lower[0] == Approx(-0.2));
  CHECK((box | disc).bounds<2>().upper[0] == Approx(0.8));
  CHECK((box - disc).bounds<2>().upper[0] == Approx(0.2));
  const auto both = Inside{[](const auto& x) { return x[1]; }} - disc;
  CHECK(both(Vec<double, 2>(0.3, -0.2)) == Approx(0.2));
  CHECK(both.contains(Vec<double, 2>(2, -0.1)));
  CHECK(AnyRegion::of<2>(box - disc).has_bounds);
  CHECK_FALSE(AnyRegion::of<2>(both).has_bounds);
}

TEST_CASE("Shapes: moved and turned") {
  const auto bar = placed(Box<2>{{0, 0}, {2, 1}}, {.at = {5, 1, 0}, .turned = {0, 0, 90_deg}});
  CHECK(bar.contains(Vec<double, 2>(4.5, 2)));
  CHECK(bar(Vec<double, 2>(4.5, 4)) == Approx(1));
  CHECK(bar.bounds<2>().lower[0] == Approx(4));
  CHECK(bar.bounds<2>().upper[1] == Approx(3));
  const auto lying = placed(Cylinder({0, 0, 0}, {0, 2, 0}, 0.5), {.turned = {90_deg, 0, 0}});
  CHECK(lying(Vec<double, 3>(0, 0, 3)) == Approx(1));
  CHECK(lying(Vec<double, 3>(0, 1, 1)) == Approx(0.5));
}

TEST_CASE("Shapes: what is refused") {
  using Catch::Matchers::Contains;
  CHECK_THROWS_WITH(RoundedBox({0, 0}, {1, 2}, 0.6), Contains("RoundedBox.radius = 0.6: must not exceed"));
  CHECK_THROWS_WITH((Box{{0., 0.}, {1., -2.}}),
                    Contains("Box.upper[1] = -2: must not lie below lower[1] = 0"));
  CHECK_THROWS_WITH((Box<2>{{0, 0}, {std::nan(""), 1}}), Contains("Box.upper[0] = nan"));
  CHECK_THROWS_WITH(RoundedBox({0, 0}, {1, -2}, 0.1), Contains("RoundedBox.upper[1] = -2"));
  CHECK_THROWS_WITH(Capsule({0, 0}, {1, 1}, 0), Contains("Capsule.radius = 0: must be positive"));
  CHECK_THROWS_WITH(Capsule({0, 0}, {1, NAN}, 1), Contains("Capsule.b[1] = nan"));
  CHECK_THROWS_WITH(Cylinder({0, 0, 1}, {0, 0, 1}, 1), Contains("Cylinder.b = (0, 0, 1): must not be a"));
  const auto tilted = placed(Ball({0, 0}, 1), {.turned = {1, 0, 0}});
  CHECK_THROWS_WITH(tilted(Vec<double, 2>(0, 0)), Contains("must move and turn a plane shape in its plane"));
  static_assert(!signed_distance<Ball<2>, 3> && !signed_distance<Polygon, 3> && !signed_distance<Box<3>, 2>);
  static_assert(region_type<ConeCylinder, 2> && region_type<ConeCylinder, 3> && region_type<Cylinder<3>, 3>);
}
