// Body: points that share a law, and the list of the points of each cell.
#pragma once
// SPDX-License-Identifier: BSD-3-Clause

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include <arenite/core/name.hpp>
#include <arenite/fill/cell_parts.hpp>
#include <arenite/fill/cell_points.hpp>
#include <arenite/fill/filling.hpp>
#include <arenite/fill/jitter.hpp>
#include <arenite/fill/region.hpp>
#include <arenite/law/roles.hpp>
#include <arenite/mesh/kinematics.hpp>
#include <arenite/mesh/mesh.hpp>
#include <arenite/particles/cell_list.hpp>
#include <arenite/particles/cell_sums.hpp>
#include <arenite/particles/points.hpp>

namespace arenite::inline ARENITE_INSTRUCTION_SET {

/// The recipe that `fill` returns: a region, a law and how to fill; the scene makes a `Body` of it, once it
/// knows the mesh.
///
/// In the type of the scene only law and name remain: `Fill<MohrCoulomb<>>`.
template <class L, Name name = "", class Region = AnyRegion>
struct Fill {
  Region region;
  L law;
  FillOptions options;

  static constexpr std::string_view word = name.word();
  using TypeErased = Fill<L, name>;
  template <class M>
  TypeErased type_erased() const {
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
        return {AnyRegion{}, law, options};  // already reported
    }
  }
};

/// Fills a region with points of a law; `fill<"sand">(..)` gives the body a name. A region that catches no
/// point is refused when the scene is made.
template <Name name, class Region, class L>
Fill<L, name, Region> fill(Region region, L law, const FillOptions& options = {}) {
  return {std::move(region), std::move(law), options};
}
template <class Region, class L>
Fill<L, "", Region> fill(Region region, L law, const FillOptions& options = {}) {
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

namespace detail {

/// Gives the points the initial values of `FillOptions::history`. Throws `error` for one that the law's
/// history has no member for, or that is not finite.
template <class L, class T, int D, ExtraColumns E>
void begin_history(Points<T, D, L, E>& points, const FillOptions& options) {
  static constexpr auto& names = history_names<typename L::template History<T>>;
  for (const auto& [name, value_at] : options.history) {
    const std::size_t k = history_place(names, name);
    for (std::size_t p = 0; p < points.size(); ++p) {
      const double value = value_at(in_space<T, D>(points.position[p]));
      require(std::isfinite(value), {"FillOptions.history, ", name}, value, "must be finite");
      if constexpr (requires { &L::check_history; }) L::check_history(name, value);
      points.history[k][p] = static_cast<T>(value);
    }
  }
}

}  // namespace detail

/// Every cell may contain points: for a scene on the whole mesh.
struct OwnsAllCells {
  static constexpr bool is_whole = true;
  constexpr bool operator()(Index) const { return true; }
  constexpr std::uint64_t number(Index c) const { return c; }
};

/// Makes the body of a recipe, with points in the cells that `owns(cell)`; `ground`: of a geostatic stress.
/// Throws `error` if the region contains no point of the mesh, unless that is allowed.
template <class K, ExtraColumns Extra = ExtraColumns{}, class M, class L, Name name,
          class Owns = OwnsAllCells>
auto make_body(const M& mesh, const Fill<L, name>& recipe, const Owns& owns = {}, const Ground& ground = {}) {
  using T = typename M::scalar;
  constexpr int D = M::dimension;
  Body<L, T, D, Extra> body{recipe.law, {}, {}};
  const FillOptions& o = recipe.options;
  constexpr bool simplices = is_simplex_mesh<M>;
  const auto thickness = [](const Vec<T, D>& x) -> T { return K::thickness(x); };
  Filling<T, D> filling(o, recipe.region, recipe.law.density(), ground, simplices, thickness);
  const int per_cell = o.points_in_cell<M>();
  const auto numbers = region_numbers(mesh, recipe.region);
  const auto add_points = [&] {
    for (const auto& point : filling.points(Extra.affine)) {
      body.points.push_back(point.position, point.velocity, point.mass, point.volume, point.stress,
                            point.cell);
      if constexpr (Extra.affine) body.points.velocity_gradient.set(body.points.size() - 1, point.gradient);
    }
  };
  for (Index c = 0; c < mesh.cell_count(); ++c) {
    if (!owns(c)) continue;
    if constexpr (simplices) {
      if (!recipe.region.test && !mesh.is_in(c, numbers)) continue;
    }
    auto of_cell = initial_points(mesh, c, per_cell, o.even);
    const auto parts = cell_parts(mesh, c, recipe.region, of_cell, per_cell, o.even, filling.clear);
    jitter_points(mesh, c, owns.number(c), o.jitter, o.seed, of_cell, per_cell, o.even);
    filling.add_cell(c, mesh.volume(c), of_cell, parts);
    if (!o.exact_volume) add_points();
  }
  if (o.exact_volume) {
    filling.join_slivers(
        [&](const SpacePosition& x, Index close) { return mesh.walk(in_scene<D, T>(x), close); });
    add_points();
  }
  body.initial_volume = filling.initial_volume;
  body.region_volume = filling.region_volume;
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
  return make_body<K, Extra>(mesh, recipe.template type_erased<M>(), OwnsAllCells{}, ground);
}

}  // namespace arenite::inline ARENITE_INSTRUCTION_SET
