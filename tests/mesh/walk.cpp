// The point search: walks and searches against brute force, on convex and other meshes.
#include "catch.hpp"
#include "sample_meshes.hpp"

using namespace arenite;
using namespace arenite::test;

namespace {

/// The cell in which x lies deepest, and how deep: the least barycentric coordinate, largest of all cells.
template <int D, class T>
std::pair<Index, T> by_brute_force(const SimplexMesh<D, T>& mesh, const Vec<T, D>& x) {
  Index best = none;
  T depth = -std::numeric_limits<T>::infinity();
  for (Index c = 0; c < mesh.cell_count(); ++c) {
    const T b = mesh.barycentric(c, x).minCoeff();
    if (b > depth) {
      depth = b;
      best = c;
    }
  }
  return {best, depth};
}

/// Counts answers of `find` that are not a cell containing the point (to round-off).
template <int D, class T, class Find>
int wrong_answers(const SimplexMesh<D, T>& mesh, int points, double margin, Find&& find) {
  std::mt19937 random(3);
  std::uniform_real_distribution<T> uniform(static_cast<T>(-margin), static_cast<T>(1 + margin));
  int wrong = 0;
  const T close = 100 * std::numeric_limits<T>::epsilon();
  for (int i = 0; i < points; ++i) {
    Vec<T, D> x;
    for (int k = 0; k < D; ++k) x[k] = uniform(random);
    const auto [best, depth] = by_brute_force(mesh, x);
    const Index found = find(x, static_cast<Index>(random()) % mesh.cell_count());
    if (found == none)
      wrong += depth > close;
    else
      wrong += mesh.barycentric(found, x).minCoeff() < -close;
  }
  return wrong;
}

template <int D>
SimplexMesh<D> holed(bool l_shape) {
  SampleMesh<D> o{};
  o.cells.fill(D == 2 ? 9 : 6);
  o.keep = [l_shape](const Vec<double, D>& x) {
    if (l_shape) return x[0] < 0.5 || x[1] < 0.5;
    return (x - Vec<double, D>::Constant(0.5)).template lpNorm<Eigen::Infinity>() > 0.25;
  };
  return SimplexMesh<D>(sample_data(o));
}

}  // namespace

TEST_CASE("on a convex mesh a walk finds every cell from every other") {
  // Hulls that are flat but jittered inside: convex.
  const auto flat = sample_mesh<2>(10);
  const auto solid = sample_mesh<3>(4);
  const auto single = sample_mesh<2, float>(10);
  REQUIRE(wrong_answers(flat, 4000, 0.1, [&](const auto& x, Index hint) { return flat.walk(x, hint); }) == 0);
  REQUIRE(wrong_answers(solid, 2000, 0.1, [&](const auto& x, Index hint) { return solid.walk(x, hint); }) ==
          0);
  REQUIRE(wrong_answers(single, 2000, 0.1, [&](const auto& x, Index hint) { return single.walk(x, hint); }) ==
          0);
}

TEST_CASE("the search is right everywhere, with holes and notches too") {
  for (const bool l_shape : {true, false}) {
    auto flat = holed<2>(l_shape);
    auto solid = holed<3>(l_shape);
    REQUIRE(wrong_answers(flat, 4000, 0.1, [&](const auto& x, Index) { return flat.search(x); }) == 0);
    REQUIRE(wrong_answers(solid, 1500, 0.1, [&](const auto& x, Index) { return solid.search(x); }) == 0);
    // A walk that finds something has found the right cell; it may give up at the hull.
    int gave_up = 0;
    REQUIRE(wrong_answers(flat, 2000, 0.1, [&](const auto& x, Index hint) {
              const Index found = flat.walk(x, hint);
              const Index there = flat.search(x);
              gave_up += found == none && there != none;
              return found == none ? there : found;
            }) == 0);
    REQUIRE(gave_up > 0);
  }
}

TEST_CASE("points on nodes, edges and faces belong to a cell that touches them") {
  auto mesh = sample_mesh<3>(3);
  int lost = 0;
  for (Index c = 0; c < mesh.cell_count(); ++c) {
    const auto& nodes = mesh.nodes(c);
    const Vec<double, 3> at_node = mesh.position(nodes[0]);
    const Vec<double, 3> on_edge = (mesh.position(nodes[0]) + mesh.position(nodes[1])) / 2;
    const Vec<double, 3> on_face =
        (mesh.position(nodes[0]) + mesh.position(nodes[1]) + mesh.position(nodes[2])) / 3;
    for (const auto& x : {at_node, on_edge, on_face}) {
      for (const Index found : {mesh.search(x), mesh.walk(x, (c * 37) % mesh.cell_count())})
        lost += found == none || mesh.barycentric(found, x).minCoeff() < -1e-13;
      lost += mesh.walk(x, c) != c;  // a point on a face stays where it was
    }
  }
  REQUIRE(lost == 0);
}

TEST_CASE("no position, no cell") {
  auto mesh = sample_mesh<2>(4);
  const double nan = std::numeric_limits<double>::quiet_NaN(), inf = std::numeric_limits<double>::infinity();
  for (const Vec<double, 2>& x :
       {Vec<double, 2>(nan, 0.5), Vec<double, 2>(0.5, nan), Vec<double, 2>(inf, 0.5),
        Vec<double, 2>(0.5, -inf), Vec<double, 2>(inf, inf), Vec<double, 2>(1e300, 0.5),
        Vec<double, 2>(-1e-9, 0.5), Vec<double, 2>(0.5, 1 + 1e-9)}) {
    for (Index c = 0; c < mesh.cell_count(); ++c) REQUIRE(mesh.walk(x, c) == none);
    REQUIRE(mesh.search(x) == none);
  }
  REQUIRE(mesh.walk({0.5, 0.5}, none) == none);
}

TEST_CASE("a slit far longer than wide is searched too") {
  SampleMesh<2> o{};
  o.cells = {300, 1};
  o.upper = {300, 0.01};
  SimplexMesh<2> mesh(sample_data(o));
  std::mt19937 random(5);
  std::uniform_real_distribution<double> uniform(0, 1);
  int wrong = 0;
  for (int i = 0; i < 500; ++i) {
    const Vec<double, 2> x(300 * uniform(random), 0.01 * uniform(random));
    const Index found = mesh.search(x);
    wrong += found == none || mesh.barycentric(found, x).minCoeff() < -1e-12;
  }
  REQUIRE(wrong == 0);
  // A walk gives up after 64 cells; the search still answers.
  const Index start = mesh.search({0.5, 0.005});
  REQUIRE(mesh.walk({299.5, 0.005}, start) == none);
  REQUIRE(mesh.search({299.5, 0.005}) != none);
}
