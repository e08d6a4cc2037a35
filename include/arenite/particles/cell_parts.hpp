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
  double share = 0;  ///< of the sub-cell, -
  V centre;          ///< of the part, m
  bool whole = false;
};

namespace detail {

/// The part of a small box of these edges about x that lies in a region, -, and its centre. By a signed
/// distance: of the plane at that distance, exact where it is parallel to a face, and the only one in the
/// box; else all or nothing.
template <class V>
std::pair<double, V> part_in_region(const AnyRegion& region, const V& x, const V& edges) {
  const V none = x;
  if (!region.distance) return {region.contains(x) ? 1.0 : 0.0, none};
  const double d = region.distance(in_space(x));
  if (std::abs(d) > edges.norm() / 2) return {d < 0 ? 1.0 : 0.0, none};
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

/// A ball without the boundary of a region in it, m.
template <int D>
struct ClearBall {
  Vec<double, D> centre = Vec<double, D>::Zero();
  double radius = 0;
};

/// Whether the boundary of a region may cut a cell. `clear` is the ball that the last distance showed: most
/// cells lie in it, and need no other.
template <class M>
bool may_cut(const M& mesh, Index cell, const AnyRegion& region, ClearBall<M::dimension>& clear) {
  constexpr int D = M::dimension;
  using V = Vec<double, D>;
  V centre = V::Zero();
  double radius = 0;
  if constexpr (is_simplex_mesh<M>) {
    for (const Index i : mesh.nodes(cell)) centre += mesh.position(i).template cast<double>() / (D + 1);
    for (const Index i : mesh.nodes(cell))
      radius = std::max(radius, (mesh.position(i).template cast<double>() - centre).norm());
  } else {
    const V edges = mesh.extent(cell).template cast<double>();
    centre = mesh.corner(cell).template cast<double>() + edges / 2;
    radius = edges.norm() / 2;
  }
  if (region.distance) {
    if ((centre - clear.centre).norm() + radius < clear.radius) return false;
    clear = {centre, std::abs(region.distance(in_space(centre)))};
    return !(clear.radius > radius);
  }
  const bool inside = region.contains(centre);
  bool differs = false;
  if constexpr (is_simplex_mesh<M>) {
    for (const Index i : mesh.nodes(cell)) differs = differs || region.contains(mesh.position(i)) != inside;
  } else {
    for (int corner = 0; corner < 1 << D; ++corner) {
      typename M::Point x = mesh.corner(cell);
      for (int k = 0; k < D; ++k)
        if (corner >> k & 1) x[k] += mesh.extent(cell)[k];
      differs = differs || region.contains(x) != inside;
    }
  }
  return differs;
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

/// The parts of the sub-cells of a cell that lie in a region, one for each of `places`; none if the region's
/// boundary does not cut the cell. On a grid they are those of the lattice with so many points `along` each
/// axis; in a simplex what lies nearest to a place. `clear`: of the cell before.
template <class M>
std::vector<CellPart<Vec<double, M::dimension>>> cell_parts(
    const M& mesh, Index cell, const AnyRegion& region, const std::vector<typename M::Point>& places,
    [[maybe_unused]] int per_cell, [[maybe_unused]] bool even, detail::ClearBall<M::dimension>& clear) {
  constexpr int D = M::dimension;
  using V = Vec<double, D>;
  std::vector<CellPart<V>> parts;
  if (!region.test || region.by_centres || !detail::may_cut(mesh, cell, region, clear)) return parts;
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
    for (std::size_t p = 0; p < places.size(); ++p) {
      const V middle = places[p].template cast<double>();
      if (region.distance && std::abs(region.distance(in_space(middle))) > edges.norm() / 2)
        add(p, middle, V(edges / finer));
      else
        for (const auto& s : fine)
          add(p, V(middle + (s - V::Constant(0.5)).cwiseProduct(edges)), V(edges / finer));
    }
  }
  for (std::size_t p = 0; p < parts.size(); ++p) {
    auto& part = parts[p];
    if (!(part.share > 1e-9 * samples[p])) {
      part.share = 0;
      continue;
    }
    part.centre = moment[p] / part.share;
    part.share /= samples[p];
    part.whole = part.share > 1 - 1e-9;
  }
  return parts;
}

}  // namespace arenite::inline ARENITE_INSTRUCTION_SET
