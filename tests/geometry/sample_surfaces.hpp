// Closed surfaces for the tests: a box, a tetrahedron, a ball of subdivided triangles, a torus.
#pragma once

#include <arenite/core/units.hpp>
#include <arenite/geometry/triangle_data.hpp>
#include <cmath>
#include <map>
#include <utility>

namespace arenite::test {

/// The box from `a` to `b`.
inline TriangleData box_surface(const Vec<double, 3>& a, const Vec<double, 3>& b) {
  TriangleData data;
  for (int i = 0; i < 8; ++i)
    data.vertices.emplace_back((i & 1 ? b : a)[0], (i & 2 ? b : a)[1], (i & 4 ? b : a)[2]);
  data.triangles = {{0, 2, 3}, {0, 3, 1}, {4, 5, 7}, {4, 7, 6}, {0, 1, 5}, {0, 5, 4},
                    {2, 6, 7}, {2, 7, 3}, {0, 4, 6}, {0, 6, 2}, {1, 3, 7}, {1, 7, 5}};
  return data;
}

inline TriangleData tetrahedron_surface() {
  return {{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {0, 3, 2}}};
}

/// An octahedron whose triangles are divided into four `levels` times, vertices on the unit sphere.
inline TriangleData ball_surface(int levels) {
  TriangleData data{{{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}},
                    {{0, 2, 4}, {2, 1, 4}, {1, 3, 4}, {3, 0, 4}, {2, 0, 5}, {1, 2, 5}, {3, 1, 5}, {0, 3, 5}}};
  for (int level = 0; level < levels; ++level) {
    std::map<std::pair<Index, Index>, Index> middles;
    const auto middle = [&](Index a, Index b) {
      const auto [at, fresh] =
          middles.try_emplace(std::minmax(a, b), static_cast<Index>(data.vertices.size()));
      if (fresh) data.vertices.push_back((data.vertices[a] + data.vertices[b]).normalized());
      return at->second;
    };
    std::vector<std::array<Index, 3>> finer;
    for (const auto& [a, b, c] : data.triangles) {
      const Index ab = middle(a, b), bc = middle(b, c), ca = middle(c, a);
      finer.insert(finer.end(), {{a, ab, ca}, {ab, b, bc}, {ca, bc, c}, {ab, bc, ca}});
    }
    data.triangles = std::move(finer);
  }
  return data;
}

/// A ring about z of n x m rectangles, mean radius 1 and tube radius r.
inline TriangleData torus_surface(Index n, Index m, double r) {
  TriangleData data;
  for (Index i = 0; i < n; ++i)
    for (Index j = 0; j < m; ++j) {
      const double u = 2 * pi * i / n, v = 2 * pi * j / m, radius = 1 + r * std::cos(v);
      data.vertices.emplace_back(radius * std::cos(u), radius * std::sin(u), r * std::sin(v));
      const Index a = i * m + j, b = (i + 1) % n * m + j, up = (j + 1) % m - j;
      data.triangles.push_back({a, b, b + up});
      data.triangles.push_back({a, b + up, a + up});
    }
  return data;
}

}  // namespace arenite::test
