// Blocks of cells: each cell once, colours that share no node, and the same order for any number of threads.
#include "catch.hpp"
#include "sample_meshes.hpp"

#include <arenite/mesh/blocks.hpp>
#include <arenite/shape/shape.hpp>
#include <atomic>
#include <functional>
#include <set>

using namespace arenite;
using namespace arenite::test;

namespace {

template <class Shape, class M>
Blocks blocks_of(const M& mesh, Index size) {
  return Blocks(mesh.cell_count(), Shape::node_count(mesh), size,
                [&](Index c) { return typename Shape::template Cell<M>(mesh, c).nodes; });
}

template <class Shape, class M>
void check_blocks(const M& mesh, Index size) {
  const Blocks blocks = blocks_of<Shape>(mesh, size);
  std::vector<int> seen(mesh.cell_count(), 0);
  std::size_t blocks_seen = 0;
  bool apart = true;
  for (std::size_t color = 0; color < blocks.colors(); ++color) {
    std::vector<Index> owner(Shape::node_count(mesh), none);
    for (const Index b : blocks.of_color(color)) {
      ++blocks_seen;
      for (Index c = blocks.begin(b); c < blocks.end(b); ++c) {
        ++seen[c];
        for (const Index node : typename Shape::template Cell<M>(mesh, c).nodes) {
          apart = apart && (owner[node] == none || owner[node] == b);
          owner[node] = b;
        }
      }
    }
  }
  REQUIRE(apart);
  REQUIRE(blocks_seen == blocks.count());
  REQUIRE(std::all_of(seen.begin(), seen.end(), [](int n) { return n == 1; }));

  std::vector<int> colored(mesh.cell_count(), 0), any(mesh.cell_count(), 0);
  blocks.for_each_colored([&](Index c) { ++colored[c]; });
  blocks.for_each([&](Index c) { ++any[c]; });
  REQUIRE(colored == seen);
  REQUIRE(any == seen);
}

}  // namespace

TEST_CASE("each cell once, no node twice in a colour") {
  for (const Index size : {1u, 7u, 64u, 100000u}) {
    check_blocks<LinearSimplex>(sample_mesh<2>(9), size);
    check_blocks<LinearSimplex>(sample_mesh<3>(4), size);
    check_blocks<QuadraticBSpline>(CartesianGrid<2>({.lower = {0, 0}, .upper = {8, 5}, .cell = 1}), size);
    check_blocks<QuadraticBSpline>(CartesianGrid<3>({.lower = {0, 0, 0}, .upper = {4, 3, 5}, .cell = 1}),
                                   size);
    check_blocks<QuadraticBSpline>(CartesianGrid<2>({.lower = {0, 0}, .upper = {1, 1}, .cell = 1}), size);
  }
}

TEST_CASE("two layers of a grid's cells need two colours") {
  const CartesianGrid<2> grid({.lower = {0, 0}, .upper = {8, 20}, .cell = 1});
  REQUIRE(blocks_of<QuadraticBSpline>(grid, 16).colors() == 2);
  REQUIRE(blocks_of<LinearGrid>(grid, 8 * LinearGrid::halo).colors() == 2);
  REQUIRE(blocks_of<CubicBSpline>(grid, 8 * CubicBSpline::halo).colors() == 2);
  REQUIRE(blocks_of<CubicBSpline>(grid, 16).colors() == 3);  // blocks lower than the halo
}

TEST_CASE("cells that share a node run in the same order for any number of threads") {
  const auto mesh = sample_mesh<2>(12);
  const Blocks blocks = blocks_of<LinearSimplex>(mesh, 4);
  const auto orders = [&](int count) {
    const int before = threads();
    set_threads(count);
    std::vector<std::vector<Index>> at(mesh.node_count());
    blocks.for_each_colored([&](Index c) {
      for (const Index i : mesh.nodes(c)) at[i].push_back(c);
    });
    set_threads(before);
    return at;
  };
  const auto one = orders(1);
  for (const int n : {2, 3, 8}) REQUIRE(orders(n) == one);
}

TEST_CASE("shares of uneven work leave no cell out and change no order") {
  const auto mesh = sample_mesh<2>(30);
  REQUIRE(mesh.cell_count() >= 1000);  // enough for threads
  const auto orders = [&](const Blocks& blocks, int count) {
    const int before = threads();
    set_threads(count);
    std::vector<std::vector<Index>> at(mesh.node_count());
    blocks.for_each_colored([&](Index c) {
      for (const Index i : mesh.nodes(c)) at[i].push_back(c);
    });
    std::vector<int> visits(mesh.cell_count());
    blocks.for_each([&](Index c) { ++visits[c]; });
    set_threads(before);
    REQUIRE(std::all_of(visits.begin(), visits.end(), [](int n) { return n == 1; }));
    return at;
  };
  Blocks blocks = blocks_of<LinearSimplex>(mesh, 24);
  const auto plain = orders(blocks, 1);
  const std::vector<std::function<std::size_t(Index)>> works{
      [](Index) { return std::size_t{0}; }, [](Index c) { return std::size_t{c < 100 ? 50u : 0u}; },
      [](Index c) { return std::size_t{c > 1500 ? 7u : 1u}; }};
  for (const auto& work : works) {
    blocks.balance_threads(work);
    for (const int n : {1, 2, 3, 7}) REQUIRE(orders(blocks, n) == plain);
  }
}

TEST_CASE("a reduction joins all cells, with the same bits for any number of threads") {
  const auto mesh = sample_mesh<2>(12);
  const Blocks blocks = blocks_of<LinearSimplex>(mesh, 4);
  const auto sum = [&](int count) {
    const int before = threads();
    set_threads(count);
    const double s = blocks.reduce(
        0.0, [&](Index c) { return mesh.volume(c); }, std::plus<>{});
    set_threads(before);
    return s;
  };
  REQUIRE(std::abs(sum(1) - 1) < 1e-14);
  for (const int n : {2, 3, 8}) REQUIRE(sum(n) == sum(1));
}
