// Adjacency of a simplex mesh: which cells share a node, and which cell lies across a face.
#pragma once
// SPDX-License-Identifier: BSD-3-Clause

#include <algorithm>
#include <array>
#include <span>
#include <vector>

#include <arenite/core/error.hpp>
#include <arenite/core/lists.hpp>
#include <arenite/core/scalar.hpp>

namespace arenite::inline ARENITE_INSTRUCTION_SET {

/// [node] the cells at each node, ascending.
template <std::size_t N>
Lists cells_at_nodes(Index node_count, const std::vector<std::array<Index, N>>& cells) {
  return {node_count, [&](auto&& add) {
            for (std::size_t c = 0; c < cells.size(); ++c)
              for (const Index i : cells[c]) add(i, static_cast<Index>(c));
          }};
}

/// [cell][k] the cell across the face opposite to local node k, or `none` on the hull.
/// Throws `error` if more than two cells share a face.
template <int D>
std::vector<std::array<Index, D + 1>> simplex_neighbours(const std::vector<std::array<Index, D + 1>>& cells) {
  struct Face {
    std::array<Index, D> nodes;  // ascending
    Index cell;
    Index local;
  };
  std::vector<Face> faces;
  faces.reserve(cells.size() * (D + 1));
  for (std::size_t c = 0; c < cells.size(); ++c)
    for (std::size_t k = 0; k <= D; ++k) {
      Face face{{}, static_cast<Index>(c), static_cast<Index>(k)};
      for (std::size_t i = 0, at = 0; i <= D; ++i)
        if (i != k) face.nodes[at++] = cells[c][i];
      std::sort(face.nodes.begin(), face.nodes.end());
      faces.push_back(face);
    }
  std::sort(faces.begin(), faces.end(), [](const Face& a, const Face& b) {
    return a.nodes != b.nodes ? a.nodes < b.nodes : a.cell < b.cell;
  });
  std::array<Index, D + 1> hull;
  hull.fill(none);
  std::vector<std::array<Index, D + 1>> neighbours(cells.size(), hull);
  for (std::size_t i = 0; i + 1 < faces.size(); ++i) {
    const Face &a = faces[i], &b = faces[i + 1];
    if (a.nodes != b.nodes) continue;
    require(i + 2 >= faces.size() || faces[i + 2].nodes != a.nodes, "SimplexMesh.cells", a.cell,
            "no more than two cells may share a face");
    neighbours[a.cell][a.local] = b.cell;
    neighbours[b.cell][b.local] = a.cell;
  }
  return neighbours;
}

}  // namespace arenite::inline ARENITE_INSTRUCTION_SET
