// The error bar of a drop, in numbers: the drops around it, and the parts of the uncertainty that they tell.
// Nothing here runs anything.
#pragma once

#include <algorithm>
#include <cmath>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include <arenite/study/convergence.hpp>
#include <arenite/study/uncertainty.hpp>

#include "../options/option_table.hpp"

namespace arenite::ffp {

/// A drop beside the one that was asked for.
struct Companion {
  std::string name;  ///< and that of its folder
  DropOptions options;
};

/// Sizes of the coarser cells, over the drop's.
inline constexpr double coarsest_ratio = 2, coarse_ratio = 1.41;

/// Half of the distance between the two surfaces that the sand meets for the part of the contact, over the
/// cell at the cone. Contact acts at nodes of the surface as soon as a point is in a cell beside it: up to
/// half a cell too early. The two surfaces lie that far apart.
inline constexpr double offset_share = 0.25;

/// Share of their sub-cells within which jittered points are moved: all of it, so that nothing of the lattice
/// is left but one point a sub-cell.
inline constexpr double jitter_share = 1;

/// Time of the share of FLIP where the drop has none, s: that of a drop. A shorter one acts within the peak.
/// A drop that has one is run with twice of it.
inline constexpr double other_flip_time = 0.1;

/// Numbers of points that an element of the drop's sand can have.
inline std::span<const int> point_counts(const DropOptions& o) {
  if (o.in_space()) return space_points;
  if (o.on_grid()) return grid_points;
  if (o.kinematics == Kinematics::slice) return tetrahedron_points;
  return triangle_points;
}

/// Counts of points on both sides of `n`, at least a factor of 1.5 away; both on one side where the table
/// ends.
inline std::vector<int> other_counts(std::span<const int> counts, int n) {
  std::vector<int> fewer, more;  // the nearest first
  for (int from = n; const int c : counts)
    if (2 * c >= 3 * from) more.push_back(from = c);
  int from = n;
  for (auto c = counts.rbegin(); c != counts.rend(); ++c)
    if (3 * *c <= 2 * from) fewer.push_back(from = *c);
  std::vector<int> found;
  for (std::size_t i = 0; found.size() < 2 && i < std::max(fewer.size(), more.size()); ++i)
    for (const auto* side : {&fewer, &more})
      if (i < side->size() && found.size() < 2) found.push_back((*side)[i]);
  return found;
}

/// The drops that tell the uncertainty of one, in the order in which they run: the cheapest first.
inline std::vector<Companion> companions_of(const DropOptions& drop) {
  DropOptions base = drop;
  base.error_bar = base.resume = false;
  base.quiet = true;
  base.fields_every = 0;
  const auto coarser = [&](double ratio) {
    DropOptions o = base;
    o.cell = ratio * drop.cell_size();
    if (o.cell_at_cone) *o.cell_at_cone *= ratio;
    return o;
  };
  std::vector<Companion> all;
  const auto add = [&](const std::string& name, DropOptions o) {
    o.out += "/error-bar/" + name;
    o.name = "error-bar/" + name;
    all.push_back({name, std::move(o)});
  };
  add("cells-2", coarser(coarsest_ratio));
  for (const int count : other_counts(point_counts(drop), drop.points_in_element())) {
    DropOptions o = coarser(coarsest_ratio);
    o.points_per_element = count;
    add("points-" + std::to_string(count), o);
  }
  for (const int seed : {1, 2}) {
    DropOptions o = coarser(coarsest_ratio);
    o.jitter = jitter_share;
    o.jitter_seed = drop.jitter_seed + seed;
    add("jitter-" + std::to_string(seed), o);
  }
  add("cells-1.41", coarser(coarse_ratio));
  for (const auto& [name, sign] : {std::pair{"offset-in", -1}, {"offset-out", 1}}) {
    DropOptions o = coarser(coarse_ratio);
    o.contact_offset += sign * offset_share * drop.cell_at_cone.value_or(drop.cell_size());
    add(name, o);
  }
  DropOptions o = coarser(coarse_ratio);
  o.flip_time = drop.flip_time_constant() > 0 ? 2 * drop.flip_time_constant() : other_flip_time;
  add("flip-time", o);
  return all;
}

/// A result of a drop with its error bar.
struct BarredResult {
  double value = 0;
  std::optional<Convergence> cells;  ///< nothing: one of the coarser drops has no result
  Uncertainty uncertainty;           ///< parts "cells", "contact_offset", "points", "flip_time"

  bool converged() const { return cells && cells->converged; }
};

/// The error bar of one result. `value`: of the drop; `of(name)`: of a companion, nothing if it has none. A
/// part is unknown if a drop that it needs has no result.
///
///   cells           `convergence` of the drop and those at 1.41 and 2 times its cells
///   contact_offset  half of the difference between the offsets
///   points          half of the spread over counts of points and jitters, at twice the cells
///   flip_time       the difference that a time of the share of FLIP makes; all, for the drop is at one end
template <class Of>
BarredResult barred_result(const DropOptions& drop, double value, const Of& of) {
  BarredResult result;
  result.value = value;
  const auto all_of = [&](const std::vector<std::string>& names) {
    std::vector<double> values;
    for (const auto& name : names)
      if (const std::optional<double> v = of(name)) values.push_back(*v);
    return values.size() == names.size() ? std::optional{values} : std::nullopt;
  };
  const auto add = [&](const char* part, const std::vector<std::string>& names, double factor) {
    const auto values = all_of(names);
    result.uncertainty.add(part, values ? std::optional{factor * half_spread(*values)} : std::nullopt);
  };
  const auto coarse = all_of({"cells-1.41", "cells-2"});
  if (coarse)
    result.cells = convergence({{drop.cell_size(), value},
                                {coarse_ratio * drop.cell_size(), (*coarse)[0]},
                                {coarsest_ratio * drop.cell_size(), (*coarse)[1]}});
  result.uncertainty.add("cells", coarse ? std::optional{result.cells->uncertainty} : std::nullopt);
  add("contact_offset", {"offset-in", "offset-out"}, 1);
  std::vector<std::string> points{"cells-2"};
  for (const Companion& c : companions_of(drop))
    if (c.name.starts_with("points-") || c.name.starts_with("jitter-")) points.push_back(c.name);
  add("points", points, 1);
  add("flip_time", {"cells-1.41", "flip-time"}, 2);
  return result;
}

}  // namespace arenite::ffp
