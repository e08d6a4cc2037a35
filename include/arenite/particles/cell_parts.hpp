// Cell parts: how much of each sub-cell of a cell lies in a region whose boundary cuts it.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

#include <arenite/mesh/mesh.hpp>
#include <arenite/particles/cell_points.hpp>
#include <arenite/particles/region.hpp>

namespace arenite::inline ARENITE_INSTRUCTION_SET {

/// The part of the sub-cell of a point that lies in a region.
template <class V>
struct CellPart {
  double share = 0;  ///< of the sub-cell, -; more than 1 if slivers beside it have joined
  V centre;          ///< of the part, m
  bool whole = false;
};

namespace detail {

/// The part of a small box of these edges about x that lies in a region, -, and its centre. By a signed
/// distance: of the plane at that distance, exact where it is parallel to a face; else all or nothing.
template <class V>
std::pair<double, V> part_in_region(const AnyRegion& region, const V& x, const V& edges) {
  const V none = x;
  if (!region.distance) return {region.contains(x) ? 1.0 : 0.0, none};
  const double d = region.distance(in_space(x));
  V slope;
  for (int k = 0; k < x.size(); ++k) {
    V before = x, behind = x;
    before[k] -= edges[k] / 2;
    behind[k] += edges[k] / 2;
    slope[k] = (region.distance(in_space(behind)) - region.distance(in_space(before))) / edges[k];
  }
  const double width = slope.cwiseAbs().dot(edges);  // of the box across the plane, in the distance's unit
  if (!(std::abs(d) < width / 2)) return {d < 0 ? 1.0 : 0.0, none};
  const double share = 0.5 - d / width;
  return {share, x - slope * (width * (1 - share) / (2 * slope.squaredNorm()))};
}

/// Whether the boundary of a region may cut a cell.
template <class M>
bool may_cut(const M& mesh, Index cell, const AnyRegion& region) {
  using V = Vec<double, M::dimension>;
  std::vector<V> corners;
  if constexpr (is_simplex_mesh<M>) {
    for (const Index i : mesh.nodes(cell)) corners.push_back(mesh.position(i).template cast<double>());
  } else {
    for (int corner = 0; corner < 1 << M::dimension; ++corner) {
      V x = mesh.corner(cell).template cast<double>();
      for (int k = 0; k < M::dimension; ++k)
        if (corner >> k & 1) x[k] += static_cast<double>(mesh.extent(cell)[k]);
      corners.push_back(x);
    }
  }
  V centre = V::Zero();
  for (const V& x : corners) centre += x / static_cast<double>(corners.size());
  if (!region.distance) {
    const bool inside = region.contains(centre);
    return std::ranges::any_of(corners, [&](const V& x) { return region.contains(x) != inside; });
  }
  double radius = 0;
  for (const V& x : corners) radius = std::max(radius, (x - centre).norm());
  return !(std::abs(region.distance(in_space(centre))) > radius);
}

/// Samples of equal weight in the simplex of a cell, m.
template <class M>
std::vector<Vec<double, M::dimension>> simplex_samples(const M& mesh, Index cell, std::size_t points) {
  constexpr int D = M::dimension;
  std::vector<Vec<double, D + 1>> places;
  if constexpr (D == 2)
    places = triangle_centroids(static_cast<int>(std::ceil(6 * std::sqrt(static_cast<double>(points)))));
  else
    places = simplex_lattice<D>(static_cast<int>(std::ceil(8 * std::cbrt(static_cast<double>(points)))));
  std::vector<Vec<double, D>> samples;
  for (const auto& b : places) {
    Vec<double, D> x = Vec<double, D>::Zero();
    for (int k = 0; k <= D; ++k)
      x += b[k] * mesh.position(mesh.nodes(cell)[static_cast<std::size_t>(k)]).template cast<double>();
    samples.push_back(x);
  }
  return samples;
}

}  // namespace detail

/// Below it the part of a sub-cell joins another one of its cell, -.
inline constexpr double least_cell_part = 0.1;

/// The parts of the sub-cells of a cell that lie in a region, one for each of `places`; none if the region's
/// boundary does not cut the cell. On a grid they are those of the lattice with so many points `along` each
/// axis; in a simplex what lies nearest to a place. Parts below `least_cell_part` join the nearest one that
/// is larger, so that their volume counts.
template <class M>
std::vector<CellPart<Vec<double, M::dimension>>> cell_parts(const M& mesh, Index cell,
                                                            const AnyRegion& region,
                                                            const std::vector<typename M::Point>& places,
                                                            [[maybe_unused]] int per_cell,
                                                            [[maybe_unused]] bool even) {
  constexpr int D = M::dimension;
  using V = Vec<double, D>;
  std::vector<CellPart<V>> parts;
  if (!region.test || region.by_centres || !detail::may_cut(mesh, cell, region)) return parts;
  std::vector<double> samples(places.size(), 0);
  std::vector<V> moment(places.size(), V::Zero());
  parts.resize(places.size());
  const auto add = [&](std::size_t p, const V& x, const V& edges) {
    const auto [share, centre] = detail::part_in_region(region, x, edges);
    parts[p].share += share;
    moment[p] += share * centre;
    ++samples[p];
  };
  if constexpr (is_simplex_mesh<M>) {
    const auto all = detail::simplex_samples(mesh, cell, places.size());
    const V edges = V::Constant(
        std::pow(static_cast<double>(mesh.volume(cell)) / static_cast<double>(all.size()), 1.0 / D));
    for (const V& x : all) {
      const auto nearest = std::ranges::min_element(
          places, {}, [&](const auto& place) { return (place.template cast<double>() - x).squaredNorm(); });
      add(static_cast<std::size_t>(nearest - places.begin()), x, edges);
    }
  } else {
    using T = typename M::scalar;
    const auto along = even ? even_counts<T, D>(per_cell, mesh.extent(cell)) : lattice_counts<D>(per_cell);
    V edges = mesh.extent(cell).template cast<double>();
    for (int k = 0; k < D; ++k) edges[k] /= along[static_cast<std::size_t>(k)];
    const int finer = (D == 2 ? 4 : 2) * (region.distance ? 1 : 2);
    std::array<int, static_cast<std::size_t>(D)> within;
    within.fill(finer);
    const auto fine = lattice_points(within);
    for (std::size_t p = 0; p < places.size(); ++p)
      for (const auto& s : fine)
        add(p, V(places[p].template cast<double>() + (s - V::Constant(0.5)).cwiseProduct(edges)),
            V(edges / finer));
  }
  std::size_t largest = 0;
  for (std::size_t p = 0; p < parts.size(); ++p) {
    auto& part = parts[p];
    if (samples[p] == 0) continue;
    if (part.share > 0) part.centre = moment[p] / part.share;
    part.share /= samples[p];
    part.whole = part.share > 1 - 1e-9;
    if (part.whole) part = {1, places[p].template cast<double>(), true};
    if (part.share < 1e-9) part.share = 0;
    if (part.share > parts[largest].share) largest = p;
  }
  for (std::size_t p = 0; p < parts.size(); ++p) {
    if (p == largest || parts[p].share == 0 || parts[p].share >= least_cell_part) continue;
    std::size_t to = largest;
    for (std::size_t q = 0; q < parts.size(); ++q)
      if (parts[q].share >= least_cell_part &&
          (parts[q].centre - parts[p].centre).norm() < (parts[to].centre - parts[p].centre).norm())
        to = q;
    auto& joined = parts[to];
    joined.centre =
        (joined.share * joined.centre + parts[p].share * parts[p].centre) / (joined.share + parts[p].share);
    joined.share += parts[p].share;
    joined.whole = false;
    parts[p].share = 0;
  }
  return parts;
}

}  // namespace arenite::inline ARENITE_INSTRUCTION_SET
