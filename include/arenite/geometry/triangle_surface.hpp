// Closed surface of triangles: the inside of an STL file, as region and as signed distance.
#pragma once
// SPDX-License-Identifier: BSD-3-Clause

#include <Eigen/Geometry>
#include <array>
#include <cmath>
#include <memory>
#include <utility>
#include <vector>

#include <arenite/core/error.hpp>
#include <arenite/core/tensor.hpp>
#include <arenite/geometry/box.hpp>
#include <arenite/geometry/closed_triangles.hpp>
#include <arenite/geometry/contact_segment.hpp>
#include <arenite/geometry/mass_properties.hpp>
#include <arenite/geometry/nearest_triangle.hpp>
#include <arenite/geometry/triangle_data.hpp>

namespace arenite::inline ARENITE_INSTRUCTION_SET {

/// The inside of closed surfaces of triangles, which may have cavities; they must not intersect themselves or
/// each other. The signed distance is exact: that to the nearest triangle, with the sign of the
/// angle-weighted normal there (Baerentzen and Aanaes, IEEE Trans. Vis. Comput. Graph. 11, 243, 2005). Its
/// cost grows with the logarithm of the number of triangles. Copies share the triangles.
class TriangleSurface {
 public:
  using Place = Vec<double, 3>;

  /// Throws `error` that names the edge, vertex or triangle unless the surface is closed and its triangles
  /// run counter-clockwise as seen from outside.
  explicit TriangleSurface(TriangleData data) : is_{std::make_shared<const Inner>(std::move(data))} {}

  double operator()(const Place& x) const {
    const auto found = is_->tree.nearest(x);
    const bool outside = is_->normals[found.triangle][found.place.feature].dot(x - found.place.at) >= 0;
    return outside ? std::sqrt(found.distance2) : -std::sqrt(found.distance2);
  }
  template <int Other>
  double operator()(const Vec<double, Other>& x) const = delete;  // in the plane: `Polygon`
  /// Whether the distance is negative, but for round-off; by the triangles that a ray from x crosses, which
  /// is cheaper. Surfaces that share triangles neither overlap there nor leave a gap.
  bool contains(const Place& x) const { return is_->box.contains(x) && is_->tree.crosses_odd(is_->data, x); }
  template <int Other>
  bool contains(const Vec<double, Other>& x) const = delete;

  Box<3> bounds() const { return is_->box; }
  /// Vertices, and edges that are not flat or concave.
  std::vector<ContactSegment> contact_segments() const {
    std::vector<ContactSegment> all;
    const auto& [vertices, triangles] = is_->data;
    const auto place = [](const Place& x) { return std::array<double, 3>{x[0], x[1], x[2]}; };
    for (const Place& x : vertices) all.push_back({place(x), place(x), 0});
    for (Index t = 0; t < triangles.size(); ++t)
      for (std::size_t k = 0; k < 3; ++k) {
        const auto& [other, side] = is_->neighbours.across(t, k);
        const Place &a = is_->corner(t, k), &b = is_->corner(t, (k + 1) % 3);
        const Place opposite = is_->corner(other, (side + 2) % 3) - a;
        if (t < other && is_->normals[t][6].dot(opposite) < -1e-9 * opposite.norm())
          all.push_back({place(a), place(b), 0});
      }
    return all;
  }
  const TriangleData& data() const { return is_->data; }

 private:
  /// [triangles][corners, edges, face] sums of normals weighted with angles; their lengths do not matter.
  using Normals = std::vector<std::array<Place, 7>>;

  struct Inner {
    TriangleData data;
    ClosedTriangles neighbours;
    TriangleTree tree;
    Normals normals;
    Box<3> box;

    explicit Inner(TriangleData d)
        : data{std::move(d)}, neighbours{data}, tree{data}, normals(data.triangles.size()) {
      const double volume = mass_properties(data).mass;
      require(volume > 0, "TriangleSurface.volume", volume,
              "must be positive: triangles must run counter-clockwise as seen from outside");
      Place lower = corner(0, 0), upper = lower;
      for (Index t = 0; t < normals.size(); ++t) {
        for (std::size_t k = 0; k < 3; ++k) {
          lower = lower.cwiseMin(corner(t, k));
          upper = upper.cwiseMax(corner(t, k));
        }
        normals[t][6] = (corner(t, 1) - corner(t, 0)).cross(corner(t, 2) - corner(t, 0)).normalized();
      }
      for (int k = 0; k < 3; ++k) {
        box.lower[static_cast<std::size_t>(k)] = lower[k];
        box.upper[static_cast<std::size_t>(k)] = upper[k];
      }
      for (Index t = 0; t < normals.size(); ++t)
        for (std::size_t k = 0; k < 3; ++k) {
          normals[t][3 + k] = normals[t][6] + normals[neighbours.across(t, k).triangle][6];
          normals[t][k] = around(t, k);
        }
    }

    const Place& corner(Index t, std::size_t k) const { return data.vertices[data.triangles[t][k]]; }

    /// Sum of the normals around a corner, each times its angle there. Surfaces that share only a vertex
    /// are summed separately.
    Place around(Index first, std::size_t k) const {
      Place sum = Place::Zero();
      Index t = first;
      do {
        const Place to = corner(t, (k + 1) % 3) - corner(t, k), from = corner(t, (k + 2) % 3) - corner(t, k);
        sum += std::atan2(to.cross(from).norm(), to.dot(from)) * normals[t][6];
        const auto& next = neighbours.across(t, (k + 2) % 3);
        t = next.triangle;
        k = next.k;
      } while (t != first);
      return sum;
    }
  };

  std::shared_ptr<const Inner> is_;
};

inline MassProperties<3> mass_properties(const TriangleSurface& surface, double density = 1) {
  return mass_properties(surface.data(), density);
}

}  // namespace arenite::inline ARENITE_INSTRUCTION_SET
