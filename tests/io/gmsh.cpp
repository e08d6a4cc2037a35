// Gmsh files written by hand: cases that meshio cannot write, each mistake that a file can have, and files
// truncated or damaged at every byte.
#include <arenite/io/gmsh.hpp>
#include <arenite/mesh/simplex_mesh.hpp>

#include <cstring>
#include <sstream>
#include <string>
#include <vector>

#include "catch.hpp"

using namespace arenite;

namespace {

template <int D>
MeshData<D> read(const std::string& text) {
  std::istringstream in(text);
  return read_gmsh<D>(in, "box.msh");
}

/// Message of the reader for the text; empty if it accepts it.
template <int D>
std::string complaint(const std::string& text) {
  try {
    read<D>(text);
  } catch (const error& e) {
    return e.what();
  }
  return {};
}

std::string replaced(std::string text, const std::string& what, const std::string& by) {
  const std::size_t at = text.find(what);
  REQUIRE(at != std::string::npos);
  return text.replace(at, what.size(), by);
}

bool says(const std::string& message, const std::vector<std::string>& parts) {
  UNSCOPED_INFO("message: " << message);
  for (const auto& part : parts)
    if (message.find(part) == std::string::npos) return false;
  return true;
}

/// The unit square as two triangles; tags with gaps, out of order; node 50 unused; a line in each of three
/// groups.
const std::string square_2 = R"($Comments
anything
$EndComments
$MeshFormat
2.2 0 8
$EndMeshFormat
$PhysicalNames
3
1 9 "left side"
2 5 "sand"
0 9 "corner"
$EndPhysicalNames
$Nodes
5
30 1 1 0.5
7 0 0 0.5
50 4 4 4
20 0 1 0.5
10 1 0 0.5
$EndNodes
$Elements
7
1 15 2 9 1 7
2 1 2 9 1 7 20
3 1 2 8 2 7 10
4 1 2 -8 2 10 30
5 1 2 0 3 30 20
6 2 2 5 1 7 10 30
9 2 3 0 1 0 7 30 20
$EndElements
$NodeData
1
"not for us"
$EndNodeData
)";

/// One tetrahedron with a face in two groups.
const std::string tetrahedron_4 = R"($MeshFormat
4.1 0 8
$EndMeshFormat
$PhysicalNames
1
2 6 "base"
$EndPhysicalNames
$Entities
1 0 1 1
1 0 0 0 0
1 0 0 0 1 1 0 2 6 -7 0
1 0 0 0 1 1 1 1 3 1 1
$EndEntities
$Nodes
2 4 1 1000000000000
2 1 0 3
1
2
3
0 0 0
1 0 0
0 1 0
3 1 0 1
1000000000000
0 0 1
$EndNodes
$Elements
2 2 1 2
2 1 2 1
1 1 2 3
3 1 4 1
2 1 2 3 1000000000000
$EndElements
)";

template <class T>
void put(std::string& bytes, T value) {
  char raw[sizeof(T)];
  std::memcpy(raw, &value, sizeof(T));
  bytes.append(raw, sizeof(T));
}

/// The same tetrahedron in binary form, with a size_t of 4 or 8 bytes.
template <class Size>
std::string tetrahedron_4_binary() {
  std::string b = "$MeshFormat\n4.1 1 " + std::to_string(sizeof(Size)) + "\n";
  const auto ints = [&](std::initializer_list<int> values) {
    for (const int v : values) put(b, v);
  };
  const auto sizes = [&](std::initializer_list<Size> values) {
    for (const Size v : values) put(b, v);
  };
  const auto reals = [&](std::initializer_list<double> values) {
    for (const double v : values) put(b, v);
  };
  ints({1});
  b += "\n$EndMeshFormat\n$PhysicalNames\n1\n2 6 \"base\"\n$EndPhysicalNames\n$Entities\n";
  sizes({0, 0, 1, 1});
  ints({1}), reals({0, 0, 0, 1, 1, 0}), sizes({2}), ints({6, -7}), sizes({0});
  ints({1}), reals({0, 0, 0, 1, 1, 1}), sizes({1}), ints({3}), sizes({1}), ints({1});
  b += "\n$EndEntities\n$Nodes\n";
  sizes({1, 4, 1, 4}), ints({3, 1, 0}), sizes({4, 1, 2, 3, 4});
  reals({0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1});
  b += "\n$EndNodes\n$Elements\n";
  sizes({2, 2, 1, 2});
  ints({2, 1, 2}), sizes({1, 1, 1, 2, 3});
  ints({3, 1, 4}), sizes({1, 2, 1, 2, 3, 4});
  return b + "\n$EndElements\n";
}

std::string triangle_2_binary() {
  std::string b = "$MeshFormat\n2.2 1 8\n";
  put(b, 1);
  b += "\n$EndMeshFormat\n$Nodes\n3\n";
  const double x[3][3] = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  for (int i = 0; i < 3; ++i) {
    put(b, i + 1);
    for (const double v : x[i]) put(b, v);
  }
  b += "\n$EndNodes\n$Elements\n3\n";
  for (const int v : {1, 2, 2, 1, 4, 1, 1, 2, 2, 4, 1, 2, 3, 2, 1, 0, 3, 1, 2, 3}) put(b, v);
  return b + "\n$EndElements\n";
}

void check_tetrahedron(const MeshData<3>& mesh) {
  REQUIRE(mesh.nodes.size() == 4);
  REQUIRE(mesh.nodes[3] == Vec<double, 3>(0, 0, 1));
  REQUIRE(mesh.cells == std::vector<std::array<Index, 4>>{{0, 1, 2, 3}});
  REQUIRE(mesh.region == std::vector<int>{3});
  REQUIRE(mesh.region_names.empty());
  REQUIRE(mesh.node_sets == Map<std::string, std::vector<Index>>{{"base", {0, 1, 2}}, {"2:7", {0, 1, 2}}});
}

/// Every file cut short, and every file with one byte changed, is refused or read: under the sanitizers this
/// test shows that no number in a file is believed unchecked.
template <int D>
void damage(const std::string& file) {
  REQUIRE(complaint<D>(file).empty());
  const std::size_t complete = file.find("$EndElements") + std::strlen("$EndElements");
  for (std::size_t n = 0; n < complete; ++n) {
    INFO("cut after byte " << n);
    REQUIRE_FALSE(complaint<D>(file.substr(0, n)).empty());
  }
  for (std::size_t n = 0; n < file.size(); ++n)
    for (const int byte : {0, 1, 0x20, 0x2d, 0x39, 0x7f, 0x80, 0xff}) {
      std::string damaged = file;
      damaged[n] = static_cast<char>(byte);
      complaint<D>(damaged);  // whichever: it must return
    }
}

}  // namespace

TEST_CASE("format 2.2: gaps in the tags, unused nodes, unnamed groups, groups of one name") {
  const auto mesh = read<2>(square_2);
  REQUIRE(mesh.nodes.size() == 4);  // 7, 10, 20, 30
  REQUIRE(mesh.nodes[0] == Vec<double, 2>(0, 0));
  REQUIRE(mesh.nodes[1] == Vec<double, 2>(1, 0));
  REQUIRE(mesh.nodes[2] == Vec<double, 2>(0, 1));
  REQUIRE(mesh.nodes[3] == Vec<double, 2>(1, 1));
  REQUIRE(mesh.cells == std::vector<std::array<Index, 3>>{{0, 1, 3}, {0, 3, 2}});
  REQUIRE(mesh.region == std::vector<int>{5, 0});
  REQUIRE(mesh.region_names == Map<std::string, int>{{"sand", 5}});
  REQUIRE(mesh.node_sets ==
          Map<std::string, std::vector<Index>>{{"left side", {0, 2}}, {"corner", {0}}, {"1:8", {0, 1, 3}}});
  const auto joined = read<2>(replaced(square_2, "\"corner\"", "\"left side\""));
  REQUIRE(joined.node_sets.at("left side") == std::vector<Index>{0, 2});
}

TEST_CASE("format 4.1: sparse tags, an entity in two groups, a size_t of 4 bytes, no entities") {
  check_tetrahedron(read<3>(tetrahedron_4));
  check_tetrahedron(read<3>(tetrahedron_4_binary<std::uint64_t>()));
  check_tetrahedron(read<3>(tetrahedron_4_binary<std::uint32_t>()));
  std::string bare = tetrahedron_4;
  const std::size_t begin = bare.find("$Entities"), end = bare.find("$Nodes");
  bare.erase(begin, end - begin);
  REQUIRE(read<3>(bare).region == std::vector<int>{0});
  REQUIRE(read<3>(bare).node_sets.empty());
}

TEST_CASE("lines may end as on Windows, numbers may carry a plus sign") {
  std::string text;
  for (const char c : square_2) text += c == '\n' ? std::string("\r\n") : std::string(1, c);
  REQUIRE(read<2>(text).node_sets == read<2>(square_2).node_sets);
  REQUIRE(read<2>(replaced(square_2, "30 1 1", "30 +1e0 1")).nodes[3][0] == 1);
}

TEST_CASE("a mistake is reported with file, place, value and rule") {
  const auto on_2 = [](const std::string& what, const std::string& by) {
    return complaint<2>(replaced(square_2, what, by));
  };
  CHECK(says(complaint<2>(""), {"box.msh", "$MeshFormat", "missing"}));
  CHECK(says(complaint<2>("solid cube\n"), {"box.msh", "line 1", "solid cube"}));
  CHECK(says(complaint<2>(std::string("$Nod\0es\n", 8)),
             {"box.msh", "line 1", "$Nod?es", "the $Name of a section"}));
  CHECK(says(complaint<2>("$Nodes\n0\n$EndNodes\n"), {"$Nodes", "behind $MeshFormat"}));
  CHECK(says(on_2("2.2 0 8", "4.0 0 8"), {"line 5", "version = 4", "2.2 or 4.1"}));
  CHECK(says(on_2("2.2 0 8", "2.2 2 8"), {"file type = 2", "0 (text) or 1 (binary)"}));
  CHECK(says(on_2("2.2 0 8", "2.2 0 4"), {"data size = 4"}));
  CHECK(says(on_2("\"sand\"", "sand"), {"line 10", "double quotes"}));
  CHECK(says(on_2("0 9 \"corner\"", "2 6 \"sand\""), {"\"sand\"", "two regions"}));
  CHECK(says(on_2("0 9 \"corner\"", "1 9 \"corner\""), {"tag of the group = 9", "twice"}));
  CHECK(says(on_2("30 1 1 0.5", "30 1 1"), {"$Nodes", "line 16"}));
  CHECK(says(on_2("30 1 1 0.5", "30 1 1 0.5 2"), {"line 15", "\"2\"", "too much for this line"}));
  CHECK(says(on_2("30 1 1 0.5", "30 1 one 0.5"), {"line 15", "y = \"one\"", "must be a number"}));
  CHECK(says(on_2("30 1 1 0.5", "30 1 nan 0.5"), {"line 15", "y of node 30 = nan", "finite"}));
  CHECK(says(on_2("30 1 1 0.5", "30 -inf 1 0.5"), {"x of node 30 = -inf", "finite"}));
  CHECK(says(on_2("30 1 1 0.5", "30 1e999 1 0.5"), {"x = \"1e999\"", "too large"}));
  CHECK(says(on_2("30 1 1 0.5", "20 1 1 0.5"), {"tag of the node = 20", "twice"}));
  CHECK(says(on_2("30 1 1 0.5", "0 1 1 0.5"), {"tag of the node = 0", "at least 1"}));
  CHECK(says(on_2("30 1 1 0.5", "30 1 1 0.6"), {"z of node 30 = 0.6", "0.5", "plane"}));
  CHECK(says(on_2("$Nodes\n5", "$Nodes\n4"), {"$EndNodes"}));
  CHECK(says(on_2("$Nodes\n5", "$Nodes\n6"), {"$Nodes", "$EndNodes"}));
  CHECK(says(on_2("$Nodes\n5", "$Nodes\n-5"), {"number of nodes = \"-5\""}));
  CHECK(says(on_2("$Nodes\n5", "$Nodes\n5000000000000"), {"5000000000000", "rest of the file"}));
  CHECK(says(on_2("$Elements\n7", "$Elements\n6"), {"$EndElements"}));
  CHECK(says(on_2("6 2 2 5 1 7 10 30", "6 2 2 5 1 7 10 31"),
             {"line 28", "node of the element = 31", "$Nodes"}));
  CHECK(says(on_2("6 2 2 5 1 7 10 30", "6 2 2 5 1 7 10 7"), {"node of the cell = 7", "twice"}));
  CHECK(says(on_2("6 2 2 5 1 7 10 30", "6 2 2 5 1 7 20 30"), {"7 20 30", "given twice"}));
  CHECK(says(on_2("6 2 2 5 1 7 10 30", "6 3 2 5 1 7 10 30 20"), {"3 (quadrangle)", "triangles"}));
  CHECK(says(on_2("6 2 2 5 1 7 10 30", "6 9 2 5 1 7 10 30 7 7 7"), {"9 (6-node triangle)", "first order"}));
  CHECK(says(on_2("2 1 2 9 1 7 20", "2 8 2 9 1 7 20 10"), {"8 (3-node line)", "first order"}));
  CHECK(says(on_2("6 2 2 5 1 7 10 30", "6 4 2 5 1 7 10 30 20"),
             {"4 (tetrahedron)", "read solids in 3 dimensions"}));
  CHECK(says(on_2("6 2 2 5 1 7 10 30", "6 77 2 5 1 7 10 30"), {"77", "no known type"}));
  CHECK(says(on_2("6 2 2 5 1 7 10 30", "6 2 -2 7 10 30"), {"number of tags = -2"}));
  CHECK(says(on_2("$NodeData", "$Nodes"), {"$Nodes", "twice"}));
  CHECK(says(on_2("$EndNodeData", ""), {"$NodeData", "ends without $EndNodeData"}));
  CHECK(says(complaint<3>(square_2), {"box.msh", "cells = 0", "tetrahedra"}));

  const auto on_4 = [](const std::string& what, const std::string& by) {
    return complaint<3>(replaced(tetrahedron_4, what, by));
  };
  CHECK(says(on_4("2 1 0 3", "2 1 1 3"), {"parametric = 1", "SaveParametric"}));
  CHECK(says(on_4("2 4 1 1000000000000", "2 5 1 1000000000000"), {"number of nodes = 5", "1 more"}));
  CHECK(says(on_4("2 1 0 3", "2 1 0 5"), {"items of the block = 5", "at most 4"}));
  std::string parametric = replaced(square_2, "$Nodes", "$ParametricNodes");
  CHECK(says(complaint<2>(replaced(parametric, "$EndNodes", "$EndParametricNodes")),
             {"section = $ParametricNodes", "Mesh.SaveParametric = 0"}));
  CHECK(says(on_4("3 1 4 1", "3 2 4 1"), {"tag of the entity = 2", "$Entities of dimension 3"}));
  CHECK(says(on_4("3 1 4 1", "2 1 4 1"), {"tetrahedron", "dimension of its entity, 2"}));
  CHECK(says(on_4("3 1 4 1", "3 1 5 1"), {"5 (hexahedron)", "tetrahedra"}));
  CHECK(says(on_4("$Entities", "$PartitionedEntities"), {"$PartitionedEntities", "not read"}));
  CHECK(says(on_4("2 1 2 3 1000000000000", "2 1 2 3 999"), {"node of the element = 999"}));

  std::string foreign = triangle_2_binary();
  std::swap(foreign[20], foreign[23]);
  CHECK(says(complaint<2>(foreign), {"byte 20", "byte order", "big-endian"}));
  REQUIRE_THROWS_WITH(read_gmsh<2>(std::filesystem::path("no/such.msh")), "mesh = no/such.msh: no such file");
  REQUIRE_THROWS_WITH(read_gmsh<2>(std::filesystem::path("/dev/zero")),
                      "mesh = /dev/zero: must be a regular file, not a pipe or a device");
  REQUIRE_THROWS_AS(read_gmsh<2>(std::filesystem::path(".")), error);
}

TEST_CASE("a file cut or damaged at any byte is refused or read, never worse") {
  damage<2>(square_2);
  damage<3>(tetrahedron_4);
  damage<3>(tetrahedron_4_binary<std::uint64_t>());
  damage<3>(tetrahedron_4_binary<std::uint32_t>());
  damage<2>(triangle_2_binary());
}

TEST_CASE("a cell in several groups belongs to the region of each") {
  // Format 2.2 has an element for each group: the first triangle is in sand and all, the second only in all.
  std::string text = replaced(square_2, "3\n1 9", "4\n2 6 \"all\"\n1 9");
  text = replaced(text, "$Elements\n7", "$Elements\n8");
  text = replaced(text, "9 2 3 0 1 0 7 30 20", "9 2 3 6 1 0 7 30 20\n10 2 2 6 1 10 30 7");
  const auto square = read<2>(text);
  REQUIRE(square.cells == read<2>(square_2).cells);
  REQUIRE(square.region == std::vector<int>{-1, 6});
  REQUIRE(square.shared_regions == Map<std::string, std::vector<int>>{{"sand", {-1}}, {"all", {-1}}});
  const SimplexMesh<2> mesh(square);
  REQUIRE(mesh.region_numbers("sand") == std::vector<int>{5, -1});
  REQUIRE(mesh.is_in(0, mesh.region_numbers("sand")));
  REQUIRE(!mesh.is_in(1, mesh.region_numbers("sand")));
  REQUIRE(mesh.is_in(0, mesh.region_numbers("all")));
  REQUIRE(mesh.is_in(1, mesh.region_numbers("all")));
  REQUIRE_THROWS_WITH(mesh.region_number("sand"),
                      "SimplexMesh: region = sand: shares cells with another: see region_numbers");
  // In one group twice it is a mistake.
  CHECK(says(complaint<2>(replaced(text, "10 2 2 6 1 10 30 7", "10 2 2 5 1 10 30 7")),
             {"7 10 30", "given twice"}));

  // Format 4.1 names all groups of an entity.
  auto solid = read<3>(replaced(replaced(tetrahedron_4, "1 0 0 0 1 1 1 1 3 1 1", "1 0 0 0 1 1 1 2 3 4 1 1"),
                                "1\n2 6 \"base\"", "3\n2 6 \"base\"\n3 3 \"a\"\n3 4 \"b\""));
  REQUIRE(solid.region == std::vector<int>{-1});
  REQUIRE(solid.shared_regions == Map<std::string, std::vector<int>>{{"a", {-1}}, {"b", {-1}}});
}
