// Simplex meshes of boxes: the simplest meshes there are, and what others are bent from.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

#include <arenite/core/error.hpp>
#include <arenite/mesh/mesh_data.hpp>

namespace arenite {

/// A box and the number of bricks along each of its axes.
template <int D>
struct BoxMesh {
  std::array<double, static_cast<std::size_t>(D)> lower, upper;  ///< corners, m
  std::array<Index, static_cast<std::size_t>(D)> bricks;         ///< along each axis, at least 1
};

/// Triangles (D = 2) or tetrahedra (D = 3) that fill a box: each brick is cut into D! of them, whose numbers
/// follow each other; bricks and nodes are numbered along x first, then y, then z. In the plane the diagonals
/// of neighbours alternate, so that no direction is preferred; in space all tetrahedra of a brick share its
/// diagonal (Kuhn 1960, Some combinatorial lemmas in topology). The region is called "all", the node sets on
/// the faces left and right (x), bottom and top (y), front and back (z).
/// Throws `error` if the box is empty or a number of bricks is zero.
template <int D>
MeshData<D> box_mesh(const BoxMesh<D>& box) {
  static_assert(D == 2 || D == 3, "box_mesh: two or three dimensions");
  constexpr auto dim = static_cast<std::size_t>(D);
  using Place = std::array<Index, dim>;
  constexpr std::array<const char*, 6> names{"left", "right", "bottom", "top", "front", "back"};
  const auto count_up = [](Place& at, const Place& end) {  // to the next place, x first
    for (std::size_t k = 0; k < dim; ++k) {
      if (++at[k] < end[k]) return true;
      at[k] = 0;
    }
    return false;
  };
  Place nodes = box.bricks;
  for (std::size_t k = 0; k < dim; ++k) {
    require(box.bricks[k] > 0, "BoxMesh.bricks", box.bricks[k], "must be at least 1");
    require(box.upper[k] > box.lower[k] && std::isfinite(box.upper[k] - box.lower[k]), "BoxMesh.upper",
            box.upper[k], shared_detail::join("must lie above lower = ", box.lower[k]));
    ++nodes[k];
  }
  const auto number = [&](const Place& at) {
    Index n = 0;
    for (std::size_t k = dim; k-- > 0;) n = n * nodes[k] + at[k];
    return n;
  };

  MeshData<D> data;
  data.region_names["all"] = 0;
  Place at{};
  do {
    const auto node = static_cast<Index>(data.nodes.size());
    auto& x = data.nodes.emplace_back();
    for (std::size_t k = 0; k < dim; ++k) {
      x[static_cast<int>(k)] = box.lower[k] + (box.upper[k] - box.lower[k]) * at[k] / box.bricks[k];
      if (at[k] == 0) data.node_sets[names[2 * k]].push_back(node);
      if (at[k] == box.bricks[k]) data.node_sets[names[2 * k + 1]].push_back(node);
    }
  } while (count_up(at, nodes));

  Place brick{};
  do {
    if constexpr (D == 2) {
      const Index a = number(brick), b = a + 1, c = b + nodes[0], d = a + nodes[0];
      if ((brick[0] + brick[1]) % 2 == 0)
        data.cells.insert(data.cells.end(), {{a, b, c}, {a, c, d}});
      else
        data.cells.insert(data.cells.end(), {{a, b, d}, {b, c, d}});
    } else {
      std::array<std::size_t, dim> order{0, 1, 2};  // of the axes along which a tetrahedron walks the brick
      do {
        Place corner = brick;
        std::array<Index, dim + 1> cell{number(corner)};
        for (std::size_t s = 0; s < dim; ++s) {
          ++corner[order[s]];
          cell[s + 1] = number(corner);
        }
        data.cells.push_back(cell);
      } while (std::next_permutation(order.begin(), order.end()));
    }
  } while (count_up(brick, box.bricks));
  data.region.assign(data.cells.size(), 0);
  return data;
}

}  // namespace arenite
