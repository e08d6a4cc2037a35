// Simplex meshes of boxes: the simplest meshes there are, and what others are bent from.
#pragma once
// SPDX-License-Identifier: BSD-3-Clause

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <numeric>
#include <vector>

#include <arenite/core/error.hpp>
#include <arenite/mesh/mesh_data.hpp>

namespace arenite::inline ARENITE_INSTRUCTION_SET {

/// A box and the number of bricks along each of its axes.
template <int D>
struct BoxMesh {
  std::array<double, static_cast<std::size_t>(D)> lower, upper;  ///< corners, m
  std::array<Index, static_cast<std::size_t>(D)> bricks;         ///< along each axis, at least 1
};

namespace detail {

/// The next place of a box of `end` places along each axis, x first; false after the last, which the first
/// follows.
template <std::size_t Dim>
bool next_place(std::array<Index, Dim>& at, const std::array<Index, Dim>& end) {
  for (std::size_t k = 0; k < Dim; ++k) {
    if (++at[k] < end[k]) return true;
    at[k] = 0;
  }
  return false;
}

/// Adds the triangles or tetrahedra of a brick; `number(place)` is a node's.
template <std::size_t Dim, class Number>
void cut_brick(const std::array<Index, Dim>& brick, Number&& number,
               std::vector<std::array<Index, Dim + 1>>& cells) {
  if constexpr (Dim == 2) {
    const auto [i, j] = brick;
    const Index a = number({i, j}), b = number({i + 1, j}), c = number({i + 1, j + 1}),
                d = number({i, j + 1});
    if ((i + j) % 2 == 0)
      cells.insert(cells.end(), {{a, b, c}, {a, c, d}});
    else
      cells.insert(cells.end(), {{a, b, d}, {b, c, d}});
  } else {
    std::array<std::size_t, Dim> order{0, 1, 2};  // of the axes along which a tetrahedron walks the brick
    do {
      auto corner = brick;
      std::array<Index, Dim + 1> cell{number(corner)};
      for (std::size_t s = 0; s < Dim; ++s) {
        ++corner[order[s]];
        cell[s + 1] = number(corner);
      }
      cells.push_back(cell);
    } while (std::next_permutation(order.begin(), order.end()));
  }
}

}  // namespace detail

/// Triangles (D = 2) or tetrahedra (D = 3) that fill a box: each brick is cut into D! of them, whose numbers
/// follow each other; bricks and nodes are numbered along x first, then y, then z. In the plane the diagonals
/// of neighbours alternate, so that no direction is preferred; in space all tetrahedra of a brick share its
/// diagonal (Kuhn 1960, Some combinatorial lemmas in topology). The region is called "all", the node sets on
/// the faces left and right (x), bottom and top (y), front and back (z).
/// Throws `error` if the box is empty, a number of bricks is zero, or the nodes are more than 2^32.
template <int D>
MeshData<D> box_mesh(const BoxMesh<D>& box) {
  static_assert(D == 2 || D == 3, "box_mesh: two or three dimensions");
  constexpr auto dim = static_cast<std::size_t>(D);
  using Place = std::array<Index, dim>;
  constexpr std::array<const char*, 6> names{"left", "right", "bottom", "top", "front", "back"};
  Place nodes = box.bricks;
  for (std::size_t k = 0; k < dim; ++k) {
    require(box.bricks[k] > 0, "BoxMesh.bricks", box.bricks[k], "must be at least 1");
    require(box.upper[k] > box.lower[k] && std::isfinite(box.upper[k] - box.lower[k]), "BoxMesh.upper",
            box.upper[k], {"must lie above lower = ", box.lower[k]});
    ++nodes[k];
  }
  const double total = std::accumulate(nodes.begin(), nodes.end(), 1.0, std::multiplies<>{});
  require(total < none, "BoxMesh.bricks", total, "nodes: must be fewer than 2^32");
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
  } while (detail::next_place(at, nodes));

  Place brick{};
  do detail::cut_brick(brick, number, data.cells);
  while (detail::next_place(brick, box.bricks));
  data.region.assign(data.cells.size(), 0);
  return data;
}

}  // namespace arenite::inline ARENITE_INSTRUCTION_SET
