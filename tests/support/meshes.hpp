// Small structured simplex meshes for tests: boxes of triangles and of tetrahedra, and boxes bent into
// something else.
#pragma once

#include <algorithm>
#include <arenite/mesh/mesh_data.hpp>
#include <array>
#include <cmath>
#include <string>
#include <utility>

namespace arenite::test {

/// Names for the nodes on the faces of a box: left, right (x), bottom, top (y), front, back (z).
template <int D>
void name_faces(MeshData<D>& data, const std::array<double, static_cast<std::size_t>(D)>& lower,
                const std::array<double, static_cast<std::size_t>(D)>& upper) {
  const std::array<const char*, 6> names{"left", "right", "bottom", "top", "front", "back"};
  for (std::size_t k = 0; k < D; ++k) {
    const double near = 1e-9 * (upper[k] - lower[k]);
    for (Index i = 0; i < data.nodes.size(); ++i) {
      const double x = data.nodes[i][static_cast<int>(k)];
      if (x < lower[k] + near) data.node_sets[names[2 * k]].push_back(i);
      if (x > upper[k] - near) data.node_sets[names[2 * k + 1]].push_back(i);
    }
  }
}

/// nx x ny rectangles of two triangles each; the diagonals alternate, so that no direction is preferred.
/// Region "all"; node sets left, right, bottom, top.
inline MeshData<2> triangles(const std::array<double, 2>& lower, const std::array<double, 2>& upper, Index nx,
                             Index ny) {
  MeshData<2> data;
  for (Index j = 0; j <= ny; ++j)
    for (Index i = 0; i <= nx; ++i)
      data.nodes.push_back(
          {lower[0] + (upper[0] - lower[0]) * i / nx, lower[1] + (upper[1] - lower[1]) * j / ny});
  for (Index j = 0; j < ny; ++j)
    for (Index i = 0; i < nx; ++i) {
      const Index a = j * (nx + 1) + i, b = a + 1, c = b + nx + 1, d = a + nx + 1;
      if ((i + j) % 2 == 0) {
        data.cells.push_back({a, b, c});
        data.cells.push_back({a, c, d});
      } else {
        data.cells.push_back({a, b, d});
        data.cells.push_back({b, c, d});
      }
    }
  data.region.assign(data.cells.size(), 0);
  data.region_names["all"] = 0;
  name_faces<2>(data, lower, upper);
  return data;
}

/// nx x ny x nz bricks of six tetrahedra each, one for each order of the three axes (Kuhn 1960, Some
/// combinatorial lemmas in topology): all share the brick's diagonal, and neighbours fit. Region "all"; node
/// sets left, right, bottom, top, front, back.
inline MeshData<3> tetrahedra(const std::array<double, 3>& lower, const std::array<double, 3>& upper,
                              const std::array<Index, 3>& n) {
  MeshData<3> data;
  const auto number = [&](const std::array<Index, 3>& at) {
    return (at[2] * (n[1] + 1) + at[1]) * (n[0] + 1) + at[0];
  };
  for (Index k = 0; k <= n[2]; ++k)
    for (Index j = 0; j <= n[1]; ++j)
      for (Index i = 0; i <= n[0]; ++i)
        data.nodes.push_back({lower[0] + (upper[0] - lower[0]) * i / n[0],
                              lower[1] + (upper[1] - lower[1]) * j / n[1],
                              lower[2] + (upper[2] - lower[2]) * k / n[2]});
  for (Index k = 0; k < n[2]; ++k)
    for (Index j = 0; j < n[1]; ++j)
      for (Index i = 0; i < n[0]; ++i) {
        std::array<std::size_t, 3> order{0, 1, 2};
        do {
          std::array<Index, 3> at{i, j, k};
          std::array<Index, 4> cell{number(at)};
          for (std::size_t s = 0; s < 3; ++s) {
            ++at[order[s]];
            cell[s + 1] = number(at);
          }
          data.cells.push_back(cell);
        } while (std::next_permutation(order.begin(), order.end()));
      }
  data.region.assign(data.cells.size(), 0);
  data.region_names["all"] = 0;
  name_faces<3>(data, lower, upper);
  return data;
}

/// Slice of a hollow cylinder about the y axis: radius r0 to r1, height 0 to h, `angle` rad on both sides of
/// the plane z = 0, of n = {radial, vertical, around} bricks. Node sets as for a box, in the coordinates (r,
/// y, angle): left is the bore, front and back are the two cut faces.
inline MeshData<3> wedge(double r0, double r1, double h, double angle, const std::array<Index, 3>& n) {
  MeshData<3> data = tetrahedra({r0, 0, -angle}, {r1, h, angle}, n);
  for (auto& x : data.nodes) x = {x[0] * std::cos(x[2]), x[1], x[0] * std::sin(x[2])};
  return data;
}

/// Gives the cells whose centre passes `test` a region of their own.
template <int D, class Test>
void name_region(MeshData<D>& data, const std::string& name, Test&& test) {
  const int number = static_cast<int>(data.region_names.size());
  data.region_names[name] = number;
  for (std::size_t c = 0; c < data.cells.size(); ++c) {
    Vec<double, D> centre = Vec<double, D>::Zero();
    for (const Index i : data.cells[c]) centre += data.nodes[i] / (D + 1);
    if (test(centre)) data.region[c] = number;
  }
}

}  // namespace arenite::test
