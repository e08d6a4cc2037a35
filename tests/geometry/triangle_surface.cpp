// Closed surfaces of triangles: exact distances against all triangles and against closed forms, mass and
// inertia, what is refused.
#include <arenite/fill/regions.hpp>
#include <arenite/geometry/mass_properties.hpp>
#include <arenite/geometry/solids.hpp>
#include <arenite/geometry/triangle_surface.hpp>
#include <random>

#include "catch.hpp"
#include "sample_surfaces.hpp"
#include "validation.hpp"

using namespace arenite;
using namespace arenite::test;

namespace {

using P = Vec<double, 3>;

/// Winding number of a surface about x, 1 inside and 0 outside: the sum of solid angles (Van Oosterom and
/// Strackee 1983) over 4 pi.
double winding(const TriangleData& data, const P& x) {
  double angle = 0;
  for (const auto& t : data.triangles) {
    const P a = data.vertices[t[0]] - x, b = data.vertices[t[1]] - x, c = data.vertices[t[2]] - x;
    angle += 2 * std::atan2(a.dot(b.cross(c)), a.norm() * b.norm() * c.norm() + a.dot(b) * c.norm() +
                                                   b.dot(c) * a.norm() + c.dot(a) * b.norm());
  }
  return angle / (4 * pi);
}

/// Distance to a triangle by projections, to its plane and to each edge: another way than the library's.
double distance_to(const P& a, const P& b, const P& c, const P& x) {
  const P n = (b - a).cross(c - a).normalized();
  const auto left_of = [&](const P& p, const P& q) { return (q - p).cross(x - p).dot(n) >= 0; };
  if (left_of(a, b) && left_of(b, c) && left_of(c, a)) return std::abs((x - a).dot(n));
  const auto to_edge = [&](const P& p, const P& q) {
    const double t = std::clamp((x - p).dot(q - p) / (q - p).squaredNorm(), 0.0, 1.0);
    return (x - p - t * (q - p)).norm();
  };
  return std::min({to_edge(a, b), to_edge(b, c), to_edge(c, a)});
}

/// Worst deviation from the distance to all triangles with the sign of the winding number.
double worst(const TriangleData& data, double size, int places) {
  const TriangleSurface surface(data);
  std::mt19937 random(7);
  std::uniform_real_distribution<double> uniform(-size, size);
  double off = 0;
  for (int n = 0; n < places; ++n) {
    const P x(uniform(random), uniform(random), uniform(random));
    double nearest = 1e9;
    for (const auto& t : data.triangles)
      nearest =
          std::min(nearest, distance_to(data.vertices[t[0]], data.vertices[t[1]], data.vertices[t[2]], x));
    const bool inside = winding(data, x) > 0.5;
    off = std::max(off, std::abs(surface(x) - (inside ? -nearest : nearest)));
    REQUIRE(surface.contains(x) == inside);
  }
  return off;
}

/// A star: vertices of the ball pulled in and out, with edges and corners sharp either way.
TriangleData star(int levels, double by) {
  TriangleData data = ball_surface(levels);
  std::mt19937 random(11);
  std::uniform_real_distribution<double> uniform(1 - by, 1 + by);
  for (auto& x : data.vertices) x *= uniform(random);
  return data;
}

TriangleData joined(TriangleData a, const TriangleData& b) {
  const auto before = static_cast<Index>(a.vertices.size());
  a.vertices.insert(a.vertices.end(), b.vertices.begin(), b.vertices.end());
  for (const auto& t : b.triangles) a.triangles.push_back({t[0] + before, t[1] + before, t[2] + before});
  return a;
}

}  // namespace

TEST_CASE("Triangle surface: the distance is exact, the sign that of the winding number") {
  CHECK(worst(box_surface({-0.5, -0.3, -0.6}, {0.4, 0.5, 0.2}), 1, 3000) < 1e-14);
  CHECK(worst(tetrahedron_surface(), 1, 3000) < 1e-14);
  CHECK(worst(torus_surface(24, 9, 0.4), 1.5, 1000) < 1e-14);
  CHECK(worst(star(3, 0.3), 1.5, 1000) < 1e-14);
  // A cavity, and two surfaces that touch in one vertex.
  TriangleData cavity = box_surface({-0.2, -0.2, -0.2}, {0.2, 0.3, 0.2});
  for (auto& t : cavity.triangles) std::swap(t[1], t[2]);
  CHECK(worst(joined(ball_surface(2), cavity), 1, 1000) < 1e-14);
  TriangleData two = joined(tetrahedron_surface(), tetrahedron_surface());
  for (std::size_t i = 4; i < 8; ++i) two.vertices[i] *= -1;
  for (std::size_t t = 4; t < 8; ++t) {
    std::swap(two.triangles[t][1], two.triangles[t][2]);
    for (Index& i : two.triangles[t]) i = i == 4 ? 0 : i;  // the vertex at the origin is one
  }
  CHECK(worst(two, 1, 3000) < 1e-14);
}

TEST_CASE("Triangle surface: a box is the box, a fine ball the ball") {
  const TriangleSurface box(box_surface({-1, -2, -3}, {1, 2, 3}));
  const Box<3> same{{-1, -2, -3}, {1, 2, 3}};
  std::mt19937 random(5);
  std::uniform_real_distribution<double> uniform(-4, 4);
  for (int n = 0; n < 5000; ++n) {
    const P x(uniform(random), uniform(random), uniform(random));
    REQUIRE(box(x) == Approx(same(x)).margin(1e-14));
    REQUIRE(box.contains(x) == same.contains(x));
  }
  CHECK(box.bounds().lower == same.lower);
  const P on_corner(1, 2, 3);
  CHECK(box(on_corner) == 0);
  const Ball ball({0, 0, 0}, 1);
  double before = 0;
  for (int levels = 2; levels < 6; ++levels) {  // second order in the edge
    const TriangleSurface fine(ball_surface(levels));
    double off = 0;
    for (int n = 0; n < 500; ++n) {
      const P x(uniform(random) / 2, uniform(random) / 2, uniform(random) / 2);
      off = std::max(off, std::abs(fine(x) - ball(x)));
    }
    if (before > 0) CHECK(std::log2(before / off) == Approx(2).margin(0.3));
    before = off;
  }
  static_assert(signed_distance<TriangleSurface, 3> && region_type<TriangleSurface, 3>);
  static_assert(!region_type<TriangleSurface, 2>);
}

TEST_CASE("Triangle surface: neighbours share no position and leave none out") {
  // A cube of four by four by four cubes, and places on their faces, edges and corners.
  std::vector<TriangleSurface> cubes;
  for (int i = 0; i < 64; ++i) {
    const P low(i % 4, i / 4 % 4, i / 16);
    const P high = low + P::Ones();
    cubes.emplace_back(box_surface(low / 4, high / 4));
  }
  std::mt19937 random(9);
  std::uniform_int_distribution<int> lattice(1, 15);
  std::uniform_real_distribution<double> uniform(0, 1);
  for (int n = 0; n < 2000; ++n) {
    P x(lattice(random) / 16.0, lattice(random) / 16.0, lattice(random) / 16.0);
    if (n % 2 == 1) x[n % 3] = uniform(random);
    int holders = 0;
    for (const auto& cube : cubes) holders += cube.contains(x);
    REQUIRE(holders == 1);
  }
}

TEST_CASE("Mass and inertia: closed forms") {
  const auto box = mass_properties(box_surface({9, 8, 7}, {10, 10, 10}), 2000);
  CHECK(box.mass == Approx(12000));
  CHECK((box.centre - P(9.5, 9, 8.5)).norm() < 1e-13);
  const P sides(1, 2, 3);
  for (int i = 0; i < 3; ++i)
    for (int k = 0; k < 3; ++k)
      CHECK(box.inertia(i, k) ==
            Approx(i == k ? 1000 * (sides.squaredNorm() - sides[i] * sides[i]) : 0).margin(1e-9));
  const auto corner = mass_properties(tetrahedron_surface(), 6);  // of mass 1
  CHECK(corner.mass == Approx(1));
  CHECK((corner.centre - P(0.25, 0.25, 0.25)).norm() < 1e-15);
  CHECK(corner.inertia(0, 0) == Approx(3.0 / 40));
  CHECK(corner.inertia(0, 1) == Approx(1.0 / 80));  // -integral of x y about the centre: 1/16 - 1/20
  Validation validation("surfaces");
  validation.value("box of 12 triangles", "moment of inertia about x", "kg m2", box.inertia(0, 0), 13000);
  validation.value("tetrahedron", "product of inertia xy", "kg m2", corner.inertia(0, 1), 1.0 / 80);
  const auto refined = [&](int levels) {
    const TriangleData data = ball_surface(levels);
    const auto p = mass_properties(TriangleSurface(data), 3 / (4 * pi));
    CHECK(p.centre.norm() < 1e-15);
    const std::string name = joined_text({"ball of ", data.triangles.size(), " triangles"});
    if (levels > 2) {
      validation.value(name, "mass", "kg", p.mass, 1);
      validation.value(name, "moment of inertia", "kg m2", p.inertia(0, 0), 0.4);
    }
    return std::array{std::abs(p.mass - 1), (p.inertia - 0.4 * Mat<double, 3>::Identity()).norm()};
  };
  auto coarse = refined(2);
  for (int levels = 3; levels < 6; ++levels) {
    const auto fine = refined(levels);
    for (std::size_t k = 0; k < 2; ++k) CHECK(std::log2(coarse[k] / fine[k]) == Approx(2).margin(0.15));
    coarse = fine;
  }

  const auto square = mass_properties(Polygon({{4, 5}, {4, 8}, {6, 8}, {6, 5}}), 10);  // clockwise
  CHECK(square.mass == Approx(60));
  CHECK((square.centre - Vec<double, 2>(5, 6.5)).norm() < 1e-14);
  CHECK(square.inertia == Approx(60 * (4 + 9) / 12.0));
  const auto triangle = mass_properties(Polygon({{0, 0}, {1, 0}, {0, 1}}));
  CHECK(triangle.inertia == Approx(1.0 / 18));
  std::vector<Polygon::Corner> circle;
  for (int k = 0; k < 1000; ++k) circle.push_back({std::cos(2 * pi * k / 1000), std::sin(2 * pi * k / 1000)});
  CHECK(mass_properties(Polygon(circle), 1 / pi).inertia == Approx(0.5).epsilon(2e-5));
}

TEST_CASE("Triangle surface: what is refused names the edge") {
  using Catch::Matchers::Contains;
  const TriangleData box = box_surface({0, 0, 0}, {1, 1, 1});
  const auto with = [&](auto&& change) {
    TriangleData data = box;
    change(data);
    return TriangleSurface(data);
  };
  CHECK_THROWS_WITH(
      with([](auto& d) { d.triangles.pop_back(); }),
      Contains("edge = (1, 0, 0) to (1, 0, 1): belongs to this triangle alone, one of 3 such edges: "
               "an open surface, as of terrain, is no body") &&
          Contains("Close it (terrain: "));
  CHECK_THROWS_WITH(with([](auto& d) { std::swap(d.triangles[3][0], d.triangles[3][1]); }),
                    Contains("runs along it in the same sense"));
  CHECK_THROWS_WITH(with([](auto& d) { d.triangles.push_back(d.triangles[0]); }),
                    Contains("TriangleSurface.triangles[0], edge = (0, 0, 0)") && Contains("belongs to 3"));
  CHECK_THROWS_WITH(with([](auto& d) {
                      for (auto& t : d.triangles) std::swap(t[0], t[1]);
                    }),
                    Contains("TriangleSurface.volume = -1: must be positive"));
  CHECK_THROWS_WITH(with([](auto& d) { d.vertices[3][1] = NAN; }),
                    Contains("TriangleSurface.vertices[3] = (1, nan, 0): must be finite"));
  CHECK_THROWS_WITH(with([](auto& d) {
                      d.triangles[5] = {0, 8, 1};
                    }),
                    Contains("TriangleSurface.triangles[5] = 8: must be a vertex"));
  CHECK_THROWS_WITH(with([](auto& d) {
                      d.triangles[5] = {0, 0, 1};
                    }),
                    Contains("TriangleSurface.triangles[5].area = 0: a triangle must not be flat"));
  CHECK_THROWS_WITH(TriangleSurface({}), Contains("TriangleSurface.triangles = 0: must be at least four"));
  CHECK_THROWS_WITH(mass_properties(box, -1), Contains("mass_properties: density = -1: must be positive"));
}
