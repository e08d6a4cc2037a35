// Relocation: each point in its cell, lost points counted with their mass, and nothing else changed.
#include "catch.hpp"

#include <arenite/law/linear_elastic.hpp>
#include <arenite/mesh/window_grid.hpp>
#include <arenite/particles/relocate.hpp>
#include <numeric>

#include "../mesh/sample_meshes.hpp"

using namespace arenite;
using namespace arenite::test;

namespace {

const LinearElastic law{{.density = 1000, .young = 1e6, .poisson = 0.3}};

/// A body whose velocities number its points, so that each can be followed.
template <class M>
auto numbered_body(const M& mesh) {
  std::array<double, M::dimension> lower, upper;
  lower.fill(-10);
  upper.fill(10);
  auto body = make_body<std::conditional_t<M::dimension == 2, PlaneStrain, ThreeDimensional>,
                        ExtraColumns{.affine = true}>(
      mesh, fill(Box<M::dimension>{lower, upper}, law, {.per_cell = 1}));
  for (std::size_t p = 0; p < body.points.size(); ++p) {
    body.points.velocity.column(0)[p] = static_cast<typename M::scalar>(p);
    body.points.velocity_gradient.set(
        p, Mat<typename M::scalar, M::dimension>::Constant(static_cast<typename M::scalar>(p)));
  }
  return body;
}

/// Blocks of seven cells; nodes do not matter here.
template <class M>
Blocks blocks_of(const M& mesh) {
  return Blocks(mesh.cell_count(), 1, 7, [](Index) { return std::array<Index, 1>{0}; });
}

template <class M>
void check_relocation(M mesh, double spread) {
  auto body = numbered_body(mesh);
  const auto blocks = blocks_of(mesh);
  std::mt19937 random(11);
  std::normal_distribution<double> normal(0, spread);
  std::size_t lost = 0;
  double lost_mass = 0;
  for (int round = 0; round < 20; ++round) {
    for (std::size_t k = 0; k < M::dimension; ++k)
      for (auto& x : body.points.position.column(k)) x += static_cast<typename M::scalar>(normal(random));
    std::vector<double> stayed;
    const auto before = body.points;
    std::map<std::size_t, std::size_t> place;
    for (std::size_t p = 0; p < before.size(); ++p) {
      const auto number = static_cast<std::size_t>(before.velocity[p][0]);
      if (mesh.search(before.position[p]) == none) {
        ++lost;
        lost_mass += static_cast<double>(before.mass[p]);
      } else {
        place[number] = p;
      }
    }
    relocate<4>(body, mesh, blocks);
    REQUIRE(body.lost == lost);
    REQUIRE(std::abs(body.lost_mass - lost_mass) <= 1e-12 * lost_mass);
    REQUIRE(body.points.size() == place.size());
    bool same = true, there = true;
    for (std::size_t p = 0; p < body.points.size(); ++p) {
      const auto number = static_cast<std::size_t>(body.points.velocity[p][0]);
      const std::size_t q = place.at(number);
      same = same && body.points.position[p] == before.position[q] && body.points.mass[p] == before.mass[q] &&
             body.points.volume[p] == before.volume[q] &&
             body.points.velocity_gradient[p] == before.velocity_gradient[q];
      const Index c = body.points.cell[p];
      there = there && mesh.walk(body.points.position[p], c) == c;
    }
    REQUIRE(same);
    REQUIRE(there);
    // The list of cells: every point once, in its cell.
    std::vector<int> seen(body.points.size(), 0);
    bool listed = true;
    for (Index c = 0; c < mesh.cell_count(); ++c) {
      const auto in_cell = body.cells[c];
      std::size_t count = 0;
      body.cells.template for_packs<4>(c, [&](Index, int n) { count += static_cast<std::size_t>(n); });
      listed = listed && in_cell.size() == count && in_cell.empty() == body.cells.empty(c);
      for (const Index p : in_cell) {
        listed = listed && body.points.cell[p] == c;
        ++seen[p];
      }
    }
    REQUIRE(listed);
    REQUIRE(std::all_of(seen.begin(), seen.end(), [](int n) { return n == 1; }));
  }
  REQUIRE(lost > 0);
  REQUIRE(body.points.size() > 0);
}

}  // namespace

TEST_CASE("relocation on triangles and tetrahedra, across several cells and out of the mesh") {
  check_relocation(sample_mesh<2>(12), 0.05);
  check_relocation(sample_mesh<3, float>(4), 0.05);
  SampleMesh<2> ring{};
  ring.cells = {9, 9};
  ring.keep = [](const auto& x) {
    return (x - Vec<double, 2>(0.5, 0.5)).template lpNorm<Eigen::Infinity>() > 0.2;
  };
  check_relocation(SimplexMesh<2>(sample_data(ring)), 0.05);
}

TEST_CASE("relocation on grids") {
  check_relocation(CartesianGrid<2>({.lower = {0, 0}, .upper = {1, 1}, .cell = 0.05}), 0.05);
  check_relocation(CartesianGrid<3, float>({.lower = {0, 0, 0}, .upper = {1, 1, 1}, .cell = 0.125}), 0.05);
  // Few move at once: unsorted points lie in the memory of other cells.
  const CartesianGrid<2> grid({.lower = {0, 0}, .upper = {1, 1}, .cell = 0.05});
  check_relocation(grid, 0.01);
  check_relocation(WindowGrid<CartesianGrid<2>>(grid, {3, 0}, {11, 9}), 0.01);
  check_relocation(CartesianGrid<3, float>({.lower = {0, 0, 0}, .upper = {1, 1, 1}, .cell = 0.125}), 0.02);
}

TEST_CASE("a grid of equal cells tests a pack of positions as it walks to each") {
  const CartesianGrid<2> whole({.lower = {-1, 2}, .upper = {1, 3}, .cell = 0.1});
  const auto check = [](const auto& mesh) {
    constexpr int width = 4;
    using P = Pack<double, width>;
    const double nan = std::nan(""), infinity = std::numeric_limits<double>::infinity();
    std::mt19937 random(3);
    std::uniform_int_distribution<int> place(-2, 22);
    std::uniform_real_distribution<double> within(0, 1);
    int inside = 0;
    for (int round = 0; round < 4000; ++round) {
      std::array<P, 2> x{P(0), P(0)};
      std::array<Index, width> cell{};
      bool all = true, on_face = false;
      for (int k = 0; k < width; ++k) {
        for (std::size_t a = 0; a < 2; ++a) {
          // Mostly in one cell; some anywhere, on faces, or no number.
          const double anywhere = -1 + 0.1 * (place(random) + (round % 3 == 0 ? 0 : within(random)));
          double at = a == 0 ? -0.35 + 0.1 * within(random) : 2.15 + 0.1 * within(random);
          if (round % 4 == 0 && k == round % 3) at = a == 0 ? anywhere : anywhere + 3;
          if (round % 50 == 0 && k == 2)
            at = round % 100 == 0 ? nan : round % 150 == 0 ? infinity : -infinity;
          x[a].set(k, at);
          on_face = on_face || at == mesh.upper(static_cast<int>(a));
        }
        const Index walked = mesh.walk({x[0][k], x[1][k]}, none);
        const Index asked = round % 7 == 0 && k == 3 ? mesh.cell_count() - 1 : walked == none ? 0 : walked;
        cell[static_cast<std::size_t>(k)] = asked;
        all = all && walked == asked;
      }
      const bool found = detail::all_in_cells(mesh, x, cell.data());
      REQUIRE((found == all || (all && on_face)));
      inside += found;
    }
    REQUIRE(inside > 1000);
    REQUIRE(inside < 3900);
  };
  check(whole);
  check(WindowGrid<CartesianGrid<2>>(whole, {5, 1}, {7, 9}));
}

TEST_CASE("points that stay are not touched") {
  auto mesh = sample_mesh<2>(4);
  auto body = numbered_body(mesh);
  const auto before = body.points.position;
  relocate<4>(body, mesh, blocks_of(mesh));
  REQUIRE(body.points.position == before);
  REQUIRE((body.lost == 0 && body.cells.unsorted() == 0));
}

TEST_CASE("a body may lose all its points, and one that is no number is lost") {
  auto mesh = sample_mesh<2>(4);
  auto body = numbered_body(mesh);
  for (auto& x : body.points.position.column(0)) x += 5;
  body.points.position.column(1)[0] = std::nan("");
  relocate<4>(body, mesh, blocks_of(mesh));
  REQUIRE(body.points.size() == 0);
  REQUIRE(body.lost == 32);
  REQUIRE(std::abs(body.lost_mass - 1000) < 1e-10);
  REQUIRE_NOTHROW(relocate<4>(body, mesh, blocks_of(mesh)));
}

TEST_CASE("few movers become unsorted; many are sorted into the columns") {
  auto mesh = sample_mesh<2>(8);
  const auto blocks = blocks_of(mesh);
  auto body = numbered_body(mesh);
  const std::size_t n = body.points.size();
  // A hop to the neighbour of every fortieth point, there and back.
  for (int hop = 0; hop < 6; ++hop) {
    for (std::size_t p = 0; p < n; p += 40) {
      const Index to = mesh.neighbour(body.points.cell[p], hop % 3);
      if (to == none) continue;
      Vec<double, 2> centre = Vec<double, 2>::Zero();
      for (const Index i : mesh.nodes(to)) centre += mesh.position(i) / 3;
      body.points.position.set(p, centre);
    }
    relocate<8>(body, mesh, blocks);
    REQUIRE(body.cells.unsorted() * 20 <= n);
    for (std::size_t p = 0; p < n; ++p)
      REQUIRE(mesh.walk(body.points.position[p], body.points.cell[p]) == body.points.cell[p]);
  }
  for (std::size_t p = 0; p < n; ++p) body.points.position.set(p, mesh.position(mesh.nodes(0)[0]));
  relocate<8>(body, mesh, blocks);
  REQUIRE(body.cells.unsorted() == 0);
  REQUIRE(std::is_sorted(body.points.cell.begin(), body.points.cell.end()));
}

TEST_CASE("cell list by hand") {
  CellList list;
  std::vector<Index> cell{0, 2, 2, 2, 4};
  list.build(cell, 6);
  const auto points = [&](Index c) {
    std::vector<Index> in_cell;
    for (const Index p : list[c]) in_cell.push_back(p);
    return in_cell;
  };
  REQUIRE(points(2) == std::vector<Index>{1, 2, 3});
  REQUIRE((list.empty(1) && list.empty(5) && !list.empty(4)));
  // Point 1 leaves cell 2 for cell 1: it changes places with the last of the run.
  std::vector<std::pair<Index, Index>> swaps;
  CellList::Move move{1, 1};
  list.leave(move, cell, [&](Index a, Index b) { swaps.emplace_back(a, b); });
  REQUIRE((move.point == 3 && move.from_run));
  list.admit(move);
  list.list_unsorted(cell);
  REQUIRE(swaps == std::vector<std::pair<Index, Index>>{{1, 3}});
  REQUIRE(points(1) == std::vector<Index>{3});
  REQUIRE(points(2) == std::vector<Index>{1, 2});
  REQUIRE(list.unsorted() == 1);
  // It moves on as an unsorted point, and nothing changes places.
  move = {3, 4};
  list.leave(move, cell, [&](Index, Index) { FAIL("a unsorted_point stays where it lies"); });
  REQUIRE(!move.from_run);
  list.admit(move);
  list.list_unsorted(cell);
  REQUIRE((list.empty(1) && points(4) == std::vector<Index>{4, 3}));
  // Another leaves for no cell: the new order omits it, and has unsorted points after the cell's own points.
  move = {1, none};
  list.leave(move, cell, [&](Index a, Index b) { swaps.emplace_back(a, b); });
  list.admit(move);
  list.list_unsorted(cell);
  REQUIRE(swaps.back() == std::pair<Index, Index>{1, 2});
  const Blocks blocks(6, 1, 2, [](Index) { return std::array<Index, 1>{0}; });
  REQUIRE(list.order(blocks) == std::vector<Index>{0, 1, 4, 3});
  list.take_order();
  REQUIRE((points(0) == std::vector<Index>{0} && points(2) == std::vector<Index>{1}));
  REQUIRE((points(4) == std::vector<Index>{2, 3} && list.unsorted() == 0));
  list.build({}, 3);
  REQUIRE(list.empty(2));
}
