// Body: points that share a law, and the list of which cell holds which of them.
#pragma once

#include <cmath>
#include <limits>
#include <optional>

#include <arenite/kinematics/kinematics.hpp>
#include <arenite/mesh/mesh.hpp>
#include <arenite/particles/cell_list.hpp>
#include <arenite/particles/cell_points.hpp>
#include <arenite/particles/cell_sums.hpp>
#include <arenite/particles/points.hpp>
#include <arenite/particles/region.hpp>

namespace arenite::inline ARENITE_INSTRUCTION_SET {

/// Initial stress of level ground at rest: vertical stress from the weight above, horizontal stress k0 times
/// that.
struct Geostatic {
  double surface = std::numeric_limits<double>::quiet_NaN();  ///< height of the free surface along `axis`, m
  double k0 = std::numeric_limits<double>::quiet_NaN();       ///< horizontal over vertical stress, -
  double gravity = 9.81;                                      ///< m/s2
  int axis = 1;                                               ///< vertical axis
};

struct FillOptions {
  int per_cell = 4;                   ///< points a cell or an element
  std::array<double, 3> velocity{};   ///< initial velocity, m/s
  std::optional<Geostatic> stress{};  ///< initial stress; none: unstressed
};

/// What `fill` returns: a region, a law and how to fill; the scene makes a `Body` of it, once it knows the
/// mesh.
template <class Region, class L>
struct Fill {
  Region region;
  L law;
  FillOptions options;
};

/// Fills a region with points of a law. A region that catches no point is refused when the scene is made.
template <class Region, class L>
Fill<Region, L> fill(Region region, L law, FillOptions options = {}) {
  return {std::move(region), std::move(law), options};
}

/// Points of one law in a mesh over scalar T.
template <class L, real T, int D, ExtraColumns Extra = ExtraColumns{}>
struct Body {
  static_assert(
      constitutive_law<L, T, D>,
      "Body: the law must provide History, density(), wave_modulus(), update(stress, increment, history) and "
      "elastic_energy(stress); see arenite/law/law.hpp");
  static constexpr bool has_dilation = Points<T, D, L, Extra>::has_dilation;
  static constexpr bool knows_opening = arenite::knows_opening<L, T>;
  L law;
  Points<T, D, L, Extra> points;
  CellList cells;
  std::size_t lost = 0;                     ///< points that left the mesh and were removed
  double lost_mass = 0;                     ///< their mass, kg
  double initial_volume = 0;                ///< m3
  double opened_volume = 0;                 ///< voids that opened without stress, summed over all steps, m3
  bool finite = true;                       ///< sums over the points of the last step
  std::vector<CellList::Move> moves{};      ///< [points and guests] scratch of `relocate`
  std::vector<Index> move_count{};          ///< [blocks of cells] moves found in each
  std::vector<CellSums<T, D>> cell_sums{};  ///< [cells] from `scatter`; empty if the numerics need none
};

/// Makes the body of a recipe. Throws `error` if the region holds no point.
template <class K, ExtraColumns Extra = ExtraColumns{}, class M, class Region, class L>
auto make_body(const M& mesh, const Fill<Region, L>& recipe) {
  using T = typename M::scalar;
  constexpr int D = M::dimension;
  static_assert(region<Region, D>,
                "fill: the region must provide contains(position) in the scene's dimension, or be Cells");
  Body<L, T, D, Extra> body{recipe.law, {}, {}};
  const FillOptions& o = recipe.options;
  if (o.stress) {
    require(std::isfinite(o.stress->surface), "Geostatic.surface", o.stress->surface, "must be given");
    require(o.stress->k0 >= 0 && std::isfinite(o.stress->k0), "Geostatic.k0", o.stress->k0,
            "must be given, and not negative");
    require(std::isfinite(o.stress->gravity), "Geostatic.gravity", o.stress->gravity, "must be finite");
    require(o.stress->axis >= 0 && o.stress->axis < D, "Geostatic.axis", o.stress->axis,
            "must be an axis of the scene");
  }
  Vec<T, D> velocity;
  for (std::size_t k = 0; k < 3; ++k) {
    require(std::isfinite(o.velocity[k]), "FillOptions.velocity", o.velocity[k], "must be finite");
    if (k < D)
      velocity[static_cast<int>(k)] = static_cast<T>(o.velocity[k]);
    else
      require(o.velocity[k] == 0, "FillOptions.velocity", o.velocity[k],
              "must be zero along an axis that the scene does not have");
  }
  for (Index c = 0; c < mesh.cell_count(); ++c) {
    if constexpr (std::same_as<Region, Cells>) {
      static_assert(is_simplex_mesh<M>,
                    "fill: Cells names regions of a simplex mesh; use a Box or Inside on a grid");
      bool named = false;
      for (const auto& name : recipe.region.regions)
        named = named || mesh.region(c) == mesh.region_number(name);
      if (!named) continue;
    }
    const auto places = initial_points(mesh, c, o.per_cell);
    const T share = mesh.volume(c) / static_cast<T>(places.size());
    for (const auto& x : places) {
      if constexpr (!std::same_as<Region, Cells>)
        if (!recipe.region.contains(Vec<double, D>(x.template cast<double>()))) continue;
      const T volume = share * K::thickness(x);
      Sym<T, D> stress{};
      if (o.stress) {
        const auto vertical = static_cast<std::size_t>(o.stress->axis);
        const double depth = o.stress->surface - static_cast<double>(x[o.stress->axis]);
        const double pressure = body.law.density() * o.stress->gravity * std::max(0.0, depth);
        for (std::size_t k = 0; k < 3; ++k)
          stress[k] = static_cast<T>(-pressure * (k == vertical ? 1.0 : o.stress->k0));
      }
      body.points.push_back(x, velocity, static_cast<T>(body.law.density()) * volume, volume, stress, c);
      body.initial_volume += static_cast<double>(volume);
    }
  }
  require(body.points.size() > 0, "fill: points", body.points.size(),
          "the region holds no point of the mesh");
  require(body.points.size() < none, "fill: points", body.points.size(), "must be fewer than 2^32");
  body.points.reserve_spare();
  body.cells.build(body.points.cell, mesh.cell_count());
  return body;
}

}  // namespace arenite::inline ARENITE_INSTRUCTION_SET
