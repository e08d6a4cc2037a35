// The simplex mesh: orientation, volumes, neighbours, refusals, motion.
#include "catch.hpp"
#include "sample_meshes.hpp"

using namespace arenite;
using namespace arenite::test;

namespace {

MeshData<2> two_triangles() {
  return {{{0, 0}, {1, 0}, {1, 1}, {0, 1}},
          {{{0, 1, 2}}, {{0, 3, 2}}},
          {0, 7},
          {{"sand", 0}, {"iron", 7}},
          {{"base", {0, 1}}}};
}

template <class M>
double total_volume(const M& mesh) {
  double sum = 0;
  for (Index c = 0; c < mesh.cell_count(); ++c) sum += static_cast<double>(mesh.volume(c));
  return sum;
}

/// Neighbours by trying all pairs: the cell that shares all nodes but local node k.
template <int D>
Index shared(const SimplexMesh<D>& mesh, Index cell, std::size_t k) {
  for (Index other = 0; other < mesh.cell_count(); ++other) {
    if (other == cell) continue;
    int common = 0;
    for (std::size_t j = 0; j <= D; ++j)
      if (j != k)
        common += static_cast<int>(
            std::count(mesh.nodes(other).begin(), mesh.nodes(other).end(), mesh.nodes(cell)[j]));
    if (common == D) return other;
  }
  return none;
}

}  // namespace

TEMPLATE_TEST_CASE("cells are turned, filled and joined", "", (std::integral_constant<int, 2>),
                   (std::integral_constant<int, 3>)) {
  constexpr int D = TestType::value;
  const auto mesh = sample_mesh<D>(4);
  REQUIRE(mesh.cell_count() == (D == 2 ? 32 : 384));
  REQUIRE(std::abs(total_volume(mesh) - 1) < 1e-14);
  double least = 1;
  bool same = true, listed = true;
  for (Index c = 0; c < mesh.cell_count(); ++c) {
    least = std::min(least, mesh.volume(c));
    Mat<double, D> edges;
    for (int k = 0; k < D; ++k)
      edges.col(k) =
          mesh.position(mesh.nodes(c)[static_cast<std::size_t>(k + 1)]) - mesh.position(mesh.nodes(c)[0]);
    same = same && std::abs(edges.determinant() / (D == 2 ? 2 : 6) - mesh.volume(c)) < 1e-16;
    for (std::size_t k = 0; k <= D; ++k) {
      same = same && mesh.neighbour(c, static_cast<int>(k)) == shared<D>(mesh, c, k);
      const auto at = mesh.cells_at(mesh.nodes(c)[k]);
      listed = listed && std::count(at.begin(), at.end(), c) == 1 && std::is_sorted(at.begin(), at.end());
    }
  }
  REQUIRE(least > 0);
  REQUIRE(same);
  REQUIRE(listed);
}

TEST_CASE("size is the smallest altitude") {
  // Legs 3 and 4, hypotenuse 5: altitudes 4, 3 and 12/5.
  const SimplexMesh<2> triangle({{{0, 0}, {3, 0}, {0, 4}}, {{{0, 1, 2}}}, {}, {}, {}});
  REQUIRE(std::abs(triangle.size(0) - 2.4) < 1e-15);
  REQUIRE(std::abs(triangle.node_size(1) - 2.4) < 1e-15);
  // A corner of the unit cube: its altitude above the slanted face is 1 / sqrt(3).
  const SimplexMesh<3> tetrahedron(
      {{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, {{{0, 1, 2, 3}}}, {}, {}, {}});
  REQUIRE(std::abs(tetrahedron.size(0) - 1 / std::sqrt(3.0)) < 1e-15);
}

TEST_CASE("names") {
  const SimplexMesh<2> mesh(two_triangles());
  REQUIRE(mesh.region_number("iron") == 7);
  REQUIRE(mesh.region(1) == 7);
  REQUIRE(mesh.node_set("base") == std::vector<Index>{0, 1});
  REQUIRE(mesh.has_node_set("base"));
  REQUIRE_FALSE(mesh.has_node_set("top"));
  REQUIRE(throws([&] { mesh.region_number("gold"); }, "region = gold: must be one of: iron, sand"));
  REQUIRE(throws([&] { mesh.node_set("top"); }, "node set = top: must be one of: base"));
}

TEST_CASE("bad meshes are refused") {
  auto data = two_triangles();
  const auto refuses = [&](const std::string& text) { return throws([&] { SimplexMesh<2> m(data); }, text); };
  SECTION("no cells") {
    data.cells.clear();
    REQUIRE(refuses("SimplexMesh.cells = 0: a mesh needs at least one cell"));
  }
  SECTION("flat") {
    data.nodes[3] = {0.5, 0.5};
    REQUIRE(refuses("SimplexMesh.cells[1].volume = 0: a cell must not be flat"));
  }
  SECTION("nearly flat") {
    data.nodes[3] = {0.5, 0.5 + 1e-14};
    REQUIRE(refuses("must not be flat"));
  }
  SECTION("a node twice") {
    data.cells[0] = {0, 1, 1};
    REQUIRE(refuses("must not be flat"));
  }
  SECTION("no such node") {
    data.cells[1][2] = 4;
    REQUIRE(refuses("SimplexMesh.cells[1] = 4: must be a node of the mesh"));
  }
  SECTION("no such node in a set") {
    data.node_sets["base"].push_back(9);
    REQUIRE(refuses("SimplexMesh.node_sets[base] = 9: must be a node of the mesh"));
  }
  SECTION("not finite") {
    data.nodes[2][1] = std::numeric_limits<double>::quiet_NaN();
    REQUIRE(refuses("positions must be finite"));
    data.nodes[2][1] = std::numeric_limits<double>::infinity();
    REQUIRE(refuses("positions must be finite"));
  }
  SECTION("three cells on a face") {
    data.nodes.push_back({2, 3});
    data.cells.push_back({0, 2, 4});
    data.region.push_back(0);
    REQUIRE(refuses("no more than two cells may share a face"));
  }
  SECTION("regions of some cells only") {
    data.region.pop_back();
    REQUIRE(refuses("SimplexMesh.region = 1: must have one entry a cell"));
  }
  SECTION("good") { REQUIRE_NOTHROW(SimplexMesh<2>(data)); }
}

TEST_CASE("a small and a large mesh are as good as one of 1 m") {
  for (const double scale : {1e-6, 1e6}) {
    SampleMesh<3> o{};
    o.cells = {2, 2, 2};
    o.upper *= scale;
    REQUIRE(std::abs(total_volume(SimplexMesh<3>(sample_data(o))) / std::pow(scale, 3) - 1) < 1e-13);
    REQUIRE(std::abs(total_volume(SimplexMesh<3, float>(sample_data(o))) / std::pow(scale, 3) - 1) < 1e-5);
  }
}

TEMPLATE_TEST_CASE("cells whose volume or size is not a number in the scalar are refused", "",
                   (std::integral_constant<int, 2>), (std::integral_constant<int, 3>)) {
  constexpr int D = TestType::value;
  const auto scaled = [](double scale) {
    SampleMesh<D> o{};
    o.cells.fill(2);
    auto data = sample_data(o);
    for (auto& x : data.nodes) x *= scale;
    return data;
  };
  const std::string rule = "m in the scalar of the mesh, or the cell's volume or size is not a number";
  for (const double scale : {1e-30, 1e-20, 1e-14, 1e14, 1e20, 1e30}) {
    REQUIRE(throws([&] { SimplexMesh<D, float> m(scaled(scale)); }, rule));
    REQUIRE(throws([&] { SimplexMesh<D, float> m(scaled(scale)); }, "SimplexMesh.cells[0].edge = "));
    REQUIRE_NOTHROW(SimplexMesh<D>(scaled(scale)));
  }
  for (const double scale : {1e-300, 1e-150, 1e150, 1e300})
    REQUIRE(throws([&] { SimplexMesh<D> m(scaled(scale)); }, rule));
  REQUIRE(throws([&] { SimplexMesh<D, float> m(scaled(1e300)); }, "finite in the scalar of the mesh"));
  // Accepted meshes have volumes, sizes and gradients.
  const auto check = [](const auto& mesh) {
    for (Index c = 0; c < mesh.cell_count(); ++c) {
      REQUIRE(std::isnormal(mesh.volume(c)));
      REQUIRE(std::isnormal(mesh.size(c)));
      REQUIRE(mesh.frame(c).inverse.allFinite());
    }
  };
  for (const double scale : {1e-11, 1e-6, 1e6, 1e12}) check(SimplexMesh<D, float>(scaled(scale)));
  for (const double scale : {1e-98, 1e101}) check(SimplexMesh<D>(scaled(scale)));
}

TEST_CASE("a mesh moves, and its frames and its search with it") {
  auto mesh = sample_mesh<2>(4);
  std::vector<Index> nodes(mesh.node_count()), cells(mesh.cell_count());
  std::iota(nodes.begin(), nodes.end(), 0u);
  std::iota(cells.begin(), cells.end(), 0u);
  REQUIRE(mesh.search({0.5, 0.3}) != none);
  const auto before = mesh.positions();
  REQUIRE(mesh.move(nodes, cells,
                    [&](Index i) { return Vec<double, 2>(before[i] * 2 + Vec<double, 2>(3, 0)); }) == none);
  REQUIRE(std::abs(total_volume(mesh) - 4) < 1e-13);
  REQUIRE(mesh.search({0.5, 0.3}) == none);
  const Index found = mesh.search({4.9, 1.9});
  REQUIRE(found != none);
  REQUIRE(mesh.barycentric(found, {4.9, 1.9}).minCoeff() >= 0);
  REQUIRE(mesh.walk({3.1, 0.1}, found) != none);
  // Mirrored: every cell is inside out, the first is named.
  REQUIRE(mesh.move(nodes, cells, [&](Index i) { return Vec<double, 2>(-before[i][0], before[i][1]); }) == 0);
}
