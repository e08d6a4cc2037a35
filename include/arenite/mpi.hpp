// Tiles on many machines, by MPI. Needs its headers and library: the target arenite::mpi.
#pragma once
// SPDX-License-Identifier: BSD-3-Clause

#include <arenite/tiles.hpp>
#include <arenite/tiles/mpi_world.hpp>
