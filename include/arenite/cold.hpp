// Definitions of all cold functions (core/cold.hpp), for one unit of a program whose others are compiled with ARENITE_COLD_LIBRARY: that of
// the target arenite::cold, or one of your own.
#pragma once
// SPDX-License-Identifier: BSD-3-Clause

#include <arenite/boundary/constraints_cold.hpp>
#include <arenite/boundary/reactions_cold.hpp>
#include <arenite/boundary/walls_cold.hpp>
#include <arenite/core/error_cold.hpp>
#include <arenite/core/linear_solve_cold.hpp>
#include <arenite/core/vector_argument_cold.hpp>
#include <arenite/core/warning_cold.hpp>
#include <arenite/fill/cell_parts_cold.hpp>
#include <arenite/fill/cell_points_cold.hpp>
#include <arenite/fill/filling_cold.hpp>
#include <arenite/fill/initial_stress_cold.hpp>
#include <arenite/fill/initial_velocity_cold.hpp>
#include <arenite/fill/jitter_cold.hpp>
#include <arenite/io/input_file_cold.hpp>
#include <arenite/io/output_file_cold.hpp>
#include <arenite/io/pvd_cold.hpp>
#include <arenite/io/state_file_cold.hpp>
#include <arenite/io/vtu_cold.hpp>
#include <arenite/law/elasticity_cold.hpp>
#include <arenite/law/frictional_cold.hpp>
#include <arenite/load/node_force_cold.hpp>
#include <arenite/mesh/blocks_cold.hpp>
#include <arenite/mesh/cartesian_grid_cold.hpp>
#include <arenite/observe/vtu_cold.hpp>
#include <arenite/parallel/loop_once.hpp>
#include <arenite/particles/cell_list_cold.hpp>
#include <arenite/particles/measures_cold.hpp>
#include <arenite/rigid/body/past_walls_cold.hpp>
#include <arenite/rigid/with_matter/contact_balance_cold.hpp>
#include <arenite/run/progress_cold.hpp>
#include <arenite/run/saved_state_cold.hpp>
#include <arenite/scene/finish_cold.hpp>
#include <arenite/warnings/ground_at_rest_cold.hpp>
#include <arenite/warnings/ground_cold.hpp>
#include <arenite/warnings/new_scene_cold.hpp>
#include <arenite/warnings/step_check_cold.hpp>
#include <arenite/warnings/try_distance_cold.hpp>
#include <arenite/watch/watch_cold.hpp>
#include <arenite/watch/watched_energy_cold.hpp>
