// Cold functions of ground.hpp.
#pragma once
// SPDX-License-Identifier: BSD-3-Clause

#include <algorithm>
#include <cmath>

#include <arenite/core/warning.hpp>
#include <arenite/warnings/ground.hpp>

namespace arenite::inline ARENITE_INSTRUCTION_SET {
namespace shared_detail {

ARENITE_COLD bool begin_grounds(std::span<GroundFill> fills, std::size_t dimensions) {
  constexpr double inf = std::numeric_limits<double>::infinity();
  bool any = false;
  for (GroundFill& fill : fills) {
    any = any || fill.is_geostatic();
    fill.layer.lower = {-inf, -inf, -inf};
    fill.layer.upper = {inf, inf, inf};
    for (std::size_t k = 0; k < dimensions && fill.region->test; ++k)
      fill.layer.lower[k] = fill.region->lower[k], fill.layer.upper[k] = fill.region->upper[k];
  }
  return any;
}

ARENITE_COLD std::vector<Ground> grounds_of(std::span<const GroundFill> fills, const Ground& common,
                                            double close) {
  std::vector<Ground> grounds(fills.size());
  const std::size_t vertical = common.axis();
  for (std::size_t f = 0; f < fills.size(); ++f) {
    if (!fills[f].is_geostatic()) continue;
    grounds[f] = common;
    const auto& own = fills[f].layer;
    for (std::size_t other = 0; other < fills.size(); ++other) {
      const auto& layer = fills[other].layer;
      if (other == f || !fills[other].is_geostatic()) continue;
      if (common.gravity[vertical] < 0 ? layer.lower[vertical] >= own.upper[vertical] - close
                                       : layer.upper[vertical] <= own.lower[vertical] + close)
        grounds[f].above.push_back(layer);
    }
  }
  return grounds;
}

}  // namespace shared_detail
}  // namespace arenite::inline ARENITE_INSTRUCTION_SET
