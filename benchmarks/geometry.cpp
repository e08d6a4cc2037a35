// Distances to closed surfaces of triangles, against a walk over all triangles; nodes near a box, against a
// walk over all nodes.
#include <benchmark/benchmark.h>
#include <arenite/core/units.hpp>
#include <arenite/geometry/triangle_surface.hpp>
#include <arenite/mesh/box_mesh.hpp>
#include <arenite/shape/nodes_near.hpp>
#include <random>

namespace {

using namespace arenite;
using P = Vec<double, 3>;

/// A ball of n x 2 n rectangles, each two triangles, about y, without the two caps of triangles at its poles.
TriangleData ball(Index n) {
  TriangleData data;
  const Index around = 2 * n;
  for (Index i = 1; i < n; ++i)
    for (Index j = 0; j < around; ++j) {
      const double a = pi * i / n, b = 2 * pi * j / around;
      data.vertices.emplace_back(std::sin(a) * std::cos(b), std::cos(a), std::sin(a) * std::sin(b));
    }
  const auto top = static_cast<Index>(data.vertices.size()), bottom = top + 1;
  data.vertices.emplace_back(0, 1, 0);
  data.vertices.emplace_back(0, -1, 0);
  for (Index j = 0; j < around; ++j) {
    const Index k = (j + 1) % around, last = (n - 2) * around;
    data.triangles.push_back({top, k, j});
    data.triangles.push_back({bottom, last + j, last + k});
    for (Index i = 0; i + 2 < n; ++i) {
      const Index up = i * around, down = up + around;
      data.triangles.push_back({up + j, up + k, down + k});
      data.triangles.push_back({up + j, down + k, down + j});
    }
  }
  return data;
}

/// Positions in a shell about the surface of the ball, of `per_cent` per cent of its radius.
std::vector<P> places(double per_cent) {
  std::mt19937 random(1);
  std::normal_distribution<double> normal;
  std::uniform_real_distribution<double> uniform(-1, 1);
  std::vector<P> x(4096);
  for (P& p : x) {
    p = P(normal(random), normal(random), normal(random)).normalized();
    p *= 1 + per_cent / 100 * uniform(random);
  }
  return x;
}

void distance(benchmark::State& state) {
  const TriangleSurface surface(ball(static_cast<Index>(state.range(0))));
  const auto x = places(static_cast<double>(state.range(1)));
  std::size_t k = 0;
  for (auto _ : state) benchmark::DoNotOptimize(surface(x[k++ % x.size()]));
  state.counters["triangles"] = static_cast<double>(surface.data().triangles.size());
}
BENCHMARK(distance)->ArgsProduct({{8, 32, 128}, {2, 90}})->ArgNames({"n", "shell"});

void contains(benchmark::State& state) {
  const TriangleSurface surface(ball(static_cast<Index>(state.range(0))));
  const auto x = places(static_cast<double>(state.range(1)));
  std::size_t k = 0;
  for (auto _ : state) benchmark::DoNotOptimize(surface.contains(x[k++ % x.size()]));
  state.counters["triangles"] = static_cast<double>(surface.data().triangles.size());
}
BENCHMARK(contains)->ArgsProduct({{8, 32, 128}, {2, 90}})->ArgNames({"n", "shell"});

void distance_to_all(benchmark::State& state) {
  const TriangleData data = ball(static_cast<Index>(state.range(0)));
  const auto x = places(2);
  std::size_t k = 0;
  for (auto _ : state) {
    const P& at = x[k++ % x.size()];
    double nearest = 1e300;
    for (const auto& t : data.triangles) {
      const P& a = data.vertices[t[0]];
      const P ab = data.vertices[t[1]] - a, ac = data.vertices[t[2]] - a;
      nearest = std::min(nearest, (nearest_on_triangle(a, ab, ac, at).at - at).squaredNorm());
    }
    benchmark::DoNotOptimize(nearest);
  }
  state.counters["triangles"] = static_cast<double>(data.triangles.size());
}
BENCHMARK(distance_to_all)->Arg(8)->Arg(32)->Arg(128)->ArgName("n");

void make_surface(benchmark::State& state) {
  const TriangleData data = ball(static_cast<Index>(state.range(0)));
  for (auto _ : state) benchmark::DoNotOptimize(TriangleSurface(data).bounds());
  state.counters["triangles"] = static_cast<double>(data.triangles.size());
}
BENCHMARK(make_surface)->Arg(128)->ArgName("n")->Unit(benchmark::kMillisecond);

/// A unit cube of simplices with a box of a tenth of its edge in it, which moves by a thousandth of a cell.
struct Search {
  SimplexMesh<3> mesh;
  CartesianGrid<3> grid;
  double at = 0.4;
  explicit Search(std::int64_t n)
      : mesh{box_mesh(
            BoxMesh<3>{.lower = {0, 0, 0},
                       .upper = {1, 1, 1},
                       .bricks = {static_cast<Index>(n), static_cast<Index>(n), static_cast<Index>(n)}})},
        grid({.lower = {0, 0, 0}, .upper = {1, 1, 1}, .cell = 1 / static_cast<double>(n)}) {}
  void move() { at = at < 0.8 ? at + 1e-3 / grid.cells(0) : 0.1; }
};

template <class Shape, class M>
void near(benchmark::State& state, const M& mesh, Search& search) {
  NodesNear<double, 3> near;
  std::size_t found = 0;
  for (auto _ : state) {
    search.move();
    near.find<Shape>(mesh, Box<3>{{0.4, search.at, 0.4}, {0.5, search.at + 0.1, 0.5}}, 0.5);
    found = 0;
    for (std::size_t k = 0; k < near.size(); ++k) {
      const P x = Shape::node_position(mesh, near[k]);
      const double far = 0.5 * mesh.node_size(near[k]);
      if ((x - P(0.45, search.at + 0.05, 0.45)).cwiseAbs().maxCoeff() <= 0.05 + far) ++found;
    }
    benchmark::DoNotOptimize(found);
  }
  state.counters["nodes"] = static_cast<double>(Shape::node_count(mesh));
  state.counters["found"] = static_cast<double>(found);
}
template <class Shape, class M>
void all(benchmark::State& state, const M& mesh, Search& search) {
  std::size_t found = 0;
  for (auto _ : state) {
    search.move();
    found = 0;
    for (Index i = 0; i < Shape::node_count(mesh); ++i) {
      const P x = Shape::node_position(mesh, i);
      const double far = 0.5 * mesh.node_size(i);
      if ((x - P(0.45, search.at + 0.05, 0.45)).cwiseAbs().maxCoeff() <= 0.05 + far) ++found;
    }
    benchmark::DoNotOptimize(found);
  }
  state.counters["nodes"] = static_cast<double>(Shape::node_count(mesh));
  state.counters["found"] = static_cast<double>(found);
}
void nodes_near_on_grid(benchmark::State& state) {
  Search search(state.range(0));
  near<QuadraticBSpline>(state, search.grid, search);
}
void all_nodes_on_grid(benchmark::State& state) {
  Search search(state.range(0));
  all<QuadraticBSpline>(state, search.grid, search);
}
void nodes_near_on_simplices(benchmark::State& state) {
  Search search(state.range(0));
  near<LinearSimplex>(state, search.mesh, search);
}
void all_nodes_on_simplices(benchmark::State& state) {
  Search search(state.range(0));
  all<LinearSimplex>(state, search.mesh, search);
}
BENCHMARK(nodes_near_on_grid)->Arg(20)->Arg(50)->ArgName("n")->Unit(benchmark::kMicrosecond);
BENCHMARK(all_nodes_on_grid)->Arg(20)->Arg(50)->ArgName("n")->Unit(benchmark::kMicrosecond);
BENCHMARK(nodes_near_on_simplices)->Arg(20)->Arg(50)->ArgName("n")->Unit(benchmark::kMicrosecond);
BENCHMARK(all_nodes_on_simplices)->Arg(20)->Arg(50)->ArgName("n")->Unit(benchmark::kMicrosecond);

}  // namespace

BENCHMARK_MAIN();
