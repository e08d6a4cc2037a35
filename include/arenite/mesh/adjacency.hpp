// Adjacency of a simplex mesh: which cells meet at a node, and which cell lies behind a face.
#pragma once

#include <algorithm>
#include <array>
#include <span>
#include <vector>

#include <arenite/core/error.hpp>
#include <arenite/core/scalar.hpp>

namespace arenite::inline ARENITE_INSTRUCTION_SET {

/// Cells at each node, in ascending order, as one array with offsets.
class Adjacency {
 public:
  Adjacency() = default;

  template <std::size_t N>
  Adjacency(Index node_count, const std::vector<std::array<Index, N>>& cells) : start_(node_count + 1, 0) {
    for (const auto& nodes : cells)
      for (const Index i : nodes) ++start_[i + 1];
    for (std::size_t i = 1; i < start_.size(); ++i) start_[i] += start_[i - 1];
    cells_.resize(start_.back());
    std::vector<Index> next(start_.begin(), start_.end() - 1);
    for (std::size_t c = 0; c < cells.size(); ++c)
      for (const Index i : cells[c]) cells_[next[i]++] = static_cast<Index>(c);
  }

  std::span<const Index> operator[](Index node) const {
    return {cells_.data() + start_[node], cells_.data() + start_[node + 1]};
  }
  std::size_t bytes() const { return (start_.size() + cells_.size()) * sizeof(Index); }

 private:
  std::vector<Index> start_;  // [nodes + 1]
  std::vector<Index> cells_;  // [sum of cells at the nodes]
};

/// [cell][k] the cell behind the face opposite to local node k, or `none` on the hull.
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
