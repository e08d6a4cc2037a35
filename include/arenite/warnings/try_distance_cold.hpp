// Cold functions of try_distance.hpp.
#pragma once
// SPDX-License-Identifier: BSD-3-Clause

#include <algorithm>
#include <cmath>

#include <arenite/core/warning.hpp>
#include <arenite/warnings/try_distance.hpp>

namespace arenite::inline ARENITE_INSTRUCTION_SET::shared_detail {

ARENITE_COLD std::vector<Index> spread_numbers(std::size_t size, std::size_t most) {
  std::vector<Index> all(std::min(size, most));
  for (std::size_t k = 0; k < all.size(); ++k)
    all[k] = static_cast<Index>(size <= most ? k : static_cast<std::size_t>(spread(k) * double(size)));
  return all;
}

ARENITE_COLD std::vector<double> tried_distances(const AnyDistance& distance,
                                                 const std::vector<AnyDistance::Position>& places) {
  std::vector<double> d(places.size());
  distance.at(places, d.data());
  for (std::size_t k = 0; k < d.size(); ++k)
    if (std::isnan(d[k])) throw error(refused_distance(places[k], d[k]));
  return d;
}

ARENITE_COLD double median_gradient(const AnyDistance& distance,
                                    const std::vector<AnyDistance::Position>& places,
                                    const std::vector<double>& sizes, const std::vector<double>& at_places,
                                    std::size_t dim) {
  constexpr std::size_t most = 64;
  std::vector<std::size_t> nearest;
  for (std::size_t k = 0; k < places.size(); ++k)
    if (std::isfinite(at_places[k])) nearest.push_back(k);
  std::sort(nearest.begin(), nearest.end(),
            [&](std::size_t a, std::size_t b) { return std::abs(at_places[a]) < std::abs(at_places[b]); });
  nearest.resize(std::min(nearest.size(), most));
  std::vector<AnyDistance::Position> beside;
  for (const std::size_t k : nearest)
    for (std::size_t i = 0; i < dim; ++i)
      for (const double sign : {1.0, -1.0}) {
        beside.push_back(places[k]);
        beside.back()[i] += sign * 1e-4 * sizes[k];
      }
  const auto d = tried_distances(distance, beside);
  std::vector<double> gradients;
  for (std::size_t n = 0; n < nearest.size(); ++n) {
    double sum = 0;
    for (std::size_t i = 0; i < dim; ++i) {
      const double difference = d[2 * (dim * n + i)] - d[2 * (dim * n + i) + 1];
      sum += difference * difference;
    }
    const double gradient = std::sqrt(sum) / (2e-4 * sizes[nearest[n]]);
    if (std::isfinite(gradient)) gradients.push_back(gradient);
  }
  if (gradients.empty()) return 1;
  std::sort(gradients.begin(), gradients.end());
  const double median = gradients[gradients.size() / 2];
  const double unit = std::pow(10, std::floor(std::log10(median)) - 3);  // differences have round-off
  return median > 0 ? unit * std::round(median / unit) : 0;
}

ARENITE_COLD void try_distance_at(const AnyDistance& distance, const MeshPlaces& close,
                                  const std::string& body, std::size_t dim) {
  const auto d = tried_distances(distance, close.places);
  const double gradient = median_gradient(distance, close.places, close.sizes, d, dim);
  if (!(gradient > 0.8 && gradient < 1.25))
    warn(joined_text(
        {"rigid body ", body, ": the gradient of its distance is ", gradient,
         " near its surface (a median), not 1: the distance must be in m, as the position is, and "
         "that to the nearest place of the surface"}));
}

}  // namespace arenite::inline ARENITE_INSTRUCTION_SET::shared_detail
