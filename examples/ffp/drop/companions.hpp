// The error bar of a drop, in numbers: the drops around it, and the parts of the uncertainty that they give.
// Nothing here runs anything.
#pragma once

#include <algorithm>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "../options/option_table.hpp"
#include "barred_result.hpp"

namespace arenite::ffp {

/// A drop beside the one that was asked for.
struct Companion {
  std::string name;  ///< and that of its folder
  DropOptions options;
};

/// Sizes of the coarser cells, over the drop's.
inline constexpr double coarsest_ratio = 2, coarse_ratio = 1.41;

/// Half of the distance between the two contact surfaces that give the part of the contact, over the
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
std::span<const int> point_counts(const DropOptions& o);

/// Counts of points on both sides of `n`, at least a factor of 1.5 away; both on one side where the table
/// ends.
std::vector<int> other_counts(std::span<const int> counts, int n);

/// The drops that give the uncertainty of one, in the order in which they run: the cheapest first.
std::vector<Companion> companions_of(const DropOptions& drop);

/// The error bar of one result. `value`: of the drop; `of(name)`: of a companion, nothing if it has none. A
/// part is unknown if a drop that it needs has no result.
///
///   cells           `convergence` of the drop and those at 1.41 and 2 times its cells. Where these lie nearer
///                   each other than the drops of `points`, all at one size, do, that is chance and no
///                   convergence: the spread is then that of the latter
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
  std::vector<std::string> points{"cells-2"};
  for (const Companion& c : companions_of(drop))
    if (c.name.starts_with("points-") || c.name.starts_with("jitter-")) points.push_back(c.name);
  const auto of_points = all_of(points);
  if (coarse && of_points)
    if (const double spread = 2 * half_spread(*of_points);
        spread > 2 * half_spread({value, (*coarse)[0], (*coarse)[1]})) {
      result.cells->converged = false;
      result.cells->uncertainty =
          std::max(result.cells->uncertainty, ConvergenceRule{}.spread_factor * spread);
    }
  result.uncertainty.add("cells", coarse ? std::optional{result.cells->uncertainty} : std::nullopt);
  add("contact_offset", {"offset-in", "offset-out"}, 1);
  add("points", points, 1);
  add("flip_time", {"cells-1.41", "flip-time"}, 2);
  return result;
}

}  // namespace arenite::ffp
