// Cold functions of filling.hpp.
#pragma once
// SPDX-License-Identifier: BSD-3-Clause

#include <algorithm>
#include <cmath>

#include <arenite/fill/filling.hpp>

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
