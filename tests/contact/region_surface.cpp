// Surface of a region: nodes, normals on a disc, a cone and in a slice, shares.
#include "catch.hpp"

#include <arenite/boundary/walls.hpp>
#include <arenite/contact/region_surface.hpp>
#include <numeric>

#include "../mesh/sample_meshes.hpp"

using namespace arenite;
using namespace arenite::test;

namespace {

template <int D, class K>
void check_surface(const SimplexMesh<D>& mesh, const RegionSurface<double, D>& s, K) {
  REQUIRE(s.nodes.size() == s.normals.size());
  REQUIRE(s.nodes.size() == s.volume_fraction.size());
  REQUIRE(std::is_sorted(s.nodes.begin(), s.nodes.end()));
  REQUIRE(std::is_sorted(s.inside.begin(), s.inside.end()));
  double total = 0;
  for (const double share : s.volume_fraction) {
    REQUIRE(share > 0);
    total += share;
  }
  REQUIRE(total <= 1 + 1e-14);
  for (const auto& n : s.normals) REQUIRE(std::abs(n.norm() - 1) < 1e-14);
  for (const Index i : s.inside) REQUIRE(!std::binary_search(s.nodes.begin(), s.nodes.end(), i));
  static_cast<void>(mesh);
}

double total_of(const std::vector<double>& areas) { return std::accumulate(areas.begin(), areas.end(), 0.0); }

/// A disc of radius 1/2 in a square of 2 m: rings of nodes about the centre, squares mapped to circles.
SimplexMesh<2> disc_mesh() {
  SampleMesh<2> o{};
  o.cells = {24, 24};
  o.lower = {-1, -1};
  o.jitter = 0;
  o.region = [](const auto& x) { return x.template lpNorm<Eigen::Infinity>() < 0.5 ? 1 : 0; };
  auto data = sample_data(o);
  data.region_names = {{"disc", 1}, {"around", 0}};
  for (auto& x : data.nodes) {
    const double r = x.template lpNorm<Eigen::Infinity>();
    if (r > 0) x *= r / x.norm();
  }
  return SimplexMesh<2>(data);
}

/// A cone of half angle atan(1/2), apex down at (0, 0.5), in r, y >= 0.
SimplexMesh<2> cone_mesh() {
  SampleMesh<2> o{};
  o.cells = {8, 8};
  o.jitter = 0;
  o.region = [](const auto& x) { return x[1] > 0.5 && x[0] < 0.5 ? 1 : 0; };
  auto data = sample_data(o);
  data.region_names = {{"cone", 1}, {"soil", 0}};
  // Shear: y = 0.5 becomes y = 0.5 + 2 x inside x < 0.5, so that the lower face is a cone's flank.
  for (auto& x : data.nodes) x[1] += 2 * x[0];
  return SimplexMesh<2>(data);
}

template <int D>
Vec<double, D> normal_at(const SimplexMesh<D>& mesh, const RegionSurface<double, D>& s,
                         const Vec<double, D>& x) {
  for (std::size_t k = 0; k < s.nodes.size(); ++k)
    if ((mesh.position(s.nodes[k]) - x).norm() < 1e-12) return s.normals[k];
  return Vec<double, D>::Zero();
}

}  // namespace

TEST_CASE("a disc: normals are radial") {
  const auto mesh = disc_mesh();
  const auto s = surface_of<PlaneStrain>(mesh, "disc", {});
  check_surface(mesh, s, PlaneStrain{});
  REQUIRE(s.nodes.size() == 48);
  for (std::size_t k = 0; k < s.nodes.size(); ++k) {
    const auto& x = mesh.position(s.nodes[k]);
    REQUIRE(std::abs(x.norm() - 0.5) < 1e-12);
    REQUIRE((s.normals[k] - x.normalized()).norm() < 0.02);
  }
  REQUIRE(std::abs(total_of(s.areas) - pi) < 0.01);
  // Seen from the other side they point the other way, and the hull is no surface.
  const auto around = surface_of<PlaneStrain>(mesh, "around", {});
  REQUIRE(around.nodes == s.nodes);
  for (std::size_t k = 0; k < s.nodes.size(); ++k) REQUIRE((around.normals[k] + s.normals[k]).norm() < 1e-14);
  for (const Index i : s.inside) REQUIRE(mesh.position(i).norm() < 0.5 - 1e-6);
}

TEST_CASE("a cone: flank, tip on the axis, shoulder") {
  const auto mesh = cone_mesh();
  const auto constraints = resolve<LinearSimplex>(mesh, Axisymmetric{});
  const auto s = surface_of<Axisymmetric>(mesh, "cone", constraints);
  check_surface(mesh, s, Axisymmetric{});
  const Vec<double, 2> flank = Vec<double, 2>(2, -1).normalized();
  REQUIRE((normal_at<2>(mesh, s, {0.25, 1.0}) - flank).norm() < 1e-14);
  REQUIRE((normal_at<2>(mesh, s, {0, 0.5}) - Vec<double, 2>(0, -1)).norm() < 1e-14);
  REQUIRE((normal_at<2>(mesh, s, {0.5, 1.75}) - Vec<double, 2>(1, 0)).norm() < 1e-14);
  // Of flank (height 1, radius 1/2) and shaft (from 1.5 to 2 at the top of the mesh).
  REQUIRE(std::abs(total_of(s.areas) - pi * 0.5 * (std::sqrt(1.25) + 2 * 0.5)) < 1e-12);
  // The shoulder between flank and shaft takes a mean of both.
  const auto shoulder = normal_at<2>(mesh, s, {0.5, 1.5});
  REQUIRE(shoulder.dot(flank) > 0.9);
  REQUIRE(shoulder.dot(Vec<double, 2>(1, 0)) > 0.9);
  // Nodes of the cone on the axis above the tip are inside.
  bool above_tip = false;
  for (const Index i : s.inside)
    above_tip = above_tip || (mesh.position(i) - Vec<double, 2>(0, 1)).norm() < 1e-12;
  REQUIRE(above_tip);
}

TEST_CASE("three dimensions: a cube in a cube, and symmetry planes keep normals in them") {
  SampleMesh<3> o{};
  o.cells = {4, 4, 4};
  o.jitter = 0;
  o.region = [](const auto& x) { return x[0] < 0.5 && x[1] > 0.5 && x[2] < 0.5 ? 1 : 0; };
  auto data = sample_data(o);
  data.region_names = {{"block", 1}};
  const SimplexMesh<3> mesh(data);
  // The planes x = 0 and z = 0 are planes of symmetry.
  const auto constraints = resolve<LinearSimplex>(mesh, walls(left(roller), front(roller)));
  const auto s = surface_of<ThreeDimensional>(mesh, "block", constraints);
  check_surface(mesh, s, ThreeDimensional{});
  REQUIRE(s.nodes.size() == 27 - 8);
  REQUIRE((normal_at<3>(mesh, s, {0.25, 0.5, 0.25}) - Vec<double, 3>(0, -1, 0)).norm() < 1e-14);
  REQUIRE((normal_at<3>(mesh, s, {0, 0.5, 0}) - Vec<double, 3>(0, -1, 0)).norm() < 1e-14);
  REQUIRE((normal_at<3>(mesh, s, {0.5, 0.75, 0.25}) - Vec<double, 3>(1, 0, 0)).norm() < 1e-14);
  const auto edge = normal_at<3>(mesh, s, {0.5, 0.5, 0});
  REQUIRE(std::abs(edge[2]) < 1e-15);
  REQUIRE((edge[0] > 0.3 && edge[1] < -0.3));
}

TEST_CASE("a region that touches no other has no surface") {
  auto data = sample_data(SampleMesh<2>{.cells = {2, 2}});
  data.region_names = {{"all", 0}, {"nothing", 9}};
  const SimplexMesh<2> mesh(data);
  REQUIRE(throws([&] { surface_of<PlaneStrain>(mesh, "all", {}); },
                 "surface of region = all: must meet another region of the mesh"));
  REQUIRE(throws([&] { surface_of<PlaneStrain>(mesh, "nothing", {}); },
                 "surface of region = nothing: must have cells of the mesh"));
  REQUIRE(throws([&] { surface_of<PlaneStrain>(mesh, "tip", {}); },
                 "region = tip: must be one of: all, nothing"));
}

TEST_CASE(
    "a surface whose nodes are all constrained by walls is distinguished from one that touches no other") {
  // Along a line at 30 degrees, where a wall leaves a rounding error of the normals.
  const double a = pi / 6;
  SampleMesh<2> o{.cells = {2, 2}, .jitter = 0};
  o.region = [](const auto& x) { return x[1] < 0.5 ? 1 : 0; };
  auto data = sample_data(o);
  data.region_names = {{"below", 1}};
  for (std::size_t i = 0; i < data.nodes.size(); ++i) {
    auto& x = data.nodes[i];
    if (x[1] == 0.5) data.node_sets["between"].push_back(static_cast<Index>(i));
    x = {std::cos(a) * x[0] - std::sin(a) * x[1], std::sin(a) * x[0] + std::cos(a) * x[1]};
  }
  const SimplexMesh<2> mesh(data);
  const auto surface = [&](const Condition& c) {
    return surface_of<PlaneStrain>(mesh, "below", resolve<LinearSimplex>(mesh, walls(on("between", c))));
  };
  const std::array<double, 3> normal{-std::sin(a), std::cos(a), 0}, along{std::cos(a), std::sin(a), 0};
  for (const Condition& c : {fixed, symmetry(normal)})
    REQUIRE(throws([&] { surface(c); },
                   "surface of region = below: walls hold all of its nodes along their normals"));
  const auto s = surface(symmetry(along));
  REQUIRE(s.nodes == data.node_sets["between"]);
  for (const auto& n : s.normals) REQUIRE((n - Vec<double, 2>(normal[0], normal[1])).norm() < 1e-14);
}
