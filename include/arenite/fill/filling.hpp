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

#include <arenite/core/cold.hpp>
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

#if ARENITE_HAS_COLD

#include <algorithm>
#include <cmath>

namespace arenite::inline ARENITE_INSTRUCTION_SET {

ARENITE_COLD void FillOptions::check() const {
  require(!per_cell || *per_cell >= 1, "FillOptions.per_cell", per_cell.value_or(0), "must be at least 1");
  require(jitter >= 0 && jitter <= 1, "FillOptions.jitter", jitter, "must lie in [0, 1]");
}

ARENITE_COLD void detail::refuse_cells_of_grid(const std::string& name) {
  throw error(joined_text({"Cells = ", name, ": a grid has no regions; they go with simplices"}));
}

ARENITE_COLD std::size_t history_place(std::span<const std::string_view> names, const std::string& name) {
  std::string known;
  for (const std::string_view one : names) {
    if (one.empty()) continue;
    if (!known.empty()) known += ", ";
    known += one;
  }
  std::size_t k = 0;
  while (k < names.size() && names[k] != name) ++k;
  require(!name.empty() && k < names.size(), "FillOptions.history", name,
          known.empty() ? "the law's history has no member with a name"
                        : joined_text({"must be one of: ", known}));
  return k;
}

template <class T, int D>
ARENITE_COLD Filling<T, D>::Filling(const FillOptions& options, const AnyRegion& region, double density,
                                    const Ground& ground, bool simplices, T (*thickness)(const Point&))
    : options_{options}, region_{region}, density_{density}, thickness_{thickness} {
  if (options.velocity.is_uniform()) options.velocity.at<T, D>(zeros<Point>());
  require(!options.even || !simplices, "FillOptions.even", options.even, "goes with a grid alone");
  options.check();
  require(!options.exact_volume || !region.by_centres, "FillOptions.exact_volume", options.exact_volume,
          "goes with shapes and signed distances, not with a test of positions of the host");
  if (options.stress) stress_ = options.stress->in(ground, density);
}

template <class T, int D>
ARENITE_COLD void Filling<T, D>::add_cell(Index cell, T volume, const Places<Point>& initial,
                                          const std::vector<CellPart>& parts) {
  const T share = volume / static_cast<T>(initial.size());
  const auto cell_volume = static_cast<double>(volume);
  for (std::size_t p = 0; p < initial.size(); ++p) {
    const Point& x = initial[p];
    if (!parts.empty() && parts[p].share > 0) {
      const double of_part =
          parts[p].share * static_cast<double>(share * thickness_(in_scene<D, T>(parts[p].centre)));
      region_volume += of_part;
      if (options_.exact_volume && !parts[p].whole)
        places_.push_back({parts[p].centre, of_part, cell, cell_volume, parts[p].share < 0.1});
    }
    if (options_.exact_volume && !parts.empty() ? !parts[p].whole : region_.test && !region_.contains(x))
      continue;
    places_.push_back({in_space(x), static_cast<double>(share * thickness_(x)), cell, cell_volume});
    if (parts.empty()) region_volume += places_.back().volume;
  }
}

template <class T, int D>
ARENITE_COLD void Filling<T, D>::join_slivers(const std::function<Index(const SpacePosition&, Index)>& walk) {
  using detail::distance_between;
  for (auto& little : places_) {
    if (!little.sliver) continue;
    detail::FillPlace* nearest = nullptr;
    const auto look = [&](Index cell) {
      auto other = std::lower_bound(places_.begin(), places_.end(), cell,
                                    [](const detail::FillPlace& place, Index c) { return place.cell < c; });
      for (; other != places_.end() && other->cell == cell; ++other)
        if (!other->sliver && (!nearest || distance_between(other->position, little.position) <
                                               distance_between(nearest->position, little.position)))
          nearest = &*other;
    };
    look(little.cell);
    for (std::size_t k = 0; k < D; ++k)
      for (const int side : {-1, 1}) {
        SpacePosition beside = little.position;
        beside[k] += side * std::pow(little.cell_volume, 1.0 / D) / 2;
        if (const Index cell = walk(beside, little.cell); cell != none && cell != little.cell) look(cell);
      }
    if (!nearest) continue;
    const double both = nearest->volume + little.volume;
    SpacePosition middle{};
    for (std::size_t k = 0; k < D; ++k)
      middle[k] = (nearest->volume * nearest->position[k] + little.volume * little.position[k]) / both;
    if (walk(middle, nearest->cell) == nearest->cell) nearest->position = middle;
    nearest->volume = both;
    little.volume = 0;
  }
  std::erase_if(places_, [](const detail::FillPlace& place) { return place.volume == 0; });
}

template <class T, int D>
ARENITE_COLD const std::vector<FillPoint<T, D>>& Filling<T, D>::points(bool with_gradients) {
  points_.clear();
  for (const auto& place : places_) {
    FillPoint<T, D> point;
    point.position = in_scene<D, T>(place.position);
    point.velocity = options_.velocity.at(point.position);
    if (with_gradients)
      point.gradient = options_.velocity.gradient(point.position, std::pow(place.cell_volume, 1.0 / D));
    point.volume = static_cast<T>(place.volume);
    point.mass = static_cast<T>(density_) * point.volume;
    if (stress_) point.stress = stress_->at(point.position);
    point.cell = place.cell;
    initial_volume += static_cast<double>(point.volume);
    points_.push_back(point);
  }
  places_.clear();
  return points_;
}

#define ARENITE_INSTANCES(T, D) template class Filling<T, D>;
ARENITE_FOR_NUMBERS_AND_DIMENSIONS(ARENITE_INSTANCES)
#undef ARENITE_INSTANCES

}  // namespace arenite::inline ARENITE_INSTRUCTION_SET

#endif  // ARENITE_HAS_COLD
