// Cell parts: how much of each sub-cell of a cell lies in a region whose boundary cuts it. In plain numbers, (x,
// y, z) with z = 0 in the plane, so that it is compiled once for all meshes.
#pragma once
// SPDX-License-Identifier: BSD-3-Clause

#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

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

#ifndef ARENITE_COLD_LIBRARY
#include <arenite/fill/cell_parts_cold.hpp>
#endif
