// Cell parts: how much of each sub-cell of a cell lies in a region whose boundary cuts it. In plain numbers, (x,
// y, z) with z = 0 in the plane, so that it is compiled once for all meshes.
#pragma once
// SPDX-License-Identifier: BSD-3-Clause

#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

#include <arenite/core/cold.hpp>
#include <arenite/fill/cell_points.hpp>
#include <arenite/fill/region.hpp>
#include <arenite/mesh/mesh.hpp>

namespace arenite::inline ARENITE_INSTRUCTION_SET {

/// The part of the sub-cell of a point that lies in a region.
struct CellPart {
  double share = 0;                ///< of the sub-cell, -
  std::array<double, 3> centre{};  ///< of the part, m
  bool whole = false;
};

using SpacePosition = AnyRegion::Position;

/// A ball without the boundary of a region in it, m.
struct ClearBall {
  SpacePosition centre{};
  double radius = 0;
};

namespace detail {

inline double distance_between(const SpacePosition& x, const SpacePosition& y) {
  const double a = x[0] - y[0], b = x[1] - y[1], c = x[2] - y[2];
  return std::sqrt(a * a + b * b + c * c);
}

/// Positions of the corners of a cell, m.
struct CellCorners {
  std::array<SpacePosition, 8> at{};
  std::size_t count = 0;
};

/// `cell_parts` of a simplex with these corners and volume, m^D.
template <int D>
std::vector<CellPart> simplex_parts(const CellCorners& corners, double volume, const AnyRegion& region,
                                    const std::vector<SpacePosition>& places, ClearBall& clear);

}  // namespace detail

/// The parts of the sub-cells of a cell that lie in a region, one for each of `places`; none if the region's
/// boundary does not cut the cell. On a grid they are those of the lattice of `per_cell` points; in a simplex
/// what lies nearest to a place. `clear`: of the cell before.
template <class T, int D>
std::vector<CellPart> cell_parts(const CellBox<T, D>& cell, const AnyRegion& region,
                                 const Places<Vec<T, D>>& places, int per_cell, bool even, ClearBall& clear);
template <class M>
std::vector<CellPart> cell_parts(const M& mesh, Index cell, const AnyRegion& region,
                                 const Places<typename M::Point>& places, [[maybe_unused]] int per_cell,
                                 [[maybe_unused]] bool even, ClearBall& clear) {
  if (!region.test || region.by_centres) return {};
  if constexpr (is_simplex_mesh<M>) {
    detail::CellCorners corners;
    for (const Index i : mesh.nodes(cell)) corners.at[corners.count++] = in_space(mesh.position(i));
    std::vector<SpacePosition> middles;
    for (const auto& x : places) middles.push_back(in_space(x));
    return detail::simplex_parts<M::dimension>(corners, static_cast<double>(mesh.volume(cell)), region,
                                               middles, clear);
  } else {
    return cell_parts(cell_box(mesh, cell), region, places, per_cell, even, clear);
  }
}

}  // namespace arenite::inline ARENITE_INSTRUCTION_SET

#if ARENITE_HAS_COLD

#include <algorithm>
#include <utility>

namespace arenite::inline ARENITE_INSTRUCTION_SET {
namespace detail {

/// The part of a small box of these edges about x that lies in a region, as its share and centre. By a signed
/// distance: of the plane at that distance, exact where it is parallel to a face, and the only one in the
/// box; else all or nothing.
ARENITE_COLD CellPart part_in_region(const AnyRegion& region, const SpacePosition& x,
                                     const SpacePosition& edges) {
  if (!region.distance) return {region.test(x) ? 1.0 : 0.0, x};
  const double d = region.distance(x);
  const CellPart all_or_nothing{d < 0 ? 1.0 : 0.0, x};
  if (std::abs(d) > distance_between(edges, {}) / 2) return all_or_nothing;
  SpacePosition slope{};
  double width = 0, squared = 0;  // of the box across the plane, in the distance's unit
  for (std::size_t k = 0; k < 3; ++k) {
    if (edges[k] == 0) continue;
    SpacePosition before = x, behind = x;
    before[k] -= edges[k] / 2;
    behind[k] += edges[k] / 2;
    slope[k] = (region.distance(behind) - region.distance(before)) / edges[k];
    width += std::abs(slope[k]) * edges[k];
    squared += slope[k] * slope[k];
  }
  if (!(std::abs(d) < width / 2)) return all_or_nothing;
  CellPart part{0.5 - d / width, x};
  for (std::size_t k = 0; k < 3; ++k) part.centre[k] -= slope[k] * (width * (1 - part.share) / (2 * squared));
  return part;
}

/// Whether the boundary of a region may cut a cell. `clear` is the ball that the last distance showed: most
/// cells lie in it, and need no other.
ARENITE_COLD bool may_cut(const CellCorners& corners, const AnyRegion& region, ClearBall& clear) {
  SpacePosition centre{};
  for (std::size_t c = 0; c < corners.count; ++c)
    for (std::size_t k = 0; k < 3; ++k) centre[k] += corners.at[c][k] / static_cast<double>(corners.count);
  if (region.distance) {
    double radius = 0;
    for (std::size_t c = 0; c < corners.count; ++c)
      radius = std::max(radius, distance_between(corners.at[c], centre));
    if (distance_between(centre, clear.centre) + radius < clear.radius) return false;
    clear = {centre, std::abs(region.distance(centre))};
    return !(clear.radius > radius);
  }
  const bool inside = region.test(centre);
  for (std::size_t c = 0; c < corners.count; ++c)
    if (region.test(corners.at[c]) != inside) return true;
  return false;
}

/// Sums the parts of small boxes of equal volume to those of sub-cells.
class PartSums {
 public:
  PartSums(const AnyRegion& region, std::size_t sub_cells)
      : region_{region}, parts_(sub_cells), boxes_(sub_cells) {}

  /// Adds the box of these edges about x, m, to a sub-cell.
  void add(std::size_t sub_cell, const SpacePosition& x, const SpacePosition& edges) {
    const CellPart box = part_in_region(region_, x, edges);
    CellPart& part = parts_[sub_cell];
    part.share += box.share;
    for (std::size_t k = 0; k < 3; ++k) part.centre[k] += box.share * box.centre[k];
    ++boxes_[sub_cell];
  }
  /// Adds a sub-cell of these edges about x, m, cut into boxes where the boundary may cut it.
  void add_cut(std::size_t sub_cell, const SpacePosition& x, const SpacePosition& edges) {
    const std::size_t dimensions = edges[2] == 0 ? 2 : 3;
    const int along = (dimensions == 2 ? 4 : 2) * (region_.distance ? 1 : 2);
    SpacePosition little = edges;
    for (double& e : little) e /= along;
    if (region_.distance && std::abs(region_.distance(x)) > distance_between(edges, {}) / 2)
      return add(sub_cell, x, little);
    const int count = dimensions == 2 ? along * along : along * along * along;
    for (int box = 0; box < count; ++box) {
      SpacePosition at = x;
      int rest = box;
      for (std::size_t k = 0; k < dimensions; ++k, rest /= along)
        at[k] += ((rest % along + 0.5) / along - 0.5) * edges[k];
      add(sub_cell, at, little);
    }
  }

  std::vector<CellPart> parts() && {
    for (std::size_t p = 0; p < parts_.size(); ++p) {
      CellPart& part = parts_[p];
      if (!(part.share > 1e-9 * boxes_[p])) {
        part.share = 0;
        continue;
      }
      for (double& x : part.centre) x /= part.share;
      part.share /= boxes_[p];
      part.whole = part.share > 1 - 1e-9;
    }
    return std::move(parts_);
  }

 private:
  const AnyRegion& region_;
  std::vector<CellPart> parts_;
  std::vector<double> boxes_;
};

/// Barycentric coordinates of samples of equal weight in a simplex, several for each of `points` points.
template <int D>
Places<Vec<double, D + 1>> simplex_samples(std::size_t points) {
  const auto n = static_cast<double>(points);
  if constexpr (D == 2)
    return triangle_centroids(static_cast<int>(std::ceil(6 * std::sqrt(n))));
  else
    return simplex_lattice<D>(static_cast<int>(std::ceil(8 * std::cbrt(n))));
}

template <int D>
ARENITE_COLD std::vector<CellPart> simplex_parts(const CellCorners& corners, double volume,
                                                 const AnyRegion& region,
                                                 const std::vector<SpacePosition>& places, ClearBall& clear) {
  if (!may_cut(corners, region, clear)) return {};
  PartSums sums(region, places.size());
  const auto samples = simplex_samples<D>(places.size());
  const double edge = std::pow(volume / static_cast<double>(samples.size()), 1.0 / D);
  for (const auto& b : samples) {
    SpacePosition x{};
    for (std::size_t c = 0; c <= D; ++c)
      for (std::size_t k = 0; k < 3; ++k) x[k] += b[static_cast<int>(c)] * corners.at[c][k];
    std::size_t nearest = 0;
    double least = distance_between(places[0], x);
    for (std::size_t p = 1; p < places.size(); ++p)
      if (const double distance = distance_between(places[p], x); distance < least) {
        least = distance;
        nearest = p;
      }
    sums.add(nearest, x, {edge, edge, D == 3 ? edge : 0});
  }
  return std::move(sums).parts();
}

}  // namespace detail

template <class T, int D>
ARENITE_COLD std::vector<CellPart> cell_parts(const CellBox<T, D>& cell, const AnyRegion& region,
                                              const Places<Vec<T, D>>& places, int per_cell, bool even,
                                              ClearBall& clear) {
  const SpacePosition lower = in_space(cell.corner);
  SpacePosition edges = in_space(cell.extent);
  detail::CellCorners corners;
  corners.count = std::size_t{1} << D;
  for (std::size_t c = 0; c < corners.count; ++c)
    for (std::size_t k = 0; k < 3; ++k) corners.at[c][k] = lower[k] + (c >> k & 1 ? edges[k] : 0);
  if (!detail::may_cut(corners, region, clear)) return {};
  detail::PartSums sums(region, places.size());
  const auto along = even ? even_counts<T, D>(per_cell, cell.extent) : lattice_counts<D>(per_cell);
  for (std::size_t k = 0; k < D; ++k) edges[k] /= along[k];
  for (std::size_t p = 0; p < places.size(); ++p) sums.add_cut(p, in_space(places[p]), edges);
  return std::move(sums).parts();
}

#define ARENITE_INSTANCES(D)                               \
  template std::vector<CellPart> detail::simplex_parts<D>( \
      const detail::CellCorners&, double, const AnyRegion&, const std::vector<SpacePosition>&, ClearBall&);
ARENITE_FOR_DIMENSIONS(ARENITE_INSTANCES)
#undef ARENITE_INSTANCES

#define ARENITE_INSTANCES(T, D)                                                     \
  template std::vector<CellPart> cell_parts(const CellBox<T, D>&, const AnyRegion&, \
                                            const Places<Vec<T, D>>&, int, bool, ClearBall&);
ARENITE_FOR_NUMBERS_AND_DIMENSIONS(ARENITE_INSTANCES)
#undef ARENITE_INSTANCES

}  // namespace arenite::inline ARENITE_INSTRUCTION_SET

#endif  // ARENITE_HAS_COLD
