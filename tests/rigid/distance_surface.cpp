// A signed distance as the surface of a rigid body: which nodes it touches, and with which normals.
#include "catch.hpp"

#include <arenite/core/units.hpp>
#include <arenite/geometry/cone_cylinder.hpp>
#include <arenite/geometry/solids.hpp>
#include <arenite/rigid/body/surface.hpp>
#include <random>
#include <stdexcept>

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
  BoundDistanceSurface<double, 2> bound(type_erased<M>(surface));
  std::vector<Touched> all;
  bound.template visit<Shape>(
      mesh, displacement, [](Index) { return true; },
      [&](Index i, const P& n, bool inside, double fraction) {
        REQUIRE(inside == (n.squaredNorm() == 0));  // no slope, no way out
        REQUIRE(fraction == 0);
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
    const double foot = (x[0] + x[1]) / 2;  // radius where the normal through the node hits the flank
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

namespace {

/// A ball with a bounding box.
template <int D>
struct DistanceToBall {
  Vec<double, D> centre;
  double radius;
  double operator()(const Vec<double, D>& x) const { return (x - centre).norm() - radius; }
  Box<std::size_t{D}> bounds() const {
    Box<std::size_t{D}> box;
    for (std::size_t k = 0; k < D; ++k) {
      box.lower[k] = centre[static_cast<int>(k)] - radius;
      box.upper[k] = centre[static_cast<int>(k)] + radius;
    }
    return box;
  }
};

template <class V>
struct Visited {
  Index node;
  V normal;
  bool inside;
};

/// The nodes that the plain loop over all finds: the definition.
template <class Shape, class M, class Distance>
auto plainly_visited(const M& mesh, const Distance& distance, double reach,
                     const Vec<double, M::dimension>& displacement, const std::vector<bool>& has_mass) {
  using V = Vec<double, M::dimension>;
  std::vector<Visited<V>> all;
  for (Index i = 0; i < Shape::node_count(mesh); ++i) {
    if (!has_mass[i]) continue;
    const V x = Shape::node_position(mesh, i) - displacement;
    const double cell = mesh.node_size(i);
    if (distance(x) > reach * cell) continue;
    V slope;
    for (int k = 0; k < M::dimension; ++k) {
      const V step = 1e-4 * cell * V::Unit(k);
      slope[k] = distance(V(x + step)) - distance(V(x - step));
    }
    all.push_back({i, slope.normalized(), slope.norm() == 0});
  }
  return all;
}

/// Compares the two, with a box and without, on one thread and on several.
template <class Shape, class M, class Distance>
std::size_t compare_visits(const M& mesh, const Distance& distance, double reach,
                           const Vec<double, M::dimension>& displacement, const std::vector<bool>& has_mass) {
  using V = Vec<double, M::dimension>;
  const auto wanted = plainly_visited<Shape>(mesh, distance, reach, displacement, has_mass);
  const auto compare = [&](const auto& surface) {
    BoundDistanceSurface<double, M::dimension> bound(type_erased<M>(surface));
    for (const int n : {1, 3}) {
      set_threads(n);
      for (int again = 0; again < 2; ++again) {
        std::size_t k = 0, wrong = 0;
        bound.template visit<Shape>(
            mesh, displacement, [&](Index i) { return has_mass[i]; },
            [&](Index i, const V& normal, bool inside, double) {
              wrong += k >= wanted.size() || wanted[k].node != i || wanted[k].normal != normal ||
                       wanted[k].inside != inside;
              ++k;
            });
        REQUIRE(wrong == 0);
        REQUIRE(k == wanted.size());
      }
    }
  };
  compare(DistanceSurface{distance, reach});
  compare(DistanceSurface{[&](const V& x) { return distance(x); }, reach});
  return wanted.size();
}

std::vector<bool> random_matter(std::size_t nodes, std::mt19937& random) {
  std::vector<bool> has_mass(nodes);
  const auto every = 1 + random() % 3;
  for (std::size_t i = 0; i < nodes; ++i) has_mass[i] = random() % every == 0;
  return has_mass;
}

}  // namespace

TEST_CASE("no node is lost to a body's box, to material or to threads: random bodies beside the plain loop") {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> uniform(0, 1);
  const CartesianGrid<2> fine({.lower = {-1, -1}, .upper = {1, 1}, .cell = 0.025});  // 6,724 nodes
  const CartesianGrid<3> space({.lower = {-1, -1, -1}, .upper = {1, 1, 1}, .cell = 0.125});
  const auto triangles = sample_mesh<2>(30, 0.3);
  std::size_t found = 0;
  for (int k = 0; k < 40; ++k) {
    const double reach = k % 4 == 0 ? 0 : 2 * uniform(random);
    const P way = k % 5 == 0 ? P(0, 0) : P(uniform(random) - 0.5, uniform(random) - 0.5);
    // Every other body is aligned with the nodes: its box then touches them to the last digit.
    const double on_grid = 0.025 * static_cast<double>(random() % 20);
    const double radius = k % 2 == 0 ? 0.025 + on_grid : 0.01 + 0.6 * uniform(random);
    const P centre = k % 2 == 0 ? P(-on_grid, on_grid) : P(uniform(random), uniform(random));
    const DistanceToBall<2> disc{centre, radius};
    const ConeCylinder cone(
        {.radius = radius, .apex = 0.2 + 2.5 * uniform(random), .length = 9 * radius + 1});
    const auto cone_2d = [&](const auto& mesh, auto shape) {
      using Shape = decltype(shape);
      const auto matter = random_matter(Shape::node_count(mesh), random);
      return compare_visits<Shape>(mesh, disc, reach, way, matter) +
             compare_visits<Shape>(mesh, cone, reach, way, matter);
    };
    found += cone_2d(fine, QuadraticBSpline{});
    found += cone_2d(triangles, LinearSimplex{});
    const DistanceToBall<3> ball{{centre[0], centre[1], 0.3}, radius};
    const auto matter = random_matter(QuadraticBSpline::node_count(space), random);
    found += compare_visits<QuadraticBSpline>(space, ball, reach, {way[0], way[1], 0.1}, matter);
    found += compare_visits<QuadraticBSpline>(space, cone, reach, {way[0], way[1], 0.1}, matter);
  }
  REQUIRE(found > 10000);
  set_threads(2);
}

TEST_CASE("a distance is asked only near the body, and where there is material") {
  struct Counting : DistanceToBall<2> {
    std::size_t* calls;
    double operator()(const P& x) const {
      ++*calls;
      return DistanceToBall<2>::operator()(x);
    }
  };
  set_threads(1);
  const CartesianGrid<2> fine({.lower = {-1, -1}, .upper = {1, 1}, .cell = 0.025});
  std::size_t calls = 0;
  BoundDistanceSurface<double, 2> bound(
      type_erased<CartesianGrid<2>>(DistanceSurface{Counting{{{0, 0}, 0.1}, &calls}, 0.0}));
  std::size_t touched = 0;
  const auto visit = [&](auto&& has_mass) {
    calls = touched = 0;
    bound.visit<QuadraticBSpline>(fine, P(0, 0), has_mass, [&](Index, const P&, bool, double) { ++touched; });
  };
  visit([](Index) { return true; });
  CHECK(touched == 52);
  CHECK(calls == 64 + 4 * touched);  // 8 x 8 nodes in the box
  visit([](Index) { return false; });
  CHECK(touched == 0);
  CHECK(calls == 0);
}

TEST_CASE("what a distance throws comes through, on any number of threads") {
  const CartesianGrid<2> fine({.lower = {-1, -1}, .upper = {1, 1}, .cell = 0.025});
  const auto broken = [](const P& x) {
    if (x[1] > 0.9) throw std::runtime_error("off the table");
    return x[0];
  };
  for (const int n : {1, 2}) {
    set_threads(n);
    CHECK_THROWS_WITH(touched<QuadraticBSpline>(fine, DistanceSurface{broken}, P(0, 0)), "off the table");
    CHECK(!touched<QuadraticBSpline>(fine, DistanceSurface{broken}, P(0, 2)).empty());
  }
}

namespace {

/// Sends a bar through a mesh, turning, and compares the nodes that one surface touches, call after call,
/// with a walk over all nodes.
template <class Shape, class M>
int touched_on_the_way(const M& mesh) {
  const RoundedBox bar({-0.15, -0.05}, {0.15, 0.05}, 0.02);
  const double reach = 0.5;
  BoundDistanceSurface<double, 2> bound(type_erased<M>(DistanceSurface{bar, reach}));
  int touched = 0;
  for (int k = 0; k < 200; ++k) {
    const double angle = 0.03 * k, c = std::cos(angle), s = std::sin(angle);
    Pose<2> pose{P(0.01, 0.02), P(0.1 + 0.004 * k, 0.3 + 0.002 * k), {}};
    pose.rotation << c, -s, s, c;
    std::vector<Index> found, expected;
    const auto has_mass = [](Index i) { return i % 7 != 0; };
    bound.template visit<Shape>(mesh, pose, has_mass,
                                [&](Index i, const P&, bool, double) { found.push_back(i); });
    for (Index i = 0; i < Shape::node_count(mesh); ++i) {
      const P x = pose.to_body(Shape::node_position(mesh, i));
      if (has_mass(i) && bar(x) <= reach * mesh.node_size(i)) expected.push_back(i);
    }
    REQUIRE(found == expected);
    touched += static_cast<int>(found.size());
  }
  return touched;
}

}  // namespace

TEST_CASE("a body that moves and turns touches the nodes that a walk over all finds, in their order") {
  const CartesianGrid<2> fine({.lower = {0, 0}, .upper = {1, 1}, .cell = 0.02});
  CHECK(touched_on_the_way<QuadraticBSpline>(fine) > 10000);
  CHECK(touched_on_the_way<LinearSimplex>(sample_mesh<2>(30)) > 1000);
}
