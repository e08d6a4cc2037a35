// Balls, polygons and what is made of several: areas and volumes in closed form, sides that are shared, and
// what is refused.
#include <arenite/fill/regions.hpp>
#include <arenite/law/linear_elastic.hpp>
#include <arenite/mesh/cartesian_grid.hpp>
#include <arenite/particles/body.hpp>
#include <random>

#include "catch.hpp"

using namespace arenite;

namespace {

/// Share of the unit square, or cube, that lies in a region, by a lattice of points.
template <int D, class Region>
double share(const Region& region, int n) {
  int inside = 0, all = 0;
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < n; ++j)
      for (int k = 0; k < (D == 3 ? n : 1); ++k, ++all) {
        Vec<double, D> x;
        x[0] = (i + 0.5) / n;
        x[1] = (j + 0.5) / n;
        if constexpr (D == 3) x[2] = (k + 0.5) / n;
        inside += region.contains(x);
      }
  return static_cast<double>(inside) / all;
}

}  // namespace

TEST_CASE("Regions: areas and volumes in closed form") {
  const Ball disc({0.5, 0.5}, 0.4);
  CHECK(share<2>(disc, 1000) == Approx(pi * 0.16).epsilon(1e-3));
  CHECK(share<3>(Ball({0.5, 0.5, 0.5}, 0.4), 100) == Approx(4 * pi / 3 * 0.064).epsilon(2e-3));
  const Polygon triangle({{0, 0}, {1, 0}, {0, 1}}), other_way({{0, 1}, {1, 0}, {0, 0}});
  CHECK(share<2>(triangle, 1001) == Approx(0.5).epsilon(2e-3));
  CHECK(share<2>(triangle, 1001) == share<2>(other_way, 1001));
  const Polygon angle({{0, 0}, {1, 0}, {1, 0.25}, {0.25, 0.25}, {0.25, 1}, {0, 1}});  // an L
  CHECK(share<2>(angle, 100) == 0.4375);
  const Polygon star({{0, 0}, {1, 0}, {0, 1}, {1, 1}});  // crosses itself: two triangles
  CHECK(share<2>(star, 1000) == Approx(0.5).epsilon(2e-3));

  const Box<2> half{{0, 0}, {1, 0.5}};
  CHECK(share<2>(half - disc, 1000) == Approx(0.5 - pi * 0.08).epsilon(2e-3));
  CHECK(share<2>(half & disc, 1000) == Approx(pi * 0.08).epsilon(2e-3));
  CHECK(share<2>(half | disc, 1000) == Approx(0.5 + pi * 0.08).epsilon(2e-3));
  CHECK(share<2>((half | disc) - Ball({0.5, 0.5}, 0.2), 1000) ==
        Approx(0.5 + pi * 0.08 - pi * 0.04).epsilon(2e-3));
}

TEST_CASE("Regions: polygons that share sides share no position and leave none out") {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> uniform(0, 1);
  const std::vector<Polygon::Corner> rim{{0, 0}, {0.3, 0}, {1, 0}, {1, 0.7},
                                         {1, 1}, {0.4, 1}, {0, 1}, {0, 0.2}};
  const Polygon::Corner middle{0.37, 0.61};
  std::vector<Polygon> fan;
  for (std::size_t i = 0; i < rim.size(); ++i)
    fan.emplace_back(std::vector{middle, rim[i], rim[(i + 1) % rim.size()]});
  const auto count = [&](double x, double y) {
    int n = 0;
    for (const auto& p : fan) n += p.contains({x, y});
    return n;
  };
  for (int k = 0; k < 20000; ++k) REQUIRE(count(uniform(random), uniform(random)) == 1);
  for (int k = 0; k < 1000; ++k) {  // on the sides between them
    const auto& corner = rim[static_cast<std::size_t>(k) % rim.size()];
    const double s = uniform(random);
    REQUIRE(count(middle[0] + s * (corner[0] - middle[0]), middle[1] + s * (corner[1] - middle[1])) == 1);
  }
  CHECK(count(middle[0], middle[1]) == 1);
  CHECK(count(0, 0.5) + count(1, 0.5) == 1);  // of two sides across from each other one belongs to it
  CHECK(count(0.5, 0) + count(0.5, 1) == 1);
}

TEST_CASE("Regions: bodies are filled with them") {
  const CartesianGrid<2> grid({.lower = {0, 0}, .upper = {1, 1}, .cell = 0.02});
  const LinearElastic law{{.density = 2000, .young = 1e6, .poisson = 0.3}};
  const auto body = make_body<PlaneStrain>(
      grid, fill(Box<2>{{0, 0}, {1, 1}} - Ball({0.5, 0.5}, 0.3), law, {.per_cell = 16}));
  CHECK(body.initial_volume == Approx(1 - pi * 0.09).epsilon(2e-3));
  CHECK(AnyRegion::of<2>(Ball({0.5, 0.5}, 0.3)).has_bounds);
}

TEST_CASE("Regions: what is refused") {
  using Catch::Matchers::Contains;
  CHECK_THROWS_WITH(Ball({0., 0.}, -1), Contains("Ball.radius = -1: must be positive"));
  CHECK_THROWS_WITH(Ball({0., NAN}, 1), Contains("Ball.centre[1]") && Contains("must be finite"));
  CHECK_THROWS_WITH(Polygon({{0, 0}, {1, 0}}), Contains("Polygon.corners = 2: must be at least three"));
  CHECK_THROWS_WITH(Polygon({{0, 0}, {1, 0}, {2, 0}}), Contains("must enclose an area"));
  CHECK_THROWS_WITH(Polygon({{0, 0}, {1, 0}, {INFINITY, 1}}), Contains("Polygon.corners[2][0] = inf"));
  static_assert(!region_type<Ball<2>, 3> && !region_type<Polygon, 3>);
  static_assert(!region_type<UnionOf<Ball<2>, Ball<3>>, 2>);
}
