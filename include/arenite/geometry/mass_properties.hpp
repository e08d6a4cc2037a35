// Mass, centre of mass and moments of inertia of uniform bodies: closed surfaces of triangles, polygons.
#pragma once
// SPDX-License-Identifier: BSD-3-Clause

#include <Eigen/LU>
#include <cmath>
#include <type_traits>

#include <arenite/core/error.hpp>
#include <arenite/core/tensor.hpp>
#include <arenite/geometry/polygon.hpp>
#include <arenite/geometry/triangle_data.hpp>

namespace arenite::inline ARENITE_INSTRUCTION_SET {

/// Of a body in space; of a plane one, for each metre of thickness.
template <int D>
struct MassProperties {
  double mass;            ///< kg
  Vec<double, D> centre;  ///< centre of mass, m
  /// Moments of inertia about the centre, kg m2: the tensor, integral of (|r|^2 I - r r^T) dm; in the plane
  /// the one about z.
  std::conditional_t<D == 2, double, Mat<double, 3>> inertia;
};

namespace detail {

/// Mass properties from the signed simplices between an origin and each facet, columns of a [D x D] matrix:
/// `for_each(f)` calls f with each. A simplex with one corner at the origin and edges A has the volume det A
/// / D!, and integral of r r^T = det A / (D + 2)! A (1 + 1 1^T) A^T (Tonon, J. Math. Stat. 1, 8, 2005).
template <int D, class ForEach>
MassProperties<D> sum_of_simplices(const Vec<double, D>& origin, double density, ForEach&& for_each) {
  double volume = 0;
  Vec<double, D> first = Vec<double, D>::Zero();
  Mat<double, D> second = Mat<double, D>::Zero();
  for_each([&](const Mat<double, D>& edges) {
    const double simplex = edges.determinant() / (D == 2 ? 2 : 6);
    const Vec<double, D> sum = edges.rowwise().sum();
    volume += simplex;
    first += simplex / (D + 1) * sum;
    second += simplex / ((D + 1) * (D + 2)) * (edges * edges.transpose() + sum * sum.transpose());
  });
  const Vec<double, D> arm = first / volume;
  const Mat<double, D> about_centre = density * (second - volume * arm * arm.transpose());
  MassProperties<D> p{density * volume, origin + arm, {}};
  if constexpr (D == 2)
    p.inertia = std::abs(about_centre.trace());
  else
    p.inertia = about_centre.trace() * Mat<double, 3>::Identity() - about_centre;
  return p;
}

}  // namespace detail

/// Of the inside of closed surfaces, exact but for round-off; `density` in kg/m3. The mass is negative if
/// triangles run clockwise as seen from outside.
inline MassProperties<3> mass_properties(const TriangleData& surface, double density = 1) {
  require(density > 0 && std::isfinite(density), "mass_properties: density", density, "must be positive");
  Vec<double, 3> origin = Vec<double, 3>::Zero();
  for (const auto& x : surface.vertices) origin += x / static_cast<double>(surface.vertices.size());
  return detail::sum_of_simplices<3>(origin, density, [&](auto&& add) {
    Mat<double, 3> edges;
    for (const auto& triangle : surface.triangles) {
      for (int k = 0; k < 3; ++k)
        edges.col(k) = surface.vertices[triangle[static_cast<std::size_t>(k)]] - origin;
      add(edges);
    }
  });
}

/// Of a polygon that does not cross itself, with corners in either sense; exact but for round-off.
inline MassProperties<2> mass_properties(const Polygon& polygon, double density = 1) {
  require(density > 0 && std::isfinite(density), "mass_properties: density", density, "must be positive");
  const auto& corners = polygon.corners();
  const auto at = [&](std::size_t i) { return Vec<double, 2>(corners[i][0], corners[i][1]); };
  const Vec<double, 2> origin = at(0);
  auto p = detail::sum_of_simplices<2>(origin, density, [&](auto&& add) {
    Mat<double, 2> edges;
    for (std::size_t i = 0, before = corners.size() - 1; i < corners.size(); before = i++) {
      edges.col(0) = at(before) - origin;
      edges.col(1) = at(i) - origin;
      add(edges);
    }
  });
  p.mass = std::abs(p.mass);
  return p;
}

}  // namespace arenite::inline ARENITE_INSTRUCTION_SET
