// Places of the initial points in a cell: equal weights, and as even as the cell's shape allows.
#pragma once
// SPDX-License-Identifier: BSD-3-Clause

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include <arenite/core/cold.hpp>
#include <arenite/core/error.hpp>
#include <arenite/mesh/mesh.hpp>
#include <arenite/parallel/array_memory.hpp>

namespace arenite::inline ARENITE_INSTRUCTION_SET {

/// Positions, with an allocator that gives functions of the list distinct names in units for other instruction sets.
template <class Point>
using Places = std::vector<Point, ArrayMemory<Point>>;

namespace detail {

/// Barycentric lattice of order k: k (k + 1) / 2 points in a triangle, k (k + 1)(k + 2) / 6 in a tetrahedron.
/// The inset of the outer points is such that equal weights integrate quadratics exactly (linear fields are
/// exact by symmetry).
template <int D>
Places<Vec<double, D + 1>> simplex_lattice(int k) {
  Places<Vec<double, D + 1>> points;
  for (int a = 0; a < k; ++a)
    for (int b = 0; a + b < k; ++b)
      for (int c = 0; c <= (D == 3 ? k - 1 - a - b : 0); ++c) {
        Vec<double, D + 1> p;
        p[0] = a;
        p[1] = b;
        if constexpr (D == 3) p[2] = c;
        p[D] = k - 1 - a - b - c;
        points.push_back(p);
      }
  // A coordinate b = centre + t (q - centre) with q = p / (k - 1) has mean 1/(D+1) for any t; the mean of b^2
  // over a simplex is 2 / ((D+1)(D+2)). Choose t to match it.
  const double centre = 1.0 / (D + 1);
  double spread = 0;
  for (auto& p : points) {
    if (k > 1) p /= k - 1;
    spread += (p[0] - centre) * (p[0] - centre);
  }
  spread /= static_cast<double>(points.size());
  const double wanted = 2.0 / ((D + 1) * (D + 2)) - centre * centre;
  const double t = k > 1 ? std::sqrt(wanted / spread) : 0;
  for (auto& p : points)
    for (int i = 0; i <= D; ++i) p[i] = centre + t * (p[i] - centre);
  return points;
}

/// Centroids of the k x k equal triangles into which a triangle is cut.
inline Places<Vec<double, 3>> triangle_centroids(int k) {
  Places<Vec<double, 3>> points;
  for (int a = 0; a < k; ++a)
    for (int b = 0; a + b < k; ++b) {
      const double u = (a + 1.0 / 3) / k, v = (b + 1.0 / 3) / k;
      points.emplace_back(1 - u - v, u, v);
      if (a + b + 1 < k) {
        const double s = (a + 2.0 / 3) / k, w = (b + 2.0 / 3) / k;
        points.emplace_back(1 - s - w, s, w);
      }
    }
  return points;
}

}  // namespace detail

/// Barycentric coordinates of n points of equal weight in a simplex. Triangles: n = 1, 3, 6, 10, 15, 21, 28
/// or a square; tetrahedra: n = 1, 4, 10, 20, 35. Throws `error` for another n.
template <int D>
Places<Vec<double, D + 1>> simplex_points(int n) {
  for (int k = 1; k < 8; ++k) {
    if (n == (D == 2 ? k * (k + 1) / 2 : k * (k + 1) * (k + 2) / 6)) return detail::simplex_lattice<D>(k);
    if constexpr (D == 2)
      if (n == k * k) return detail::triangle_centroids(k);
  }
  throw error(joined_text({"per_cell = ", n,
                           D == 2 ? ": must be 1, 3, 6, 10, 15, 21, 28 or the square of 1 to 7"
                                  : ": must be 1, 4, 10, 20, 35, 56 or 84"}));
}

/// Points along each axis of a lattice of n points; n must be a D-th power. Throws `error` otherwise.
template <int D>
std::array<int, static_cast<std::size_t>(D)> lattice_counts(int n);
/// Points along each axis of a grid cell with these edges, so that they are about as far apart along all axes:
/// about n in all, and, unless n = 1, two along each axis at least.
template <class T, int D>
std::array<int, static_cast<std::size_t>(D)> even_counts(int n, const Vec<T, D>& edges);

/// Positions in the unit cell [0, 1]^D of points on an even lattice, with the numbers `along` each axis.
template <std::size_t D>
Places<Vec<double, static_cast<int>(D)>> lattice_points(const std::array<int, D>& along) {
  int n = 1;
  for (const int k : along) n *= k;
  Places<Vec<double, static_cast<int>(D)>> points;
  for (int i = 0; i < n; ++i) {
    Vec<double, static_cast<int>(D)> x;
    int rest = i;
    for (std::size_t d = 0; d < D; ++d) {
      x[static_cast<int>(d)] = (rest % along[d] + 0.5) / along[d];
      rest /= along[d];
    }
    points.push_back(x);
  }
  return points;
}
template <int D>
Places<Vec<double, D>> lattice_points(int n) {
  return lattice_points(lattice_counts<D>(n));
}

/// A cell of a grid.
template <class T, int D>
struct CellBox {
  Vec<T, D> corner, extent;  // m
};
template <class M>
CellBox<typename M::scalar, M::dimension> cell_box(const M& mesh, Index cell) {
  return {mesh.corner(cell), mesh.extent(cell)};
}

/// Positions of the n initial points of a cell, m; `even`: about n, as given by `even_counts`.
template <class T, int D>
Places<Vec<T, D>> initial_points(const CellBox<T, D>& cell, int n, bool even);
template <class M>
Places<typename M::Point> initial_points(const M& mesh, Index cell, int n,
                                         [[maybe_unused]] bool even = false) {
  if constexpr (is_simplex_mesh<M>) {
    constexpr int D = M::dimension;
    Places<typename M::Point> points;
    for (const auto& b : simplex_points<D>(n)) {
      auto x = zeros<typename M::Point>();
      for (int k = 0; k <= D; ++k)
        x += static_cast<typename M::scalar>(b[k]) *
             mesh.position(mesh.nodes(cell)[static_cast<std::size_t>(k)]);
      points.push_back(x);
    }
    return points;
  } else {
    return initial_points(cell_box(mesh, cell), n, even);
  }
}

}  // namespace arenite::inline ARENITE_INSTRUCTION_SET

#if ARENITE_HAS_COLD

namespace arenite::inline ARENITE_INSTRUCTION_SET {

template <int D>
ARENITE_COLD std::array<int, static_cast<std::size_t>(D)> lattice_counts(int n) {
  const int k = static_cast<int>(std::lround(std::pow(n, 1.0 / D)));
  require(n >= 1 && (D == 2 ? k * k : k * k * k) == n, "per_cell", n,
          D == 2 ? "must be a square (1, 4, 9, ..)" : "must be a cube (1, 8, 27, ..)");
  std::array<int, static_cast<std::size_t>(D)> along;
  along.fill(k);
  return along;
}

template <class T, int D>
ARENITE_COLD std::array<int, static_cast<std::size_t>(D)> even_counts(int n, const Vec<T, D>& edges) {
  auto along = lattice_counts<D>(n);
  const double apart = std::pow(static_cast<double>(edges.prod()) / n, 1.0 / D);
  for (std::size_t k = 0; k < along.size(); ++k)
    along[k] =
        std::max(n > 1 ? 2 : 1,
                 static_cast<int>(std::lround(static_cast<double>(edges[static_cast<int>(k)]) / apart)));
  return along;
}

template <class T, int D>
ARENITE_COLD Places<Vec<T, D>> initial_points(const CellBox<T, D>& cell, int n, bool even) {
  Places<Vec<T, D>> points;
  for (const auto& s : lattice_points(even ? even_counts<T, D>(n, cell.extent) : lattice_counts<D>(n))) {
    Vec<T, D> x;
    for (int k = 0; k < D; ++k) x[k] = cell.corner[k] + cell.extent[k] * static_cast<T>(s[k]);
    points.push_back(x);
  }
  return points;
}

#define ARENITE_INSTANCES(D) template std::array<int, D> lattice_counts<D>(int);
ARENITE_FOR_DIMENSIONS(ARENITE_INSTANCES)
#undef ARENITE_INSTANCES

#define ARENITE_INSTANCES(T, D)                                   \
  template std::array<int, D> even_counts(int, const Vec<T, D>&); \
  template Places<Vec<T, D>> initial_points(const CellBox<T, D>&, int, bool);
ARENITE_FOR_NUMBERS_AND_DIMENSIONS(ARENITE_INSTANCES)
#undef ARENITE_INSTANCES

}  // namespace arenite::inline ARENITE_INSTRUCTION_SET

#endif  // ARENITE_HAS_COLD
