// Meshes for tests: boxes of triangles and of tetrahedra, and boxes bent into something else.
#pragma once

#include <arenite/mesh/box_mesh.hpp>
#include <array>
#include <cmath>
#include <string>

namespace arenite::test {

inline MeshData<2> triangles(const std::array<double, 2>& lower, const std::array<double, 2>& upper, Index nx,
                             Index ny) {
  return box_mesh<2>({lower, upper, {nx, ny}});
}
inline MeshData<3> tetrahedra(const std::array<double, 3>& lower, const std::array<double, 3>& upper,
                              const std::array<Index, 3>& n) {
  return box_mesh<3>({lower, upper, n});
}

/// Slice of a hollow cylinder about the y axis: radius r0 to r1, height 0 to h, `angle` rad on both sides of
/// the plane z = 0, of n = {radial, vertical, around} bricks. Node sets as for a box, in the coordinates (r,
/// y, angle): left is the bore, front and back are the two cut faces.
inline MeshData<3> wedge(double r0, double r1, double h, double angle, const std::array<Index, 3>& n) {
  MeshData<3> data = tetrahedra({r0, 0, -angle}, {r1, h, angle}, n);
  for (auto& x : data.nodes) x = {x[0] * std::cos(x[2]), x[1], x[0] * std::sin(x[2])};
  return data;
}

/// Puts the cells whose centre passes `test` into a new region `name`.
template <int D, class Test>
void name_region(MeshData<D>& data, const std::string& name, Test&& test) {
  const int number = static_cast<int>(data.region_names.size());
  data.region_names[name] = number;
  for (std::size_t c = 0; c < data.cells.size(); ++c) {
    Vec<double, D> centre = Vec<double, D>::Zero();
    for (const Index i : data.cells[c])
      for (int k = 0; k < D; ++k) centre[k] += data.nodes[i][k] / (D + 1);
    if (test(centre)) data.region[c] = number;
  }
}

}  // namespace arenite::test
