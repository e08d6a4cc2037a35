// A signed distance as the surface of a rigid body: which nodes it touches, and with which normals.
#include "catch.hpp"

#include <arenite/core/units.hpp>
#include <arenite/rigid/cone_cylinder.hpp>
#include <arenite/rigid/surface.hpp>

#include "../mesh/sample_meshes.hpp"

using namespace arenite;
using namespace arenite::test;

namespace {

using P = Vec<double, 2>;

struct Touched {
  Index node;
  P normal;
};

template <class Shape, class M, class Distance>
std::vector<Touched> touched(const M& mesh, DistanceSurface<Distance> surface, P displacement) {
  const BoundDistanceSurface<double, 2, Distance> bound(surface);
  std::vector<Touched> all;
  bound.template visit<Shape>(mesh, displacement, [&](Index i, const P& n, bool inside, double share) {
    REQUIRE(inside == (n.squaredNorm() == 0));  // no slope, no way out
    REQUIRE(share == 0);
    all.push_back({i, n});
  });
  return all;
}

const CartesianGrid<2> grid({.lower = {0, 0}, .upper = {1, 1}, .cell = 0.25});

}  // namespace

TEST_CASE("nodes within reach are touched, where the body is now") {
  const auto floor = [](const P& x) { return x[1]; };
  // Nodes along y: 0, 1/8, 3/8, 5/8, 7/8, 1; six along x.
  REQUIRE(touched<QuadraticBSpline>(grid, DistanceSurface{floor, 0.0}, {0, 0}).size() == 6);
  REQUIRE(touched<QuadraticBSpline>(grid, DistanceSurface{floor, 0.5}, {0, 0}).size() == 12);
  REQUIRE(touched<QuadraticBSpline>(grid, DistanceSurface{floor, 0.5}, {7, 0.3}).size() == 18);
  REQUIRE(touched<QuadraticBSpline>(grid, DistanceSurface{floor, 0.0}, {0, -0.1}).empty());
  for (const auto& t : touched<QuadraticBSpline>(grid, DistanceSurface{floor, 1.0}, {0, 0}))
    REQUIRE((t.normal - P(0, 1)).norm() < 1e-12);
  REQUIRE(throws(
      [&] {
        touched<QuadraticBSpline>(grid, DistanceSurface{floor, -1.0}, {0, 0});
      },
      "DistanceSurface.reach = -1: must not be negative"));
}

TEST_CASE("normals are those of the cone's flank, its shaft and its tip") {
  const ConeCylinder cone({.radius = 0.3, .apex = 90_deg, .length = 0.9});
  const P flank = P(1, -1).normalized();
  int on_flank = 0, on_shaft = 0;
  for (const auto& t : touched<QuadraticBSpline>(grid, DistanceSurface{cone, 0.8}, {0, 0.05})) {
    const P x = QuadraticBSpline::node_position(grid, t.node) - P(0, 0.05);
    const double foot = (x[0] + x[1]) / 2;  // radius where the normal through the node meets the flank
    if (x[0] > x[1] && foot > 0.01 && foot < 0.29) {
      REQUIRE((t.normal - flank).norm() < 1e-6);
      ++on_flank;
    }
    if (x[0] == 0.375 && x[1] > 0.31 && x[1] < 0.9) {
      REQUIRE((t.normal - P(1, 0)).norm() < 1e-12);
      ++on_shaft;
    }
    if (x[0] == 0 && x[1] <= 0) REQUIRE((t.normal - P(0, -1)).norm() < 1e-6);
  }
  REQUIRE(on_flank > 0);
  REQUIRE(on_shaft > 1);
}

TEST_CASE("on a mesh of triangles too") {
  const auto mesh = sample_mesh<2>(4, 0.0);
  const auto wall = [](const P& x) { return 0.5 - x[0]; };  // fills x > 0.5
  const auto all = touched<LinearSimplex>(mesh, DistanceSurface{wall, 0.0}, {0, 0});
  REQUIRE(all.size() == 15);
  for (const auto& t : all) REQUIRE((t.normal - P(-1, 0)).norm() < 1e-12);
}
