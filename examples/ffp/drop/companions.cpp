#include "companions.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace arenite::ffp {

std::span<const int> point_counts(const DropOptions& o) {
  if (o.in_space()) return space_points;
  if (o.on_grid()) return grid_points;
  if (o.kinematics == Kinematics::slice) return tetrahedron_points;
  return triangle_points;
}

std::vector<int> other_counts(std::span<const int> counts, int n) {
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

std::vector<Companion> companions_of(const DropOptions& drop) {
  DropOptions base = drop;
  base.error_bar = base.resume = false;
  base.quiet = base.is_companion = true;
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

}  // namespace arenite::ffp
