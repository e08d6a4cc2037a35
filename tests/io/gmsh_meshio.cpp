// Gmsh and STL files that meshio wrote, in all formats and modes, against the arrays that meshio was given.
// The folder that make_meshes.py filled is named by the environment variable ARENITE_TEST_MESHES.
#include <arenite/geometry/triangle_surface.hpp>
#include <arenite/io/gmsh.hpp>
#include <arenite/io/stl.hpp>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>

#include "catch.hpp"

using namespace arenite;

namespace {

std::filesystem::path folder() {
  const char* const name = std::getenv("ARENITE_TEST_MESHES");
  INFO("ARENITE_TEST_MESHES must name the folder that make_meshes.py has filled");
  REQUIRE(name != nullptr);
  return name;
}

std::string with_underscores(std::string name) {
  for (char& c : name)
    if (c == ' ') c = '_';
  return name;
}

template <int D>
void compare(const MeshData<D>& mesh, const std::filesystem::path& reference) {
  std::ifstream in(reference);
  REQUIRE(in.good());
  std::string word, name;
  std::size_t count = 0, length = 0;

  REQUIRE((in >> word >> count && word == "nodes"));
  REQUIRE(mesh.nodes.size() == count);
  for (const auto& node : mesh.nodes)
    for (int k = 0; k < 3; ++k) {
      in >> word;  // through strtod: the reader uses another way
      if (k < D) REQUIRE(node[k] == std::strtod(word.c_str(), nullptr));
    }

  REQUIRE((in >> word >> count && word == "cells"));
  REQUIRE(mesh.cells.size() == count);
  REQUIRE(mesh.region.size() == count);
  for (std::size_t i = 0; i < count; ++i) {
    for (const Index node : mesh.cells[i]) {
      Index expected = none;
      in >> expected;
      REQUIRE(node == expected);
    }
    int region = -1;
    in >> region;
    REQUIRE(mesh.region[i] == region);
  }

  REQUIRE((in >> word >> count && word == "regions"));
  Map<std::string, int> regions;
  for (std::size_t i = 0; i < count; ++i) in >> name >> regions[name];
  REQUIRE(mesh.region_names.size() == count);
  for (const auto& [key, tag] : mesh.region_names) {
    REQUIRE(regions.contains(with_underscores(key)));
    REQUIRE(regions[with_underscores(key)] == tag);
  }

  REQUIRE((in >> word >> count && word == "sets"));
  Map<std::string, std::vector<Index>> sets;
  for (std::size_t i = 0; i < count; ++i) {
    in >> name >> length;
    sets[name].resize(length);
    for (Index& node : sets[name]) in >> node;
  }
  REQUIRE(in.good());
  REQUIRE(mesh.node_sets.size() == count);
  for (const auto& [key, nodes] : mesh.node_sets) REQUIRE(sets[with_underscores(key)] == nodes);
}

}  // namespace

TEST_CASE("triangles that meshio wrote are read number by number") {
  for (const char* file : {"plane_22_text", "plane_22_binary", "plane_41_text", "plane_41_binary"}) {
    INFO(file);
    compare(read_gmsh<2>(folder() / (std::string(file) + ".msh")), folder() / "plane.txt");
  }
}

TEST_CASE("tetrahedra that meshio wrote are read number by number") {
  for (const char* file : {"solid_22_text", "solid_22_binary", "solid_41_text", "solid_41_binary"}) {
    INFO(file);
    compare(read_gmsh<3>(folder() / (std::string(file) + ".msh")), folder() / "solid.txt");
  }
}

TEST_CASE("a solid mesh is no plane mesh, and the other way round") {
  REQUIRE_THROWS_AS(read_gmsh<2>(folder() / "solid_41_binary.msh"), error);
  REQUIRE_THROWS_AS(read_gmsh<3>(folder() / "plane_41_binary.msh"), error);
}

TEST_CASE("closed surfaces that meshio wrote as STL are read number by number") {
  for (const char* file : {"surface_text.stl", "surface_binary.stl"}) {
    INFO(file);
    const TriangleData data = read_stl(folder() / file);
    std::ifstream in(folder() / "surface.txt");
    std::string word;
    std::size_t count = 0;
    REQUIRE((in >> word >> count && word == "vertices"));
    REQUIRE(data.vertices.size() == count);
    for (const auto& vertex : data.vertices)
      for (int k = 0; k < 3; ++k) {
        in >> word;
        REQUIRE(vertex[k] == std::strtod(word.c_str(), nullptr));
      }
    REQUIRE((in >> word >> count && word == "triangles"));
    REQUIRE(data.triangles.size() == count);
    for (const auto& triangle : data.triangles)
      for (const Index i : triangle) {
        Index expected = none;
        in >> expected;
        REQUIRE(i == expected);
      }
    REQUIRE(in.good());
    // Unit cells of 0.1 m with corners that are off by at most a tenth of it.
    CHECK(mass_properties(TriangleSurface(data)).mass == Approx(0.3 * 0.3 * 0.2).epsilon(0.1));
  }
}
