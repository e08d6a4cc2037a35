// Walls: which nodes they catch, what they block, what they refuse.
#include "catch.hpp"

#include <arenite/boundary/gravity.hpp>
#include <arenite/boundary/walls.hpp>
#include <arenite/mesh/kinematics.hpp>

#include "../mesh/sample_meshes.hpp"

using namespace arenite;
using namespace arenite::test;

namespace {

const CartesianGrid<2> grid({.lower = {0, 0}, .upper = {4, 3}, .cell = 1});

template <int D>
const Constraint<double, D>* constraint_at(const std::vector<Constraint<double, D>>& all, Index node) {
  for (const auto& c : all)
    if (c.node == node) return &c;
  return nullptr;
}

std::vector<Constraint<double, 2>> on_grid(const Walls& w) { return resolve<QuadraticBSpline>(grid, w); }

template <int D>
Mat<double, D> diagonal(const Vec<double, D>& d) {
  return Mat<double, D>(d.asDiagonal());
}

SimplexMesh<2> named_mesh() {
  SampleMesh<2> o{};
  o.cells = {3, 3};
  auto data = sample_data(o);
  for (Index i = 0; i < data.nodes.size(); ++i)
    if (data.nodes[i][1] == 0) data.node_sets["base"].push_back(i);
  return SimplexMesh<2>(data);
}

struct Plane {  // what `bind_part` asks of a site
  using T = float;
  static constexpr int D = 2;
};

}  // namespace

TEST_CASE("faces catch their nodes, and corners what both faces block") {
  const auto all = on_grid(walls(bottom(roller), left(roller), top(fixed)));
  REQUIRE(all.size() == 6 + 6 + 3);
  REQUIRE(
      std::is_sorted(all.begin(), all.end(), [](const auto& a, const auto& b) { return a.node < b.node; }));
  for (const auto& c : all) {
    const auto x = QuadraticBSpline::node_position(grid, c.node);
    const Vec<double, 2> free(x[0] > 0 && x[1]<3, x[1]> 0 && x[1] < 3);
    REQUIRE((c.projector - diagonal<2>(free)).norm() < 1e-15);
  }
  REQUIRE(on_grid(walls(right(fixed))).size() == 5);
  REQUIRE(on_grid(walls()).empty());
}

TEST_CASE("faces in three dimensions") {
  const CartesianGrid<3, float> box({.lower = {0, 0, 0}, .upper = {0.3, 0.2, 0.1}, .cell = 0.1});
  const auto front_back = resolve<QuadraticBSpline>(box, walls(front(roller), back(roller)));
  REQUIRE(front_back.size() == 2 * 5 * 4);
  for (const auto& c : front_back) REQUIRE(c.projector == Mat<float, 3>(Vec<float, 3>(1, 1, 0).asDiagonal()));
}

TEST_CASE("an inclined symmetry plane blocks only its normal") {
  const auto all = on_grid(walls(Wall{0, false, {}, {}, symmetry({3, 4, 0})}));
  REQUIRE(all.size() == 5);
  const Vec<double, 2> normal(0.6, 0.8), along(0.8, -0.6);
  for (const auto& c : all) {
    REQUIRE((c.projector * normal).norm() < 1e-15);
    REQUIRE((c.projector * along - along).norm() < 1e-15);
    REQUIRE((c.projector - c.projector.transpose()).norm() < 1e-16);
  }
}

TEST_CASE("two planes of a slice leave its edge one direction, three leave none") {
  // The faces of a 20-degree slice: z = 0 and the plane turned by 20 degrees about y.
  const double a = 20 * pi / 180;
  const auto everywhere = [](const std::array<double, 3>&) { return true; };
  const auto mesh = sample_mesh<3>(1);
  const auto two =
      resolve<LinearSimplex>(mesh, walls(where(everywhere, symmetry({0, 0, 1})),
                                         where(everywhere, symmetry({std::sin(a), 0, -std::cos(a)}))));
  REQUIRE(two.size() == mesh.node_count());
  for (const auto& c : two) REQUIRE((c.projector - diagonal<3>({0, 1, 0})).norm() < 1e-14);
  const auto same = resolve<LinearSimplex>(
      mesh, walls(where(everywhere, symmetry({0, 0, 1})), where(everywhere, symmetry({0, 0, -2}))));
  for (const auto& c : same) REQUIRE((c.projector - diagonal<3>({1, 1, 0})).norm() < 1e-15);
  const auto three = resolve<LinearSimplex>(
      mesh, walls(where(everywhere, symmetry({0, 0, 1})), where(everywhere, symmetry({0, 1, 1})),
                  where(everywhere, symmetry({1, 1, 1}))));
  for (const auto& c : three) REQUIRE(c.projector == diagonal<3>({0, 0, 0}));
}

TEST_CASE("free_along leaves one axis") {
  for (const auto& c : on_grid(walls(left(free_along(1)))))
    REQUIRE((c.projector - diagonal<2>({0, 1})).norm() < 1e-15);
}

TEST_CASE("node sets and tests") {
  const auto mesh = named_mesh();
  const auto base = resolve<LinearSimplex>(mesh, walls(on("base", fixed)));
  REQUIRE(base.size() == 4);
  const auto tested =
      resolve<LinearSimplex>(mesh, walls(where([](const auto& x) { return x[1] == 0 && x[2] == 0; }, fixed)));
  REQUIRE(tested.size() == 4);
  for (std::size_t k = 0; k < 4; ++k) REQUIRE(base[k].node == tested[k].node);
  REQUIRE(resolve<LinearSimplex>(mesh, walls(bottom(fixed))).size() == 4);
}

TEST_CASE("on the axis of symmetry nothing moves radially") {
  const auto all = resolve<QuadraticBSpline>(grid, walls(bottom(fixed)), Axisymmetric{});
  REQUIRE(all.size() == 6 + 4);
  REQUIRE((constraint_at(all, 0)->projector).norm() == 0);
  REQUIRE((constraint_at(all, 6)->projector - diagonal<2>({0, 1})).norm() < 1e-15);
  const CartesianGrid<2> beyond({.lower = {-1, 0}, .upper = {1, 1}, .cell = 1});
  REQUIRE(throws([&] { resolve<QuadraticBSpline>(beyond, Axisymmetric{}); },
                 "Axisymmetric: r = -1: nodes must have r >= 0"));
  const CartesianGrid<2> off_axis({.lower = {1, 0}, .upper = {2, 1}, .cell = 1});
  REQUIRE(resolve<QuadraticBSpline>(off_axis, Axisymmetric{}).empty());
}

TEST_CASE("walls that mean nothing are refused") {
  const auto refuses = [](Wall w, const std::string& text) {
    return throws([&] { on_grid(walls(w)); }, text);
  };
  const auto anywhere = [](const std::array<double, 3>&) { return true; };
  REQUIRE(refuses(front(fixed), "Wall.axis = 2: must be an axis of the scene"));
  REQUIRE(refuses(where(anywhere, roller), "Wall.condition = roller: needs a face"));
  for (const int kind : {-1, 4, 9})
    REQUIRE(refuses(left({static_cast<Condition::Kind>(kind)}),
                    "Condition.kind = " + std::to_string(kind) + ": must be 0 to 3"));
  REQUIRE(refuses(on("base", fixed), "Wall.set = base: a Cartesian grid has no node sets"));
  REQUIRE(refuses(on("", fixed), "Wall.set = : must name a node set"));
  REQUIRE(refuses(where([](const auto&) { return false; }, fixed),
                  "Wall.nodes = 0: the wall must catch at least one node"));
  REQUIRE(refuses(left(symmetry({0, 0, 0})),
                  "symmetry.normal = (0, 0): must have a length in the scene's dimensions"));
  REQUIRE(refuses(left(symmetry({0, 0, 1})),
                  "symmetry.normal = (0, 0): must have a length in the scene's dimensions"));
  REQUIRE(refuses(left(symmetry({std::nan(""), 0, 0})), "symmetry.normal = (nan, 0): must have a length"));
  REQUIRE(refuses(left(symmetry({1, 0, 1})),
                  "symmetry.normal = 1: must be zero along an axis that the scene does not have"));
  REQUIRE(
      refuses(left(free_along(2)), "free_along.axis = (0, 0): must have a length in the scene's dimensions"));
  REQUIRE(
      refuses(left(free_along(7)), "free_along.axis = (0, 0): must have a length in the scene's dimensions"));
  const auto mesh = named_mesh();
  REQUIRE(throws([&] { resolve<LinearSimplex>(mesh, walls(on("crown", fixed))); },
                 "node set = crown: must be one of: base"));
}

namespace {
struct Space : Plane {
  static constexpr int D = 3;
};
}  // namespace

TEST_CASE("gravity has the components of the scene") {
  REQUIRE(bind_part(gravity({0, -9.5}), Plane{}).acceleration(0) == Vec<float, 2>(0, -9.5f));
  REQUIRE(throws([] { bind_part(gravity({0, std::nan("")}), Plane{}); }, "gravity = nan: must be finite"));
  REQUIRE(throws(
      [] {
        bind_part(gravity(Triple{0, -9.81, 1}), Plane{});
      },
      "gravity = 1: must be zero along an axis that the scene does not have"));
  REQUIRE(throws(
      [] {
        bind_part(gravity({0, -9.81, 0}), Plane{});
      },
      "gravity: components = 3: must be 2, as many as the scene has dimensions"));
  REQUIRE(throws(
      [] {
        bind_part(gravity({0, -9.81}), Space{});
      },
      "gravity: components = 2: must be 3, as many as the scene has dimensions"));
  REQUIRE(throws(
      [] {
        bind_part(gravity({0, -9.81}, Ramp{.over = 1}), Space{});
      },
      "gravity: components = 2: must be 3, as many as the scene has dimensions"));
  REQUIRE(bind_part(gravity(Triple{0, -9.81, 0}), Plane{}).acceleration(0)[1] == -9.81f);
}

TEST_CASE("constrained velocities lose what is blocked, and the wall gives the impulse") {
  const auto all = on_grid(walls(left(roller), bottom(fixed)));
  const std::size_t n = QuadraticBSpline::node_count(grid);
  std::vector<double> mass(n, 2.0);
  mass[0] = 0;
  std::vector<Vec<double, 2>> velocity(n, Vec<double, 2>(3, -5));
  const Vec<double, 2> impulse = constrain(all, mass, velocity);
  REQUIRE(velocity[1].norm() == 0);
  REQUIRE((velocity[6] - Vec<double, 2>(0, -5)).norm() < 1e-15);
  REQUIRE((velocity[7] - Vec<double, 2>(3, -5)).norm() == 0);
  REQUIRE(velocity[0].norm() == 0);  // constrained too; without a mass it gets no impulse
  // Five nodes of the bottom stop, four of the left side lose their x.
  REQUIRE((impulse - Vec<double, 2>(-2 * 3 * 9, 2 * 5 * 5)).norm() < 1e-13);
}

TEST_CASE("nodes that no cell uses are no part of a face") {
  auto data = sample_data(SampleMesh<2>{.cells = {2, 2}});
  data.nodes.push_back({-3, -3});  // as a mesher leaves the centre of an arc
  const SimplexMesh<2> mesh(data);
  REQUIRE(resolve<LinearSimplex>(mesh, walls(left(fixed)), Axisymmetric{}).size() == 3);
}
