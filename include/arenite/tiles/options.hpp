// How a scene is cut into tiles, and when they move between ranks.
#pragma once
// SPDX-License-Identifier: BSD-3-Clause

#include <vector>

#include <arenite/core/instruction_set.hpp>

namespace arenite::inline ARENITE_INSTRUCTION_SET {

/// How a mesh is cut.
struct TileOptions {
  int tiles =
      0;  ///< of the whole mesh; 0: one for each rank. Results have the same bits on any ranks for the same tiles
  std::vector<double> weights{};  ///< [cells] what a cell costs, -; empty: all the same
  std::vector<int> tile{};        ///< [cells] tile of each cell, in the place of `split_cells`
};

/// When a run moves tiles.
struct RebalanceOptions {
  int every = 50;      ///< steps, at least 1
  double most = 1.05;  ///< points of the fullest rank over the mean that are let be, at least 1
};

}  // namespace arenite::inline ARENITE_INSTRUCTION_SET
