// Deal tiles: which rank has which tile, at the start and after points have gathered.
#pragma once
// SPDX-License-Identifier: BSD-3-Clause

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <utility>
#include <vector>

#include <arenite/core/error.hpp>

namespace arenite::inline ARENITE_INSTRUCTION_SET {

/// [tiles] the rank of each tile: as many in a row for each, or one more. Throws `error` for fewer tiles than ranks.
inline std::vector<int> assign_tiles(int tiles, int ranks) {
  require(tiles >= ranks, "tiles", tiles, {"must not be less than the number of ranks, ", ranks});
  std::vector<int> rank;
  for (int t = 0; t < tiles; ++t) rank.push_back(static_cast<int>(static_cast<long long>(t) * ranks / tiles));
  return rank;
}

/// The largest load of a rank over the mean load. `rank_of`, `weight`: [tiles].
inline double imbalance(const std::vector<int>& rank_of, const std::vector<double>& weight, int ranks) {
  std::vector<double> load(static_cast<std::size_t>(ranks));
  for (std::size_t t = 0; t < weight.size(); ++t) load[static_cast<std::size_t>(rank_of[t])] += weight[t];
  const double all = std::accumulate(load.begin(), load.end(), 0.0);
  return all > 0 ? std::ranges::max(load) * ranks / all : 1;
}

/// [tiles] the ranks of tiles that weigh something else now: while the heaviest has more than `most` times the mean, it gives the lightest
/// one a tile, or swaps one with it, so that the heavier of the two has the least. Tile 0 stays where it is, for it writes what is of the
/// whole, and each rank keeps a tile.
inline std::vector<int> reassign_tiles(std::vector<int> rank_of, const std::vector<double>& weight, int ranks,
                                       double most) {
  std::vector<double> load(static_cast<std::size_t>(ranks));
  std::vector<int> count(load.size());
  for (std::size_t t = 0; t < weight.size(); ++t) {
    load[static_cast<std::size_t>(rank_of[t])] += weight[t];
    ++count[static_cast<std::size_t>(rank_of[t])];
  }
  const double mean = std::accumulate(load.begin(), load.end(), 0.0) / ranks;
  for (;;) {
    const auto heavy = static_cast<std::size_t>(std::ranges::max_element(load) - load.begin()),
               light = static_cast<std::size_t>(std::ranges::min_element(load) - load.begin());
    if (load[heavy] <= most * mean) return rank_of;
    constexpr std::size_t nothing = static_cast<std::size_t>(-1);
    double least = load[heavy] * (1 - 1e-12);
    std::pair<std::size_t, std::size_t> best{nothing, nothing};  // there, and back
    const auto look_at = [&](std::size_t there, std::size_t back, double given) {
      const double heavier = std::max(load[heavy] - given, load[light] + given);
      if (heavier < least) {
        least = heavier;
        best = {there, back};
      }
    };
    for (std::size_t t = 1; t < weight.size(); ++t) {
      if (static_cast<std::size_t>(rank_of[t]) != heavy) continue;
      if (count[heavy] > 1) look_at(t, nothing, weight[t]);
      for (std::size_t s = 1; s < weight.size(); ++s)
        if (static_cast<std::size_t>(rank_of[s]) == light) look_at(t, s, weight[t] - weight[s]);
    }
    if (best.first == nothing) return rank_of;
    const auto give = [&](std::size_t t, std::size_t from, std::size_t to) {
      rank_of[t] = static_cast<int>(to);
      load[from] -= weight[t];
      load[to] += weight[t];
      --count[from];
      ++count[to];
    };
    give(best.first, heavy, light);
    if (best.second != nothing) give(best.second, light, heavy);
  }
}

}  // namespace arenite::inline ARENITE_INSTRUCTION_SET
