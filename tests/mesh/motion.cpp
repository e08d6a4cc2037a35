// Motion of a mesh: shares of the travel, what happens to the cells, and the ends of the road.
#include "catch.hpp"
#include "sample_meshes.hpp"

#include <arenite/mesh/motion.hpp>

using namespace arenite;
using namespace arenite::test;

namespace {

SimplexMesh<2> tall_mesh(double jitter = 0.2) {
  SampleMesh<2> o{};
  o.cells = {2, 20};
  o.upper = {0.2, 2};
  o.jitter = jitter;
  return SimplexMesh<2>(sample_data(o));
}

const MovingMesh<> zones{.fixed_below = 0.2, .moving_from = 1, .moving_to = 1.4, .fixed_above = 1.8};

}  // namespace

TEST_CASE("shares: none, growing, all, shrinking, none") {
  REQUIRE(zones.fraction(-5) == 0);
  REQUIRE(zones.fraction(0.2) == 0);
  REQUIRE(std::abs(zones.fraction(0.4) - 0.25) < 1e-15);
  REQUIRE(zones.fraction(1) == 1);
  REQUIRE(zones.fraction(1.2) == 1);
  REQUIRE(zones.fraction(1.4) == 1);
  REQUIRE(std::abs(zones.fraction(1.7) - 0.25) < 1e-15);
  REQUIRE(zones.fraction(1.8) == 0);
  REQUIRE(zones.fraction(9) == 0);
  // Without an upper zone everything above moves.
  const MovingMesh<> open{.fixed_below = 0.2, .moving_from = 1};
  REQUIRE(open.fraction(1e9) == 1);
}

TEST_CASE("nodes move by their share of the travel, from where they were at the start") {
  auto mesh = tall_mesh();
  const auto before = mesh.positions();
  BoundMotion<SimplexMesh<2>, LedByRigid<0>> motion(zones, mesh);
  for (const double travel : {-0.1, -0.35, 0.0, 0.2}) {
    motion.move(mesh, travel);
    REQUIRE(motion.travel() == travel);
    double off = 0, area = 0;
    for (Index i = 0; i < mesh.node_count(); ++i)
      off = std::max(
          off,
          (mesh.position(i) - before[i] - Vec<double, 2>(0, travel * zones.fraction(before[i][1]))).norm());
    for (Index c = 0; c < mesh.cell_count(); ++c) area += mesh.volume(c);
    REQUIRE(off < 1e-15);
    REQUIRE(std::abs(area - 0.4) < 1e-14);  // hull stays, cells are refreshed
  }
}

TEST_CASE("a zone that is used up stops the run") {
  auto mesh = tall_mesh();
  BoundMotion<SimplexMesh<2>, LedByRigid<0>> motion(zones, mesh);
  REQUIRE_NOTHROW(motion.move(mesh, -0.75));
  REQUIRE(throws<run_error>([&] { motion.move(mesh, -0.77); },
                            "the compressing zone below 1 m is used up after a travel of -0.77 m: 3.75 % of "
                            "its height is left, the limit is 5 %"));
  REQUIRE(throws<run_error>([&] { motion.move(mesh, 0.39); },
                            "the zone above 1.4 m is used up after a travel of 0.39 m"));
  REQUIRE(
      throws<run_error>([&] { motion.move(mesh, std::numeric_limits<double>::quiet_NaN()); }, "is used up"));
}

TEST_CASE("a cell that turns inside out is named") {
  // Two nodes on one diagonal edge straddle the kink at 0.3: below a hinge that tight a long cell flips.
  const MeshData<2> data{{{0, 0}, {1, 0.5}, {2, 0.9}, {0, 2}}, {{{0, 1, 2}}, {{0, 2, 3}}}, {}, {}, {}};
  SimplexMesh<2> mesh(data);
  BoundMotion<SimplexMesh<2>, LedByRigid<0>> motion({.fixed_below = 0.4, .moving_from = 0.9}, mesh);
  REQUIRE(throws<run_error>([&] { motion.move(mesh, 0.5); },
                            "cell 0 at (0, 0) m turned inside out after a travel of 0.5 m"));
}

TEST_CASE("bad zones are refused") {
  const auto mesh = tall_mesh();
  const auto refuses = [&](MovingMesh<> m, const std::string& text) {
    return throws([&] { BoundMotion<SimplexMesh<2>, LedByRigid<0>> motion(m, mesh); }, text);
  };
  const double inf = std::numeric_limits<double>::infinity();
  REQUIRE(refuses({}, "MovingMesh.fixed_below = nan: must be given"));
  REQUIRE(refuses({.fixed_below = 0}, "MovingMesh.moving_from = nan: must be given, above fixed_below"));
  REQUIRE(refuses({.fixed_below = 0, .moving_from = 0},
                  "MovingMesh.moving_from = 0: must be given, above fixed_below"));
  REQUIRE(refuses({.fixed_below = 0, .moving_from = inf},
                  "MovingMesh.moving_from = inf: must be given, above fixed_below"));
  REQUIRE(refuses({.fixed_below = 0, .moving_from = 1, .moving_to = 0.5},
                  "MovingMesh.moving_to = 0.5: must not lie below moving_from"));
  REQUIRE(refuses({.fixed_below = 0, .moving_from = 1, .moving_to = 2, .fixed_above = 1.5},
                  "MovingMesh.fixed_above = 1.5: must lie above moving_to"));
  REQUIRE(refuses({.fixed_below = 0, .moving_from = 1, .moving_to = 2, .fixed_above = 2},
                  "MovingMesh.fixed_above = 2: must lie above moving_to"));
  REQUIRE(refuses({.fixed_below = 0, .moving_from = 1, .moving_to = 2},
                  "MovingMesh.fixed_above = inf: must be given with moving_to"));
  REQUIRE(refuses({.fixed_below = 0, .moving_from = 1, .axis = 2},
                  "MovingMesh.axis = 2: must be an axis of the mesh"));
  REQUIRE(
      refuses({.fixed_below = 0, .moving_from = 1, .least = 0}, "MovingMesh.least = 0: must lie in (0, 1)"));
}

TEST_CASE("the mesh moves along the axis that is given") {
  SampleMesh<3> o{};
  o.cells = {4, 2, 2};
  SimplexMesh<3, float> mesh(sample_data(o));
  const auto before = mesh.positions();
  BoundMotion<SimplexMesh<3, float>, LedByBody<1>> motion({.fixed_below = 0, .moving_from = 0.5, .axis = 0},
                                                          mesh);
  motion.move(mesh, 0.25f);
  float off = 0;
  for (Index i = 0; i < mesh.node_count(); ++i) {
    const Vec<float, 3> d = mesh.position(i) - before[i];
    off = std::max(
        {off, std::abs(d[1]), std::abs(d[2]), std::abs(d[0] - 0.25f * std::min(1.f, 2 * before[i][0]))});
  }
  REQUIRE(off < 1e-6f);
}
