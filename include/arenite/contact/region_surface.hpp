// Surface of a region of a simplex mesh: the nodes shared with other regions, with unit normals out of it,
// and the nodes inside.
#pragma once
// SPDX-License-Identifier: BSD-3-Clause

#include <algorithm>
#include <limits>
#include <string>
#include <vector>

#include <arenite/boundary/constraints.hpp>
#include <arenite/mesh/kinematics.hpp>
#include <arenite/mesh/simplex_mesh.hpp>

namespace arenite::inline ARENITE_INSTRUCTION_SET {

/// Nodes of one region, split into surface and inside. Normals are those of the mesh at construction: right
/// as long as the region moves without rotating or changing its shape much.
template <class T, int D>
struct RegionSurface {
  std::vector<Index> nodes;  ///< on the surface, ascending
  std::vector<Vec<T, D>>
      normals;                ///< [nodes] unit normals out of the region, area-weighted means of the facets'
  std::vector<T> areas;       ///< [nodes] integrals of their shape functions over the surface, m2
  std::vector<Index> inside;  ///< nodes of the region that are not on its surface, ascending
  std::vector<T>
      volume_fraction;  ///< [nodes] fraction of the region's volume that belongs to each surface node
};

/// Facets on the hull of the mesh are no surface. Where walls constrain a node, its normal is projected onto
/// the free directions: on a symmetry plane or an axis it lies in it. Throws `error` if the region has no cells or
/// touches no other, or if walls fix all shared nodes along their normals, unless the mesh `is_part` of a larger one.
template <class K, int D, class T>
RegionSurface<T, D> surface_of(const SimplexMesh<D, T>& mesh, const std::string& region,
                               const std::vector<Constraint<T, D>>& constraints, bool is_part = false) {
  const auto numbers = mesh.region_numbers(region);
  std::vector<Vec<T, D>> sum(mesh.node_count(), Vec<T, D>::Zero());
  std::vector<T> volume(mesh.node_count(), T(0)), areas(volume);
  T total = 0;
  for (Index c = 0; c < mesh.cell_count(); ++c) {
    if (!mesh.is_in(c, numbers)) continue;
    const auto& nodes = mesh.nodes(c);
    typename SimplexMesh<D, T>::Point centre = Vec<T, D>::Zero();
    for (const Index i : nodes) centre += mesh.position(i) / T(D + 1);
    const T v = mesh.volume(c) * K::thickness(centre);
    total += v;
    const auto& inverse = mesh.frame(c).inverse;
    for (int k = 0; k <= D; ++k) {
      volume[nodes[static_cast<std::size_t>(k)]] += v / T(D + 1);
      const Index other = mesh.neighbour(c, k);
      if (other == none || mesh.is_in(other, numbers)) continue;
      Vec<T, D> gradient;
      if (k == 0)
        gradient = -inverse.colwise().sum().transpose();
      else
        gradient = inverse.row(k - 1).transpose();
      const Vec<T, D> area = -(T(D) * mesh.volume(c)) * gradient;  // out of the cell
      const T size = area.norm() / T(D * (D + 1));
      T around = 0;
      for (int j = 0; j <= D; ++j)
        if (j != k) around += K::thickness(mesh.position(nodes[static_cast<std::size_t>(j)]));
      for (int j = 0; j <= D; ++j) {
        if (j == k) continue;
        const Index i = nodes[static_cast<std::size_t>(j)];
        // Integral of the shape function times the (linear) thickness over the facet, up to a common factor.
        const T share = around + K::thickness(mesh.position(i));
        sum[i] += share * area;
        areas[i] += share * size;
      }
    }
  }
  RegionSurface<T, D> surface;
  std::vector<T> length;
  for (const auto& s : sum) length.push_back(s.norm());
  constexpr T round_off =
      64 * std::numeric_limits<T>::epsilon();  // of what a wall leaves of a normal along its own
  for (const auto& c : constraints) sum[c.node] = c.projector * sum[c.node];
  for (Index i = 0; i < mesh.node_count(); ++i) {
    if (sum[i].norm() > round_off * length[i]) {
      surface.nodes.push_back(i);
      surface.normals.push_back(sum[i].normalized());
      surface.areas.push_back(areas[i]);
      surface.volume_fraction.push_back(volume[i] / total);
    } else if (volume[i] > 0) {
      surface.inside.push_back(i);
    }
  }
  require(
      !surface.nodes.empty() || is_part, "surface of region", region,
      !(total > 0) ? "must have cells of the mesh"
      : std::ranges::all_of(length, [](T l) { return l == 0; })
          ? "must meet another region of the mesh"
          : "walls hold all of its nodes along their normals; one at least must be free to move along it");
  return surface;
}

}  // namespace arenite::inline ARENITE_INSTRUCTION_SET
