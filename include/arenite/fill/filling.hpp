// Filling: makes the points of a fill as plain values, independent of the mesh and the law.
#pragma once
// SPDX-License-Identifier: BSD-3-Clause

#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <arenite/core/map.hpp>
#include <arenite/fill/cell_parts.hpp>
#include <arenite/fill/initial_stress.hpp>
#include <arenite/fill/initial_velocity.hpp>
#include <arenite/fill/region.hpp>
#include <arenite/mesh/mesh.hpp>

namespace arenite::inline ARENITE_INSTRUCTION_SET {

/// How `fill` makes points. Values are checked when the scene is made, which throws `error`.
struct FillOptions {
  /// Points a cell, -, >= 1; on a grid a square or cube; none: 4, in the cells of a grid in space 8.
  std::optional<int> per_cell{};
  InitialVelocity velocity{};             ///< at the start, m/s
  std::optional<InitialStress> stress{};  ///< at the start, Pa; none: unstressed
  bool may_be_empty = false;              ///< a region without points is no mistake: some come later
  /// Initial values of the law's history; those not named begin as the law says. By name, as functions of the
  /// position (x, y, z = 0 in two dimensions), m.
  Map<std::string, std::function<double(const std::array<double, 3>&)>> history{};
  /// Share of its sub-cell within which each point is moved at random, -, in [0, 1]. Points moved out of the
  /// region are omitted, points moved into it are included (`jitter_points`).
  double jitter = 0;
  std::uint64_t seed = 0;  ///< of the jitter, -, >= 0
  /// Equal spacing along all axes, in cells of unequal edges. About `per_cell` points a cell then lie evenly
  /// where the matter flows into other cells.
  bool even = false;
  /// Points represent the part of their sub-cells in the region. They lie in the middle of that part, and the
  /// mass is that of the region. Otherwise a point represents its whole sub-cell, if the middle of the
  /// sub-cell lies in the region.
  bool exact_volume = false;

  /// `per_cell` in a mesh.
  template <class M>
  int points_in_cell() const {
    return per_cell.value_or(is_simplex_mesh<M> || M::dimension == 2 ? 4 : 8);
  }
  /// Throws `error` for an invalid value.
  void check() const;
};

namespace detail {

[[noreturn]] void refuse_cells_of_grid(const std::string& name);

}  // namespace detail

/// Numbers of the regions of a simplex mesh that a region names. Throws `error` for a name that the mesh does
/// not have: of a grid for any.
template <class M>
std::vector<int> region_numbers([[maybe_unused]] const M& mesh, const AnyRegion& region) {
  std::vector<int> numbers;
  for (const auto& name : region.cells) {
    if constexpr (is_simplex_mesh<M>)
      for (const int number : mesh.region_numbers(name)) numbers.push_back(number);
    else
      detail::refuse_cells_of_grid(name);
  }
  return numbers;
}

namespace detail {

/// Where a fill puts a point. Those of a cell follow each other, and cells are in order.
struct FillPlace {
  SpacePosition position;  // m
  double volume;           // m3
  Index cell;
  double cell_volume;   // m^D
  bool sliver = false;  // whether it represents less than a tenth of a sub-cell
};

}  // namespace detail

/// A point that a fill makes.
template <class T, int D>
struct FillPoint {
  Vec<T, D> position, velocity;  // m, m/s
  Mat<T, D> gradient;            // of the velocity, 1/s; only where it is asked for
  T mass, volume;                // kg, m3
  Sym<T, D> stress;              // Pa
  Index cell;
};

/// Makes the points of a fill, cell by cell: `add_cell`, then `points`.
template <class T, int D>
class Filling {
 public:
  using Point = Vec<T, D>;

  /// `thickness`: of the kinematics. Keeps references to options and region. Throws `error` for invalid
  /// options.
  Filling(const FillOptions& options, const AnyRegion& region, double density, const Ground& ground,
          bool simplices, T (*thickness)(const Point&));

  /// Adds those of the initial points of a cell that are to be filled.
  void add_cell(Index cell, T volume, const Places<Point>& initial, const std::vector<CellPart>& parts);

  /// Merges slivers into the nearest place that is none, in their own cell or a cell next to it: a very light
  /// point as the only one of a cell would move nodes with hardly any mass. Volume and its centre are
  /// preserved. `walk`: finds the cell of a position, m, from a cell near it.
  void join_slivers(const std::function<Index(const SpacePosition&, Index)>& walk);

  /// The points of the cells since the last call.
  const std::vector<FillPoint<T, D>>& points(bool with_gradients);

  double initial_volume = 0, region_volume = 0;  // m3, see `Body`
  ClearBall clear{};

 private:
  const FillOptions& options_;
  const AnyRegion& region_;
  double density_;
  std::optional<InitialStress> stress_;
  T (*thickness_)(const Point&);
  std::vector<detail::FillPlace> places_{};
  std::vector<FillPoint<T, D>> points_{};
};

/// Place of a history's member, by name. Throws `error` if there is none.
std::size_t history_place(std::span<const std::string_view> names, const std::string& name);

}  // namespace arenite::inline ARENITE_INSTRUCTION_SET

#ifndef ARENITE_COLD_LIBRARY
#include <arenite/fill/filling_cold.hpp>
#endif
