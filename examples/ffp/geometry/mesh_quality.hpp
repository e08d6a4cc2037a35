// How good a mesh is: what decides the time step (altitudes) and the accuracy (angles, sizes).
#pragma once

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <map>
#include <string>

#include <arenite/core/scalar.hpp>
#include <arenite/mesh/mesh_data.hpp>

namespace arenite::ffp {

/// Figures of the cells of one region. Angles are the inner angles of triangles, or the dihedral ones of
/// tetrahedra.
struct RegionQuality {
  std::size_t cells = 0;
  double volume = 0;                                              ///< m^D
  double min_altitude = std::numeric_limits<double>::infinity();  ///< m
  double min_angle = std::numeric_limits<double>::infinity();     ///< rad
  double max_angle = 0;                                           ///< rad
  double mean_edge = 0;                                           ///< m, over all edges of all cells
  double min_volume = std::numeric_limits<double>::infinity();    ///< m^D; not positive: a cell is inside out
};

/// Figures by the name of the region. `y(node)` gives each node's height, so that a moved mesh can be judged
/// too.
template <int D, class Height>
std::map<std::string, RegionQuality> mesh_quality(const MeshData<D>& mesh, Height&& y) {
  using Corner = Eigen::Vector3d;
  std::map<int, RegionQuality> found;
  for (std::size_t c = 0; c < mesh.cells.size(); ++c) {
    auto& q = found[mesh.region[c]];
    std::array<Corner, D + 1> x;
    for (std::size_t k = 0; k < x.size(); ++k) {
      const auto& p = mesh.nodes[mesh.cells[c][k]];
      x[k] = {p[0], y(mesh.cells[c][k]), D == 3 ? p[D - 1] : 0};
    }
    const Corner normal = (x[1] - x[0]).cross(x[2] - x[0]);
    const double volume = D == 2 ? normal[2] / 2 : normal.dot(x[D] - x[0]) / 6;
    ++q.cells;
    q.volume += volume;
    q.min_volume = std::min(q.min_volume, volume);
    std::array<Corner, D + 1>
        gradient;  // of the shape functions: 1 / altitude long, normal to the opposite face
    for (std::size_t k = 0; k < x.size(); ++k) {
      const Corner &a = x[(k + 1) % x.size()], &b = x[(k + 2) % x.size()];
      Corner g =
          D == 2 ? Corner{b[1] - a[1], a[0] - b[0], 0} : Corner{(b - a).cross(x[(k + 3) % x.size()] - a)};
      g /= g.dot(x[k] - a);
      gradient[k] = g;
      q.min_altitude = std::min(q.min_altitude, 1 / g.norm());
    }
    for (std::size_t i = 0; i < x.size(); ++i)
      for (std::size_t k = 0; k < i; ++k) {
        q.mean_edge += (x[i] - x[k]).norm();
        const double cosine = -gradient[i].dot(gradient[k]) / (gradient[i].norm() * gradient[k].norm());
        const double angle = std::acos(std::clamp(cosine, -1.0, 1.0));
        q.min_angle = std::min(q.min_angle, angle);
        q.max_angle = std::max(q.max_angle, angle);
      }
  }
  std::map<std::string, RegionQuality> named;
  for (const auto& [name, number] : mesh.region_names)
    if (found.contains(number)) {
      auto& q = named[name] = found[number];
      q.mean_edge /= static_cast<double>(q.cells * (D == 2 ? 3 : 6));
    }
  return named;
}

/// Figures of the mesh as it stands.
template <int D>
std::map<std::string, RegionQuality> mesh_quality(const MeshData<D>& mesh) {
  return mesh_quality(mesh, [&](Index n) { return mesh.nodes[n][1]; });
}

}  // namespace arenite::ffp
