// Checks that triangles form a closed surface with a known outside, and finds neighbours across the edges.
#pragma once
// SPDX-License-Identifier: BSD-3-Clause

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

#include <arenite/core/error.hpp>
#include <arenite/geometry/triangle_data.hpp>

namespace arenite::inline ARENITE_INSTRUCTION_SET {

/// The neighbours of triangles that form closed surfaces. Edge k of a triangle goes from its corner k to
/// corner k + 1.
class ClosedTriangles {
 public:
  /// The edge of a triangle.
  struct Edge {
    Index triangle;
    Index k;
  };

  /// Throws `error`, with the edge, unless each edge belongs to two triangles that run along it in opposite
  /// senses; with the vertex or triangle, unless vertices are finite and triangles have an area.
  explicit ClosedTriangles(const TriangleData& data) {
    require(data.triangles.size() >= 4, "TriangleSurface.triangles", data.triangles.size(),
            "must be at least four");
    require(data.triangles.size() < none / 3, "TriangleSurface.triangles", data.triangles.size(),
            "must be fewer than 2^32 / 3");
    for (std::size_t i = 0; i < data.vertices.size(); ++i)
      require(data.vertices[i].allFinite(), {"TriangleSurface.vertices[", i, "]"},
              vector_text(data.vertices[i]), "must be finite");
    for (std::size_t t = 0; t < data.triangles.size(); ++t) check_area(data, t);
    pair_edges(data);
  }

  /// The other triangle at edge k of a triangle, and the number of the edge there.
  const Edge& across(Index triangle, std::size_t k) const { return across_[triangle][k]; }

 private:
  struct Side {
    Index low, high;  // vertices
    Index triangle, k;
    bool rises;  // from low to high
  };

  static std::string name_of(std::size_t triangle) {
    return joined_text({"TriangleSurface.triangles[", triangle, "]"});
  }

  static void check_area(const TriangleData& data, std::size_t t) {
    for (const Index i : data.triangles[t])
      require(i < data.vertices.size(), name_of(t), i, "must be a vertex");
    const auto& [a, b, c] = data.triangles[t];
    const Vec<double, 3> ab = data.vertices[b] - data.vertices[a], ac = data.vertices[c] - data.vertices[a];
    const double longest2 = std::max({ab.squaredNorm(), ac.squaredNorm(), (ac - ab).squaredNorm()});
    const double area = ab.cross(ac).norm() / 2;
    require(area > 1e-12 * longest2, {name_of(t), ".area"}, area, "a triangle must not be flat");
  }

  void pair_edges(const TriangleData& data) {
    std::vector<Side> sides;
    sides.reserve(3 * data.triangles.size());
    for (std::size_t t = 0; t < data.triangles.size(); ++t)
      for (std::size_t k = 0; k < 3; ++k) {
        const Index from = data.triangles[t][k], to = data.triangles[t][(k + 1) % 3];
        sides.push_back({std::min(from, to), std::max(from, to), static_cast<Index>(t), static_cast<Index>(k),
                         from < to});
      }
    std::ranges::sort(sides, [](const Side& a, const Side& b) {
      return std::array{a.low, a.high, a.triangle, a.k} < std::array{b.low, b.high, b.triangle, b.k};
    });
    across_.resize(data.triangles.size());
    for (std::size_t i = 0; i < sides.size();) {
      std::size_t end = i + 1;
      while (end < sides.size() && sides[end].low == sides[i].low && sides[end].high == sides[i].high) ++end;
      const Side &a = sides[i], &b = sides[std::min(i + 1, end - 1)];
      const auto check = [&](bool holds, const std::string& rule) {
        if (!holds)
          require(
              false, {name_of(a.triangle), ", edge"},
              joined_text({vector_text(data.vertices[a.low]), " to ", vector_text(data.vertices[a.high])}),
              rule);
      };
      if (end - i == 1) check(false, open_surface(sides));
      check(end - i == 2, joined_text({"belongs to ", end - i, " triangles; it must belong to two"}));
      check(a.rises != b.rises,
            joined_text({"triangle ", b.triangle, " runs along it in the same sense; all triangles must run ",
                         "counter-clockwise as seen from outside"}));
      across_[a.triangle][a.k] = {b.triangle, b.k};
      across_[b.triangle][b.k] = {a.triangle, a.k};
      i = end;
    }
  }

  /// Message for sides that have no other.
  static std::string open_surface(const std::vector<Side>& sides) {
    std::size_t alone = 0;
    const auto same = [&](std::size_t a, std::size_t b) {
      return b < sides.size() && sides[a].low == sides[b].low && sides[a].high == sides[b].high;
    };
    for (std::size_t i = 0; i < sides.size(); ++i) alone += !same(i, i + 1) && (i == 0 || !same(i - 1, i));
    return joined_text(
        {"belongs to this triangle alone, one of ", alone,
         " such edges: an open surface, as of terrain, is no body, which has an inside. Close it "
         "(terrain: by sides and a bottom, where it comes from), or describe its height by a test "
         "of positions (fill) or a signed distance (rigid)"});
  }

  std::vector<std::array<Edge, 3>> across_;  // [triangles]
};

}  // namespace arenite::inline ARENITE_INSTRUCTION_SET
