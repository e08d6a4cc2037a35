// The cold functions of all headers, compiled once.
#include <arenite/core/error_cold.hpp>
#include <arenite/core/thread_pool.hpp>
#include <arenite/core/vector_argument_cold.hpp>
#include <arenite/core/warning_cold.hpp>
#include <arenite/law/elasticity_cold.hpp>
#include <arenite/law/frictional_cold.hpp>
#include <arenite/mesh/blocks_cold.hpp>
#include <arenite/mesh/cartesian_grid_cold.hpp>
#include <arenite/particles/cell_list_cold.hpp>
#include <arenite/particles/cell_parts_cold.hpp>
#include <arenite/particles/cell_points_cold.hpp>
#include <arenite/particles/filling_cold.hpp>
#include <arenite/particles/initial_stress_cold.hpp>
#include <arenite/particles/initial_velocity_cold.hpp>
#include <arenite/particles/jitter_cold.hpp>
#include <arenite/scene/ground_cold.hpp>
#include <arenite/scene/new_scene_warnings_cold.hpp>
