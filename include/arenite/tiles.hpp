// One scene as many: tiles of a simplex mesh, each stepped by a thread, on one machine or (arenite/mpi.hpp) on many.
#pragma once
// SPDX-License-Identifier: BSD-3-Clause

#include <arenite/tiles/assign_tiles.hpp>
#include <arenite/tiles/exact_sum.hpp>
#include <arenite/tiles/ranks.hpp>
#include <arenite/tiles/rebalance.hpp>
#include <arenite/tiles/run_of_tiles.hpp>
#include <arenite/tiles/saved_tiles.hpp>
#include <arenite/tiles/split_cells.hpp>
#include <arenite/tiles/tiled.hpp>
