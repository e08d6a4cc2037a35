// Definitions of all cold functions (core/cold.hpp), for one unit of a program whose others are compiled with ARENITE_COLD_LIBRARY: that of
// the target arenite::cold, or one of your own.
#pragma once
// SPDX-License-Identifier: BSD-3-Clause

#if defined(ARENITE_HAS_COLD) && !ARENITE_HAS_COLD
#error "arenite/cold.hpp: include it before other headers of the library"
#endif
#define ARENITE_COLD_HERE

#include <arenite/boundary/constraints.hpp>
#include <arenite/boundary/reactions.hpp>
#include <arenite/boundary/walls.hpp>
#include <arenite/core/error.hpp>
#include <arenite/core/linear_solve.hpp>
#include <arenite/core/vector_argument.hpp>
#include <arenite/core/warning.hpp>
#include <arenite/fill/cell_parts.hpp>
#include <arenite/fill/cell_points.hpp>
#include <arenite/fill/filling.hpp>
#include <arenite/fill/initial_stress.hpp>
#include <arenite/fill/initial_velocity.hpp>
#include <arenite/fill/jitter.hpp>
#include <arenite/io/input_file.hpp>
#include <arenite/io/output_file.hpp>
#include <arenite/io/pvd.hpp>
#include <arenite/io/state_file.hpp>
#include <arenite/io/vtu.hpp>
#include <arenite/law/elasticity.hpp>
#include <arenite/law/frictional.hpp>
#include <arenite/load/node_force.hpp>
#include <arenite/mesh/blocks.hpp>
#include <arenite/mesh/cartesian_grid.hpp>
#include <arenite/observe/vtu.hpp>
#include <arenite/parallel/loop.hpp>
#include <arenite/particles/cell_list.hpp>
#include <arenite/particles/measures.hpp>
#include <arenite/rigid/body/past_walls.hpp>
#include <arenite/rigid/with_matter/contact_balance.hpp>
#include <arenite/run/progress.hpp>
#include <arenite/run/saved_state.hpp>
#include <arenite/scene/finish.hpp>
#include <arenite/warnings/ground.hpp>
#include <arenite/warnings/ground_at_rest.hpp>
#include <arenite/warnings/new_scene.hpp>
#include <arenite/warnings/step_check.hpp>
#include <arenite/warnings/try_distance.hpp>
#include <arenite/watch/watch.hpp>
#include <arenite/watch/watched_energy.hpp>
