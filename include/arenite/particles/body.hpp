// Body: points that share a law, and the list of which cell holds which of them.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>

#include <arenite/core/map.hpp>
#include <arenite/core/name.hpp>
#include <arenite/kinematics/kinematics.hpp>
#include <arenite/law/roles.hpp>
#include <arenite/mesh/mesh.hpp>
#include <arenite/particles/cell_list.hpp>
#include <arenite/particles/cell_parts.hpp>
#include <arenite/particles/cell_points.hpp>
#include <arenite/particles/cell_sums.hpp>
#include <arenite/particles/initial_stress.hpp>
#include <arenite/particles/initial_velocity.hpp>
#include <arenite/particles/jitter.hpp>
#include <arenite/particles/points.hpp>
#include <arenite/particles/region.hpp>

namespace arenite::inline ARENITE_INSTRUCTION_SET {

/// How `fill` makes points. Values are checked when the scene is made, which throws `error`.
struct FillOptions {
  /// Points a cell; none: four, in the cells of a grid in space eight.
  std::optional<int> per_cell{};
  InitialVelocity velocity{};             ///< (x, y, z), m/s, or a function of the position
  std::optional<InitialStress> stress{};  ///< `Geostatic`, or a function of the position; none: unstressed
  bool may_be_empty = false;              ///< whether a region without points is no mistake: some come later
  /// Initial values of members of the law's history, by name, as functions of the position (x, y, z = 0 in
  /// two dimensions), m; those not named begin as the law says.
  Map<std::string, std::function<double(const std::array<double, 3>&)>> history{};
  /// Moves each point at random within this share, 0 to 1, of its sub-cell (`jitter_points`); those that it
  /// takes out of the region are left out, those that it takes into it are put in.
  double jitter = 0;
  std::uint64_t seed = 0;  ///< of the jitter
  /// On a grid with cells of unequal edges: about `per_cell`, but as far apart along all axes, so that they
  /// lie evenly where the matter flows into other cells.
  bool even = false;
  /// Whether a point stands for the part of its sub-cell that lies in the region, and lies in the middle of
  /// that part: so that the mass is that of the region. Otherwise it stands for all of its sub-cell, if the
  /// middle of the sub-cell lies in the region.
  bool exact_volume = false;

  /// `per_cell` in a mesh.
  template <class M>
  int points_in_cell() const {
    return per_cell.value_or(is_simplex_mesh<M> || M::dimension == 2 ? 4 : 8);
  }
  /// Throws `error` for a value that no scene bears.
  void check() const {
    require(!per_cell || *per_cell >= 1, "FillOptions.per_cell", per_cell.value_or(0), "must be at least 1");
    require(jitter >= 0 && jitter <= 1, "FillOptions.jitter", jitter, "must lie in [0, 1]");
  }
};

/// What `fill` returns: a region, a law and how to fill; the scene makes a `Body` of it, once it knows the
/// mesh. In the type of the scene only law and name remain: `Fill<MohrCoulomb<>>`.
template <class L, Name name = "", class Region = AnyRegion>
struct Fill {
  Region region;
  L law;
  FillOptions options;

  using Erased = Fill<L, name>;
  template <class M>
  Erased erased() const {
    if constexpr (std::same_as<Region, AnyRegion>) {
      return *this;
    } else {
      constexpr bool fits = region_type<Region, M::dimension>;
      static_assert(fits,
                    "fill: the region must provide contains(position) in the scene's dimension, or be Cells");
      static_assert(is_simplex_mesh<M> || !std::same_as<Region, Cells>,
                    "fill: Cells names regions of a simplex mesh; use a Box or Inside on a grid");
      if constexpr (fits)
        return {AnyRegion::of<M::dimension>(region), law, options};
      else
        return {AnyRegion{}, law, options};  // one sentence is enough
    }
  }
};

/// Fills a region with points of a law; `fill<"sand">(..)` gives the body a name. A region that catches no
/// point is refused when the scene is made.
template <Name name, class Region, class L>
Fill<L, name, Region> fill(Region region, L law, FillOptions options = {}) {
  return {std::move(region), std::move(law), options};
}
template <class Region, class L>
Fill<L, "", Region> fill(Region region, L law, FillOptions options = {}) {
  return {std::move(region), std::move(law), options};
}

/// Points of one law in a mesh over scalar T.
template <class L, real_scalar T, int D, ExtraColumns Extra = ExtraColumns{}>
struct Body {
  using Point = typename Points<T, D, L, Extra>::Point;
  static_assert(
      constitutive_law<L, T, D>,
      "Body: the law must provide History, density(), wave_modulus(), update(stress, step, history) "
      "where step is a StrainStep, and elastic_energy(stress) or elastic_energy(stress, history); see "
      "arenite/law/law.hpp");
  // Makes g++ 12 read the defaults of its members here; at `insert_points(scene, {{.position = ..}})` it
  // crashes.
  static_assert(noexcept(Point{}) || true);
  static_assert(check_law<L, T, D>());
  static constexpr bool has_dilation = Points<T, D, L, Extra>::has_dilation;
  static constexpr bool knows_opening = arenite::knows_opening<L, T>;
  L law;
  Points<T, D, L, Extra> points;
  CellList cells;
  std::size_t lost = 0;                  ///< points that left the mesh and were removed
  double lost_mass = 0;                  ///< their mass, kg
  double lost_kinetic = 0;               ///< their kinetic energy, J
  double lost_strain = 0;                ///< their recoverable energy, J
  double initial_volume = 0;             ///< m3
  double region_volume = 0;              ///< of the part of the mesh that was to be filled, m3
  double opened_volume = 0;              ///< voids that opened without stress, summed over all steps, m3
  PointTotals<D> inserted{}, removed{};  ///< by `insert_points` and `remove_points`
  bool finite = true;                    ///< sums over the points of the last step
  std::vector<CellList::Move> moves{};   ///< [points and unsorted points] scratch of `find_cells`
  std::vector<Index> move_count{};       ///< [blocks of cells] moves found in each
  /// Points in no cell of the mesh, from `find_cells` to `regroup`.
  std::vector<Index> outside{};
  bool moved = false;    ///< whether a point has another cell than the lists say, until `regroup`
  bool dropped = false;  ///< whether one has no cell any more
  std::vector<CellSums<T, D>> cell_sums{};  ///< [cells] from `p2g`; empty if the numerics need none
  /// [cells] sum of V times stress, N m, from `p2g`; empty unless stresses are centred
  std::vector<Sym<T, D>> cell_stress{};
};

/// Numbers of the regions of a simplex mesh that a region names. Throws `error` for a name that the mesh does
/// not have: of a grid for any.
template <class M>
std::vector<int> region_numbers([[maybe_unused]] const M& mesh, const AnyRegion& region) {
  std::vector<int> numbers;
  for (const auto& name : region.cells) {
    if constexpr (is_simplex_mesh<M>)
      numbers.push_back(mesh.region_number(name));
    else
      throw error(joined_text({"Cells = ", name, ": a grid has no regions; they go with simplices"}));
  }
  return numbers;
}

namespace detail {

/// Where a fill puts a point. Those of a cell follow each other, and cells are in order.
struct FillPlace {
  SpacePosition position;  // m
  double volume;           // m3
  Index cell;
  bool sliver = false;  // whether it stands for less than a tenth of a sub-cell
};

/// Lets slivers join the nearest place beside them that is none, in their own cell or a cell next to it: a
/// very light point in a cell of its own would lead nodes with hardly any mass. Volume and its centre are
/// kept. `walk`: finds the cell of a position, m, from a cell near it.
inline void join_slivers(std::vector<FillPlace>& places, std::size_t dimensions,
                         const std::function<double(Index)>& edge,
                         const std::function<Index(const SpacePosition&, Index)>& walk) {
  for (auto& small : places) {
    if (!small.sliver) continue;
    FillPlace* nearest = nullptr;
    const auto look = [&](Index cell) {
      auto other = std::lower_bound(places.begin(), places.end(), cell,
                                    [](const FillPlace& place, Index c) { return place.cell < c; });
      for (; other != places.end() && other->cell == cell; ++other)
        if (!other->sliver && (!nearest || distance_between(other->position, small.position) <
                                               distance_between(nearest->position, small.position)))
          nearest = &*other;
    };
    look(small.cell);
    for (std::size_t k = 0; k < dimensions; ++k)
      for (const int side : {-1, 1}) {
        SpacePosition beside = small.position;
        beside[k] += side * edge(small.cell) / 2;
        if (const Index cell = walk(beside, small.cell); cell != none && cell != small.cell) look(cell);
      }
    if (!nearest) continue;
    const double both = nearest->volume + small.volume;
    SpacePosition middle{};
    for (std::size_t k = 0; k < dimensions; ++k)
      middle[k] = (nearest->volume * nearest->position[k] + small.volume * small.position[k]) / both;
    if (walk(middle, nearest->cell) == nearest->cell) nearest->position = middle;
    nearest->volume = both;
    small.volume = 0;
  }
  std::erase_if(places, [](const FillPlace& place) { return place.volume == 0; });
}

/// Gives the points the initial values of `FillOptions::history`. Throws `error` for one that the law's
/// history has no member for, or that is not finite.
template <class L, class T, int D, ExtraColumns E>
void begin_history(Points<T, D, L, E>& points, const FillOptions& options) {
  constexpr auto& names = history_names<typename L::template History<T>>;
  std::string known;
  for (const std::string_view name : names)
    if (!name.empty()) known += (known.empty() ? "" : ", ") + std::string(name);
  for (const auto& [name, value_at] : options.history) {
    const auto k = static_cast<std::size_t>(std::ranges::find(names, name) - names.begin());
    require(!name.empty() && k < names.size(), "FillOptions.history", name,
            known.empty() ? "the law's history has no member with a name"
                          : joined_text({"must be one of: ", known}));
    for (std::size_t p = 0; p < points.size(); ++p) {
      const double value = value_at(in_space<T, D>(points.position[p]));
      require(std::isfinite(value), {"FillOptions.history, ", name}, value, "must be finite");
      points.history[k][p] = static_cast<T>(value);
    }
  }
}

}  // namespace detail

/// Every cell may hold points: where a scene has its mesh to itself.
struct OwnsAllCells {
  static constexpr bool is_whole = true;
  constexpr bool operator()(Index) const { return true; }
};

/// Makes the body of a recipe, with points in the cells that `owns(cell)`; `ground`: of a geostatic stress.
/// Throws `error` if the region holds no point of the mesh, unless it may.
template <class K, ExtraColumns Extra = ExtraColumns{}, class M, class L, Name name,
          class Owns = OwnsAllCells>
auto make_body(const M& mesh, const Fill<L, name>& recipe, const Owns& owns = {}, const Ground& ground = {}) {
  using T = typename M::scalar;
  constexpr int D = M::dimension;
  Body<L, T, D, Extra> body{recipe.law, {}, {}};
  const FillOptions& o = recipe.options;
  if (o.velocity.is_uniform()) o.velocity.at<T, D>(Vec<T, D>::Zero());
  require(!o.even || !is_simplex_mesh<M>, "FillOptions.even", o.even, "goes with a grid alone");
  o.check();
  require(!o.exact_volume || !recipe.region.by_centres, "FillOptions.exact_volume", o.exact_volume,
          "goes with shapes and signed distances, not with a test of positions of the host");
  const int per_cell = o.points_in_cell<M>();
  const double density = recipe.law.density();
  std::optional<InitialStress> stress_at;
  if (o.stress) stress_at = o.stress->in(ground, density);
  const auto numbers = region_numbers(mesh, recipe.region);
  std::vector<detail::FillPlace> places;
  const auto point_at = [](const detail::SpacePosition& x) ->
      typename M::Point { return in_scene<D>(x).template cast<T>(); };
  const auto edge = [&](Index c) { return std::pow(static_cast<double>(mesh.volume(c)), 1.0 / D); };
  detail::ClearBall clear;
  const auto fill_places = [&] {
    for (const auto& place : places) {
      const typename M::Point x = point_at(place.position);
      const T volume = static_cast<T>(place.volume);
      const auto stress = stress_at ? stress_at->at(x) : Sym<T, D>{};
      body.points.push_back(x, o.velocity.at(x), static_cast<T>(density) * volume, volume, stress,
                            place.cell);
      if constexpr (Extra.affine)
        body.points.motion.set(body.points.size() - 1, o.velocity.gradient(x, edge(place.cell)));
      body.initial_volume += static_cast<double>(volume);
    }
    places.clear();
  };
  for (Index c = 0; c < mesh.cell_count(); ++c) {
    if (!owns(c)) continue;
    if constexpr (is_simplex_mesh<M>) {
      if (!recipe.region.test && !std::ranges::count(numbers, mesh.region(c))) continue;
    }
    auto of_cell = initial_points(mesh, c, per_cell, o.even);
    const auto parts = cell_parts(mesh, c, recipe.region, of_cell, per_cell, o.even, clear);
    jitter_points(mesh, c, o.jitter, o.seed, of_cell, per_cell, o.even);
    const T share = mesh.volume(c) / static_cast<T>(of_cell.size());
    for (std::size_t p = 0; p < of_cell.size(); ++p) {
      const auto& x = of_cell[p];
      if (!parts.empty() && parts[p].share > 0) {
        const double volume =
            parts[p].share * static_cast<double>(share * K::thickness(point_at(parts[p].centre)));
        body.region_volume += volume;
        if (o.exact_volume && !parts[p].whole)
          places.push_back({parts[p].centre, volume, c, parts[p].share < 0.1});
      }
      if (o.exact_volume && !parts.empty() ? !parts[p].whole
                                           : recipe.region.test && !recipe.region.contains(x))
        continue;
      places.push_back({in_space<T, D>(x), static_cast<double>(share * K::thickness(x)), c});
      if (parts.empty()) body.region_volume += places.back().volume;
    }
    if (!o.exact_volume) fill_places();
  }
  if (o.exact_volume) {
    detail::join_slivers(places, D, edge, [&](const detail::SpacePosition& x, Index near) {
      return mesh.walk(point_at(x), near);
    });
    fill_places();
  }
  require(body.points.size() > 0 || o.may_be_empty || !Owns::is_whole, "fill: points", body.points.size(),
          "the region holds no point of the mesh");
  require(body.points.size() < none, "fill: points", body.points.size(), "must be fewer than 2^32");
  detail::begin_history(body.points, o);
  body.points.reserve_spare();
  body.cells.build(body.points.cell, mesh.cell_count());
  return body;
}
template <class K, ExtraColumns Extra = ExtraColumns{}, class M, class L, Name name, class Region>
auto make_body(const M& mesh, const Fill<L, name, Region>& recipe, const Ground& ground = {}) {
  return make_body<K, Extra>(mesh, recipe.template erased<M>(), OwnsAllCells{}, ground);
}

}  // namespace arenite::inline ARENITE_INSTRUCTION_SET
