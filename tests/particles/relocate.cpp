// Relocation: each point in its cell, lost points counted with their mass, and nothing else changed.
#include "catch.hpp"

#include <arenite/law/linear_elastic.hpp>
#include <arenite/particles/body.hpp>
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
  auto body = make_body<std::conditional_t<M::dimension == 2, PlaneStrain, Solid>, true>(
      mesh, fill(Box<M::dimension>{lower, upper}, law, {.per_cell = 1}));
  for (std::size_t p = 0; p < body.points.size(); ++p) {
    body.points.velocity[p][0] = static_cast<typename M::scalar>(p);
    body.points.motion[p].setConstant(static_cast<typename M::scalar>(p));
  }
  return body;
}

template <class M>
void check_relocation(M mesh, double spread) {
  auto body = numbered_body(mesh);
  std::mt19937 random(11);
  std::normal_distribution<double> normal(0, spread);
  std::size_t lost = 0;
  double lost_mass = 0;
  for (int round = 0; round < 20; ++round) {
    for (auto& x : body.points.position)
      for (int k = 0; k < M::dimension; ++k) x[k] += static_cast<typename M::scalar>(normal(random));
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
    relocate(body, mesh);
    REQUIRE(body.lost == lost);
    REQUIRE(std::abs(body.lost_mass - lost_mass) <= 1e-12 * lost_mass);
    REQUIRE(body.points.size() == place.size());
    bool same = true, there = true;
    for (std::size_t p = 0; p < body.points.size(); ++p) {
      const auto number = static_cast<std::size_t>(body.points.velocity[p][0]);
      const std::size_t q = place.at(number);
      same = same && body.points.position[p] == before.position[q] && body.points.mass[p] == before.mass[q] &&
             body.points.volume[p] == before.volume[q] && body.points.motion[p] == before.motion[q];
      const Index c = body.points.cell[p];
      there = there && mesh.walk(body.points.position[p], c) == c;
    }
    REQUIRE(same);
    REQUIRE(there);
    // The list of cells: every point once, in its cell, ascending.
    std::vector<int> seen(body.points.size(), 0);
    bool listed = true;
    for (Index c = 0; c < mesh.cell_count(); ++c) {
      const auto in_cell = body.cells[c];
      listed =
          listed && std::is_sorted(in_cell.begin(), in_cell.end()) && in_cell.empty() == body.cells.empty(c);
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
  BoxMesh<2> ring{};
  ring.cells = {9, 9};
  ring.keep = [](const auto& x) {
    return (x - Vec<double, 2>(0.5, 0.5)).template lpNorm<Eigen::Infinity>() > 0.2;
  };
  check_relocation(SimplexMesh<2>(box_mesh(ring)), 0.05);
}

TEST_CASE("relocation on grids") {
  check_relocation(CartesianGrid<2>({.lower = {0, 0}, .upper = {1, 1}, .cell = 0.05}), 0.05);
  check_relocation(CartesianGrid<3, float>({.lower = {0, 0, 0}, .upper = {1, 1, 1}, .cell = 0.125}), 0.05);
}

TEST_CASE("points that stay are not touched") {
  auto mesh = sample_mesh<2>(4);
  auto body = numbered_body(mesh);
  const auto* column = body.points.position.data();
  relocate(body, mesh);
  REQUIRE(body.points.position.data() == column);
  REQUIRE((body.lost == 0 && body.moved == 0));
}

TEST_CASE("a body may lose all its points, and one that is no number is lost") {
  auto mesh = sample_mesh<2>(4);
  auto body = numbered_body(mesh);
  for (auto& x : body.points.position) x[0] += 5;
  body.points.position[0][1] = std::nan("");
  relocate(body, mesh);
  REQUIRE(body.points.size() == 0);
  REQUIRE(body.lost == 32);
  REQUIRE(std::abs(body.lost_mass - 1000) < 1e-10);
  REQUIRE_NOTHROW(relocate(body, mesh));
}

TEST_CASE("cell list by hand") {
  CellList list;
  list.build({2, 0, 2, 2, 4}, 6);
  REQUIRE(list.order() == std::vector<Index>{1, 0, 2, 3, 4});
  REQUIRE(std::vector<Index>(list[2].begin(), list[2].end()) == std::vector<Index>{0, 2, 3});
  REQUIRE((list.empty(1) && list.empty(5) && !list.empty(4)));
  list.build({}, 3);
  REQUIRE(list.empty(2));
}
